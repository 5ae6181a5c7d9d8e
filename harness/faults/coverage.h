// Which samples a primitive covers, asked one by one, in integers on the subpixel grid.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/faults/window.h"

namespace fillrule::faults {

// Where the samples of a pixel are, in sixteenths of a pixel from its top left corner (Vulkan specification,
// "Multisampling": the standard sample locations).
struct Location {
  int32_t x = 8;
  int32_t y = 8;
};
std::vector<Location> sample_locations(const Context& context);

// Subpixels.
Snapped sample_position(const Context& context, int32_t x, int32_t y, const Location& location);

// Whether the polygon covers the position. A ray to the left crosses the outline an odd number of times; its ends and
// those of edges are taken such that ties go by the top-left rule.
bool covers(const Context& context, const std::vector<Snapped>& outline, const Snapped& position);

}  // namespace fillrule::faults
