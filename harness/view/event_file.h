// Recorded input, one event a line; README.md of this folder describes the format.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cases/model/result.h"
#include "harness/view/input.h"

namespace fillrule::view {

struct RecordedInput {
  uint32_t frame = 0;  // it is handled before this frame is drawn, counted from 0
  Input input;
  bool operator==(const RecordedInput&) const = default;
};

// In the order of the frames. Errors name line and column.
Result<std::vector<RecordedInput>> read_events(const std::string& path);
Result<std::vector<RecordedInput>> parse_events(std::string_view text, const std::string& file_label);

// What parse_events() makes the same of.
std::string write_events(const std::vector<RecordedInput>& events);

}  // namespace fillrule::view
