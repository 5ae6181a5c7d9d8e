// The weights of a row of pixels in lanes: the same operations as PrimitiveInterpolation::weights_at() in each, so
// the same bytes. L is a lane type (lanes.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "renderer/coverage.h"
#include "renderer/interpolation.h"
#include "renderer/lanes.h"

namespace fillrule::renderer {

// kBlockSize pixels, in as many vectors as they need.
template <typename L>
inline constexpr size_t kRowVectors = kBlockSize / L::kWidth;
template <typename L>
using RowOfDoubles = std::array<typename L::Double, kRowVectors<L>>;
template <typename L>
using RowOfWeights = std::array<RowOfDoubles<L>, 3>;  // of the three vertices
template <typename L>
using RowOfValues = std::array<typename L::Float, kRowVectors<L>>;

template <typename L>
class RowWeights {
 public:
  // Of the centres of the pixels from (x, y) on.
  [[gnu::always_inline]] RowWeights(const PrimitiveInterpolation& interpolation, int32_t x, int32_t y)
      : interpolation_(interpolation) {
    const double y_from_anchor = y - interpolation.anchor_y;
    for (size_t i = 0; i < kRowVectors<L>; ++i) {
      const int32_t x_from_anchor = x - interpolation.anchor_x + static_cast<int32_t>(i * L::kWidth);
      const auto xs = L::to_double(L::numbers() + x_from_anchor);
      for (size_t v = 0; v < 3; ++v) {
        const WindowPlane& plane = interpolation.per_w[v];
        l_[v][i] = L::all(plane.at_anchor) + L::all(plane.step_x) * xs + L::all(plane.step_y * y_from_anchor);
      }
      reciprocal_w_[i] = l_[0][i] + l_[1][i] + l_[2][i];
    }
  }

  // False where a weight has to be constrained to the primitive: those pixels' weights are others.
  [[nodiscard, gnu::always_inline]] bool are_plausible() const {
    for (size_t i = 0; i < kRowVectors<L>; ++i) {
      const auto greatest =
          L::greater(L::greater(L::magnitude(l_[0][i]), L::magnitude(l_[1][i])), L::magnitude(l_[2][i]));
      if (!L::all_at_most(greatest, L::all(PrimitiveInterpolation::kPlausible) * reciprocal_w_[i])) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard, gnu::always_inline]] RowOfWeights<L> smooth() const {
    RowOfWeights<L> weights;
    for (size_t i = 0; i < kRowVectors<L>; ++i) {
      const auto w_at = L::all(1.0) / reciprocal_w_[i];
      for (size_t v = 0; v < 3; ++v) {
        weights[v][i] = l_[v][i] * w_at;
      }
    }
    return weights;
  }

  [[nodiscard, gnu::always_inline]] RowOfWeights<L> noperspective() const {
    RowOfWeights<L> weights;
    for (size_t i = 0; i < kRowVectors<L>; ++i) {
      for (size_t v = 0; v < 3; ++v) {
        weights[v][i] = l_[v][i] * L::all(interpolation_.w[v]);
      }
    }
    return weights;
  }

 private:
  const PrimitiveInterpolation& interpolation_;
  RowOfWeights<L> l_;
  RowOfDoubles<L> reciprocal_w_;
};

// interpolate() for a row. False if a value came out infinite, which interpolate() may keep finite.
template <typename L>
[[nodiscard, gnu::always_inline]] inline bool interpolate_row(float value0, float value1, float value2,
                                                              const RowOfWeights<L>& weights,
                                                              RowOfValues<L>& values) {
  constexpr int32_t kMagnitude = 0x7FFFFFFF;
  constexpr int32_t kInfinity = 0x7F800000;
  bool has_infinity = false;
  for (size_t i = 0; i < kRowVectors<L>; ++i) {
    values[i] = L::to_float(weights[0][i] * L::all(double{value0}) + weights[1][i] * L::all(double{value1}) +
                            weights[2][i] * L::all(double{value2}));
    has_infinity = has_infinity || L::any((L::bits_of(values[i]) & kMagnitude) == kInfinity);
  }
  return !has_infinity;
}

}  // namespace fillrule::renderer
