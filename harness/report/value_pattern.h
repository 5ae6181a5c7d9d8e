// What a wrong depth or varying would be right as: another interpolation, another varying, a vertex's own value.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "cases/model/case.h"
#include "harness/explain/explanation.h"

namespace fillrule::report {

// Where a party's wrong value was seen.
struct WrongValue {
  const explain::Explanation* explanation = nullptr;
  size_t party = 0;  // index into Explanation::parties
};

// "interpolated without perspective correction"; none unless the value of every one of the samples, two at least, is
// just that. `name` is the value's name in explain::Value: "depth", "uv.x".
std::optional<std::string> pattern_of(const Case& test_case, const std::string& name,
                                      std::span<const WrongValue> seen);

}  // namespace fillrule::report
