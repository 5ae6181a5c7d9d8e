// Positions of NDC and framebuffer space in clip space: the inverse of the perspective division and of the viewport
// transform (Vulkan specification, "Controlling the Viewport"), in double.
#pragma once

#include <array>

#include "cases/format/enums.h"
#include "cases/model/case.h"

namespace fillrule::format {

// x, y, z in the given space; w is clip space's.
using Position = std::array<double, 4>;

// clip: (x, y, z, w) itself. ndc: (x, y, z) * w. framebuffer: pixels and window depth through the viewport to NDC
// first, whose z begins at 0, or at -1 with negative_one_to_one; a viewport of one depth (min_depth = max_depth) has
// no inverse, and z becomes 0.5 in NDC.
Position clip_from(PositionSpace space, const Position& position, const RasterState& state);

}  // namespace fillrule::format
