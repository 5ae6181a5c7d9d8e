// Whoever is being judged, by name.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "cases/model/result.h"

namespace fillrule::run {

struct Candidate {
  std::string name;
  uint32_t subpixel_bits = 8;
  // Draws with so many threads, 0 for the number in the options. May be called by several threads at once.
  std::function<Result<Planes>(const Case&, uint32_t threads)> draw;
};

struct CandidateOptions {
  uint32_t subpixel_bits = 8;
  uint32_t threads = 1;  // that draw one case
};

// The candidates there are: "renderer". Any other name is an error that lists them.
Result<Candidate> make_candidate(const std::string& name, const CandidateOptions& options);

}  // namespace fillrule::run
