// The depth attachment and the tests against it (Vulkan, "Depth Bounds Test", "Depth Test", "Depth Clamping"), for
// each sample; framebuffer depth in [0, 1].
#pragma once

#include <vulkan/vulkan_core.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "cases/model/case.h"
#include "renderer/lanes.h"

namespace fillrule::renderer {

// One value for each sample, row by row from the top left, the samples of a pixel side by side. The caller owns the
// values; without a depth attachment there are none. A fixed-point code of n bits is held as the float32 next to
// code / (2^n - 1): for 24 bits and less, different codes have different floats.
struct DepthBuffer {
  std::span<float> values;
  VkFormat format = VK_FORMAT_D32_SFLOAT;  // or D16_UNORM, X8_D24_UNORM_PACK32
  std::optional<float> clear;              // as that of ColorBuffer; a value that the format has
};

// Whether the fragment's depth `op` the stored depth holds; "greater" is all that is neither less nor equal.
template <typename L = ScalarLanes>
[[gnu::always_inline]] inline typename L::Mask depth_passes(VkCompareOp op, const typename L::Float& fragment,
                                                            const typename L::Float& stored) {
  if (op == VK_COMPARE_OP_LESS) {
    return fragment < stored;
  }
  switch (op) {
    case VK_COMPARE_OP_EQUAL:
      return fragment == stored;
    case VK_COMPARE_OP_LESS_OR_EQUAL:
      return fragment <= stored;
    case VK_COMPARE_OP_GREATER:
      return L::negated(fragment <= stored);
    case VK_COMPARE_OP_NOT_EQUAL:
      return L::negated(fragment == stored);
    case VK_COMPARE_OP_GREATER_OR_EQUAL:
      return L::negated(fragment < stored);
    case VK_COMPARE_OP_ALWAYS:
      return L::mask_of(~0U);
    default:
      return L::mask_of(0);
  }
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
template <typename L = ScalarLanes>
[[gnu::always_inline]] inline typename L::Float quantized_depth(uint32_t max_code,
                                                                const typename L::Float& depth_framebuffer) {
  if (max_code == 0) {
    return depth_framebuffer;
  }
  const typename L::Float product = depth_framebuffer * L::all(static_cast<float>(max_code));
  const typename L::Double no_fraction = L::all(0x1.8p52);  // adding it rounds to nearest even
  const typename L::Double code = (L::to_double(product) + no_fraction) - no_fraction;
  return L::to_float(code / L::all(static_cast<double>(max_code)));
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
      least_ = least + 0.0F;  // of -0, +0
      greatest_ = greatest;
    }
    is_usual_ = test_ && !bounds_test_ && write_ && compare_ == VK_COMPARE_OP_LESS && max_code_ == 0;
  }

  // The test that most draws have: less, writing, floating-point.
  [[nodiscard]] bool is_usual() const { return is_usual_; }
  // Whether fragments are tested at all.
  [[nodiscard]] bool tests() const { return test_ || bounds_test_; }

  // Which of the fragments of these depths land on samples that hold `stored`, of those in `fragments`; those that do
  // write their depths to it.
  template <typename L = ScalarLanes>
  [[gnu::always_inline]] typename L::Mask lands(const typename L::Double& depth_framebuffer,
                                                typename L::Mask fragments, typename L::Float& stored) const {
    if (bounds_test_) {
      fragments &= stored >= L::all(bounds_.min);
      fragments &= stored <= L::all(bounds_.max);
    }
    if (!test_) {
      return fragments;
    }
    const typename L::Float depth = attachment_depth<L>(depth_framebuffer);
    fragments = fragments & depth_passes<L>(compare_, depth, stored);
    if (write_) {
      stored = fragments ? depth : stored;
    }
    return fragments;
  }

  // The same of the usual test, of what is stored from `stored` on. Bit by bit: which land.
  template <typename L>
  [[gnu::always_inline]] uint32_t land_as_usual(const typename L::Double& depth_framebuffer,
                                                const typename L::Some& fragments, float* stored) const {
    return L::store_lesser(fragments, clamped_depth<L>(depth_framebuffer), stored);
  }

  // Whether the usual test keeps all fragments of this depth and greater from samples whose depths are at most
  // `stored_limit`.
  [[nodiscard]] bool hides(double depth_framebuffer, float stored_limit) const {
    return clamped_depth<ScalarLanes>(depth_framebuffer) >= stored_limit;
  }

  // As the attachment would hold it. Where depths are not clamped to the viewport's range they are clamped to [0, 1],
  // as the reference drivers do: snapping lets a pixel lie outside of the unsnapped triangle, and without depth
  // clipping all of it may (Vulkan leaves those values open). -0 and NaN become the least depth. The ends of the
  // range are floats, so that rounding first changes nothing.
  template <typename L = ScalarLanes>
  [[nodiscard, gnu::always_inline]] typename L::Float attachment_depth(
      const typename L::Double& depth_framebuffer) const {
    return quantized_depth<L>(max_code_, clamped_depth<L>(depth_framebuffer));
  }

 private:
  template <typename L>
  [[nodiscard, gnu::always_inline]] typename L::Float clamped_depth(
      const typename L::Double& depth_framebuffer) const {
    return L::lesser(L::greater(L::to_float(depth_framebuffer), L::all(least_)), L::all(greatest_));
  }

  bool test_;
  bool bounds_test_;
  bool write_;
  bool is_usual_;
  VkCompareOp compare_;
  DepthBounds bounds_;
  uint32_t max_code_;
  float least_ = 0;
  float greatest_ = 1;
};

}  // namespace fillrule::renderer
