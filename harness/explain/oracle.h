// The oracle and the judge's replay of it, for parties of the same subpixel bits.
#pragma once

#include <cstdint>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "harness/explain/explanation.h"
#include "harness/judge/components.h"
#include "harness/judge/possibilities.h"
#include "reference/exact/expectation.h"

namespace fillrule::explain {

struct Oracle {
  uint32_t subpixel_bits;
  exact::Expectation expectation;
  judge::ValueCache values;
  judge::Replay replay;

  Oracle(const Case& test_case, uint32_t bits, judge::Replay::Rules rules)
      : subpixel_bits(bits),
        expectation(test_case, bits),
        values(test_case, expectation),
        replay(test_case, expectation, values, bits, rules) {}
};

// The depth, where there is any, and the components of all varyings of one party at a sample.
std::vector<Value> values_of(const Case& test_case, Oracle& oracle, const judge::Possibilities& possible,
                             const Planes& planes, size_t index);

// What the oracle says of each primitive near the sample, and of those in `shown`.
std::vector<PrimitiveFacts> primitives_of(const Case& test_case, const exact::Expectation& expectation, size_t index,
                                          uint32_t subpixel_bits, const std::vector<uint32_t>& shown);

}  // namespace fillrule::explain
