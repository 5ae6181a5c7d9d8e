// Positions of NDC and framebuffer space in clip space: the inverse of the perspective division and of the viewport
// transform (Vulkan specification, "Controlling the Viewport"), in double.
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>

#include "cases/format/enums.h"

namespace fillrule::format {

// x, y, z in the given space; w is clip space's.
using Position = std::array<double, 4>;

// clip: (x, y, z, w) itself. ndc: (x, y, z) * w. framebuffer: pixels and window depth through the viewport to NDC
// first; a viewport of one depth (min_depth = max_depth) has no inverse, and z becomes 0.5 in NDC.
Position clip_from(PositionSpace space, const Position& position, const VkViewport& viewport);

}  // namespace fillrule::format
