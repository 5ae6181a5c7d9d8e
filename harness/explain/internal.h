// What the parts of this library share.
#pragma once

#include <string>
#include <string_view>

#include "harness/explain/explanation.h"
#include "reference/exact/expectation.h"

namespace fillrule::explain {

// Everything but whether it matters at the sample.
PrimitiveFacts facts_of(const Case& test_case, const exact::Expectation& expectation, uint32_t number, double x,
                        double y, uint32_t subpixel_bits);

// Explanation::reason, from all the rest.
std::string reason_of(const Explanation& explanation);

std::string_view word_for(judge::Verdict verdict);

// "12 subpixels", "0.31 subpixels", "1 subpixel".
std::string subpixels(double distance);

}  // namespace fillrule::explain
