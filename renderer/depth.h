// The depth attachment and the depth test (Vulkan, "Depth Test"): D32_SFLOAT, framebuffer depth in [0, 1].
#pragma once

#include <vulkan/vulkan_core.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace fillrule::renderer {

// One value a pixel, row by row from the top left. The caller owns the values; without a depth attachment there are
// none.
struct DepthBuffer {
  std::span<float> values;
};

// VkCompareOp is a set of outcomes: bit 0 less, bit 1 equal, bit 2 greater.
static_assert(VK_COMPARE_OP_NEVER == 0 && VK_COMPARE_OP_LESS == 1 && VK_COMPARE_OP_EQUAL == 2 &&
              VK_COMPARE_OP_LESS_OR_EQUAL == (1 | 2) && VK_COMPARE_OP_GREATER == 4 &&
              VK_COMPARE_OP_NOT_EQUAL == (1 | 4) && VK_COMPARE_OP_GREATER_OR_EQUAL == (2 | 4) &&
              VK_COMPARE_OP_ALWAYS == (1 | 2 | 4));

// Whether the fragment's depth `op` the stored depth holds.
inline bool depth_passes(VkCompareOp op, float fragment, float stored) {
  const uint32_t outcome = fragment < stored ? 1U : (fragment == stored ? 2U : 4U);
  return (static_cast<uint32_t>(op) & outcome) != 0;
}

// What a D32_SFLOAT attachment stores. Snapping lets a pixel lie outside of the unsnapped triangle, where its plane
// may leave [0, 1]; a depth outside is clamped as lavapipe does (Vulkan leaves it open without depth clamping). -0
// becomes +0.
inline float depth_d32(double depth_framebuffer) {
  return static_cast<float>(std::min(std::max(0.0, depth_framebuffer), 1.0));
}

}  // namespace fillrule::renderer
