// What there is to see of a case: drawn by our renderer, and worked out by the oracle.
#pragma once

#include <cstdint>

#include "cases/model/case.h"
#include "cases/model/result.h"

namespace fillrule::check {

struct Sight {
  uint64_t drawn = 0;         // samples that our renderer covers
  uint64_t allowed = 0;       // samples that, by the oracle, something must or may cover
  bool blank_passes = false;  // a picture on which nothing was drawn is without fault, ties and diamonds decided
  uint64_t coverage = 0;      // a digest of the picture's size and of the hits of every sample
  uint64_t picture = 0;       // a digest of that and of every other plane, to the bit
};

// An error where our renderer cannot draw the case.
Result<Sight> look_at(const Case& test_case);

}  // namespace fillrule::check
