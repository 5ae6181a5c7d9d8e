// A small picture of a case in letters: what is wrong at each pixel. The origin is at the top left, x to the right
// and y down, in pixels.
#pragma once

#include <cstddef>
#include <string>

#include "cases/model/case.h"
#include "harness/run/suite_runner.h"
#include "harness/terminal/style.h"

namespace fillrule::terminal {

// At most so many characters in either direction.
inline constexpr size_t kMapLimit = 64;

// The map with a line above it that tells what part is shown and what the letters mean. Of a larger target only what
// is about the samples that are not as they should be is shown, and if that is too large still, each character stands
// for a square of pixels and shows the gravest of them. Empty if nothing is wrong.
std::string map_text(const Case& test_case, const run::Drawing& drawing, const Style& style);

}  // namespace fillrule::terminal
