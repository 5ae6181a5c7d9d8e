// Programs that give a colour: their fragments' inputs in lanes, and the packed attachment that takes the colours
// (Vulkan, "Interpolation decorations", "Conversion From Floating-Point to Normalized Fixed-Point").
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>

#include "renderer/interpolation.h"
#include "renderer/lanes.h"
#include "renderer/simd_vector.h"

namespace fillrule::renderer {

// R8G8B8A8_UNORM, red in the lowest byte: one value for each sample, row by row from the top left, the samples of a
// pixel side by side. The caller owns the values; without a colour attachment there are none.
struct ColorBuffer {
  std::span<uint32_t> values;
  std::optional<uint32_t> clear;  // what all of it is set to before the draw, which then need not read it
};

using Vec4 = std::array<float, 4>;

// A vec4, or one of as many primitives as there are lanes.
template <typename L>
using Color = std::array<typename L::Float, 4>;

// A vec4 over a primitive, or over as many as there are lanes: four functions that are linear in the window, of x and
// y in pixels from an anchor.
template <typename L = ScalarLanes>
struct VaryingPlanes {
  Color<L> at_anchor;
  Color<L> step_x;
  Color<L> step_y;
};

// The same of one number.
template <typename L = ScalarLanes>
struct VaryingPlane {
  typename L::Float at_anchor;
  typename L::Float step_x;
  typename L::Float step_y;
};

// What as many fragments as there are lanes have in common with their program: all of them of one primitive, or each
// of any of as many.
template <typename L>
struct FragmentLanes {
  typename L::Float x;  // of the pixels' centres, or of the sample under sample shading: pixels from the anchor
  typename L::Float y;
  typename L::Float w;  // clip space; smooth varyings are divided by it
  // Where varyings are those of several primitives: the lane of each one's primitive, or that of all of them.
  typename L::Int primitive{};
  uint32_t lane = 0;
  bool are_of_one = false;

  // Varyings of the fragments' primitive (M is ScalarLanes) or of several primitives.

  // A smooth one, perspective-correct.
  template <typename M>
  [[nodiscard, gnu::always_inline]] Color<L> smooth(const VaryingPlanes<M>& planes) const {
    const auto component = [&](size_t i) __attribute__((always_inline)) {
      return at(planes.at_anchor[i], planes.step_x[i], planes.step_y[i]) * w;
    };
    return {component(0), component(1), component(2), component(3)};
  }
  template <typename Value>
  [[nodiscard, gnu::always_inline]] Color<L> flat(const std::array<Value, 4>& value) const {
    return {own(value[0]), own(value[1]), own(value[2]), own(value[3])};
  }

  template <typename M>
  [[nodiscard, gnu::always_inline]] typename L::Float at(const VaryingPlane<M>& plane) const {
    return at(plane.at_anchor, plane.step_x, plane.step_y);
  }

 private:
  template <typename Value>
  [[nodiscard, gnu::always_inline]] typename L::Float at(const Value& at_anchor, const Value& step_x,
                                                         const Value& step_y) const {
    return own(at_anchor) + own(step_x) * x + own(step_y) * y;
  }

  // Of each fragment's own primitive.
  template <typename Value>
  [[nodiscard, gnu::always_inline]] typename L::Float own(const Value& value) const {
    if constexpr (std::is_same_v<Value, float>) {
      return L::all(value);
    } else if constexpr (std::is_same_v<Value, typename L::Float>) {
      return are_of_one ? L::all(value[lane]) : L::chosen(value, primitive);
    } else {
      return L::all(value[lane]);
    }
  }
};

// The plane of 1/w, likewise; meaningless where weights have to be constrained.
inline VaryingPlane<> reciprocal_w_plane(const PrimitiveInterpolation& interpolation, int32_t anchor_x,
                                         int32_t anchor_y) {
  const auto& [l0, l1, l2] = interpolation.per_w;
  return {.at_anchor = static_cast<float>(interpolation.reciprocal_w_at(anchor_x, anchor_y)),
          .step_x = static_cast<float>(l0.step_x + l1.step_x + l2.step_x),
          .step_y = static_cast<float>(l0.step_y + l1.step_y + l2.step_y)};
}

// The planes of value / w, for FragmentLanes::smooth(), of a primitive whose vertices have these values. The anchor
// is a pixel at or near the fragments that they are for; the sums are in double, so that only their result is
// rounded.
[[gnu::always_inline]] inline VaryingPlanes<> smooth_planes(const PrimitiveInterpolation& interpolation,
                                                            int32_t anchor_x, int32_t anchor_y, const Vec4& value0,
                                                            const Vec4& value1, const Vec4& value2) {
  using Values = SimdVector<double, sizeof(double) * 4>::Type;  // lane by lane a component
  const auto widened = [](const Vec4& value) __attribute__((always_inline)) {
    SimdVector<float, sizeof(Vec4)>::Type values;
    std::memcpy(&values, value.data(), sizeof values);
    return __builtin_convertvector(values, Values);
  };
  const Values a = widened(value0);
  const Values b = widened(value1);
  const Values c = widened(value2);
  const auto sum = [&](double of_a, double of_b, double of_c) __attribute__((always_inline)) {
    const auto rounded =
        __builtin_convertvector(of_a * a + of_b * b + of_c * c, SimdVector<float, sizeof(Vec4)>::Type);
    Vec4 result;
    std::memcpy(result.data(), &rounded, sizeof rounded);
    return result;
  };
  const double x = anchor_x - interpolation.anchor_x;
  const double y = anchor_y - interpolation.anchor_y;
  const auto& [l0, l1, l2] = interpolation.per_w;
  return {.at_anchor = sum(l0.at(x, y), l1.at(x, y), l2.at(x, y)),
          .step_x = sum(l0.step_x, l1.step_x, l2.step_x),
          .step_y = sum(l0.step_y, l1.step_y, l2.step_y)};
}

// Clamped to [0, 1], NaN to 0, and to the nearest of 256 codes, ties to even.
template <typename L>
[[gnu::always_inline]] inline typename L::Int packed_unorm8(const Color<L>& color) {
  // What is less than 0, and NaN, packed_bytes() takes for 0.
  const auto codes = [](const typename L::Float& value) __attribute__((always_inline)) {
    return L::lesser(L::all(1.0F), value) * L::all(255.0F);
  };
  return L::packed_bytes(codes(color[0]), codes(color[1]), codes(color[2]), codes(color[3]));
}

}  // namespace fillrule::renderer
