// The depth attachment and the tests against it (Vulkan, "Depth Bounds Test", "Depth Test", "Depth Clamping"), for
// each sample; framebuffer depth in [0, 1].
#pragma once

#include <vulkan/vulkan_core.h>

#include <algorithm>
#include <cstdint>
#include <span>

#include "cases/model/case.h"

namespace fillrule::renderer {

// One value for each sample, row by row from the top left, the samples of a pixel side by side. The caller owns the
// values; without a depth attachment there are none. A fixed-point code of n bits is held as the float32 next to
// code / (2^n - 1): for 24 bits and less, different codes have different floats.
struct DepthBuffer {
  std::span<float> values;
  VkFormat format = VK_FORMAT_D32_SFLOAT;  // or D16_UNORM, X8_D24_UNORM_PACK32
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

// The greatest code, 2^n - 1, of a fixed-point format of n bits; 0 for a floating-point one.
constexpr uint32_t max_depth_code(VkFormat format) {
  switch (format) {
    case VK_FORMAT_D16_UNORM:
      return (1U << 16U) - 1;
    case VK_FORMAT_X8_D24_UNORM_PACK32:
      return (1U << 24U) - 1;
    default:
      return 0;
  }
}

// What an attachment whose greatest code is `max_code` holds of a depth within [0, 1]: the nearest code to the
// product in float32, ties to even, as the reference drivers have it.
inline float quantized_depth(uint32_t max_code, float depth_framebuffer) {
  if (max_code == 0) {
    return depth_framebuffer;
  }
  const float product = depth_framebuffer * static_cast<float>(max_code);
  constexpr double kNoFraction = 0x1.8p52;  // adding it rounds to nearest even
  const double code = (double{product} + kNoFraction) - kNoFraction;
  return static_cast<float>(code / max_code);
}

// From the depth of normalized device coordinates to the framebuffer's: z * scale + offset (Vulkan, "Controlling the
// Viewport").
struct DepthTransform {
  double scale = 1;
  double offset = 0;
};

inline DepthTransform depth_transform(const RasterState& state) {
  const double min = state.viewport.minDepth;
  const double max = state.viewport.maxDepth;
  if (state.negative_one_to_one) {
    return {.scale = (max - min) / 2, .offset = (max + min) / 2};
  }
  return {.scale = max - min, .offset = min};
}

// What happens to a fragment at a sample of the depth attachment.
class DepthStage {
 public:
  DepthStage(const RasterState& state, const DepthBuffer& buffer)
      // Without a depth attachment both tests pass.
      : test_(state.depth_test && !buffer.values.empty()),
        bounds_test_(state.depth_bounds.has_value() && !buffer.values.empty()),
        write_(state.depth_write),
        compare_(state.depth_compare),
        bounds_(state.depth_bounds.value_or(DepthBounds{})),
        max_code_(max_depth_code(buffer.format)) {
    if (state.depth_clamp) {
      const auto& [least, greatest] = std::minmax(state.viewport.minDepth, state.viewport.maxDepth);
      least_ = double{least} + 0.0;  // of -0, +0
      greatest_ = double{greatest};
    }
  }

  // Whether fragments are tested at all.
  [[nodiscard]] bool tests() const { return test_ || bounds_test_; }

  // Whether a fragment of this depth lands on a sample that holds `stored`; writes its own depth if it does.
  bool lands(double depth_framebuffer, float& stored) const {
    if (bounds_test_ && !(stored >= bounds_.min && stored <= bounds_.max)) {
      return false;
    }
    if (!test_) {
      return true;
    }
    const float depth = attachment_depth(depth_framebuffer);
    if (!depth_passes(compare_, depth, stored)) {
      return false;
    }
    if (write_) {
      stored = depth;
    }
    return true;
  }

  // As the attachment would hold it. Where depths are not clamped to the viewport's range they are clamped to [0, 1],
  // as the reference drivers do: snapping lets a pixel lie outside of the unsnapped triangle, and without depth
  // clipping all of it may (Vulkan leaves those values open). -0 becomes +0.
  [[nodiscard]] float attachment_depth(double depth_framebuffer) const {
    const double clamped = std::min(std::max(least_, depth_framebuffer), greatest_);
    return quantized_depth(max_code_, static_cast<float>(clamped));
  }

 private:
  bool test_;
  bool bounds_test_;
  bool write_;
  VkCompareOp compare_;
  DepthBounds bounds_;
  uint32_t max_code_;
  double least_ = 0;
  double greatest_ = 1;
};

}  // namespace fillrule::renderer
