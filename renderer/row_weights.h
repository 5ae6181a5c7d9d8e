// The weights of a row of pixels at once: the same operations as PrimitiveInterpolation::weights_at() in each, so the
// same bytes, in loops that compilers translate for the vectors of the function that they are inlined into.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "renderer/coverage.h"
#include "renderer/interpolation.h"

namespace fillrule::renderer {

using RowOfWeights = std::array<std::array<double, kBlockSize>, 3>;  // of the three vertices
using RowOfValues = std::array<float, kBlockSize>;

class RowWeights {
 public:
  // Of the centres of kBlockSize pixels from (x, y) on.
  [[gnu::always_inline]] RowWeights(const PrimitiveInterpolation& interpolation, int32_t x, int32_t y)
      : w_(interpolation.w) {
    const double y_from_anchor = y - interpolation.anchor_y;
    for (size_t v = 0; v < 3; ++v) {
      for (int32_t i = 0; i < kBlockSize; ++i) {
        l_[v][static_cast<size_t>(i)] =
            interpolation.per_w[v].at(static_cast<double>(x + i - interpolation.anchor_x), y_from_anchor);
      }
    }
    for (size_t i = 0; i < kBlockSize; ++i) reciprocal_w_[i] = l_[0][i] + l_[1][i] + l_[2][i];
  }

  // False where a weight has to be constrained to the primitive: those pixels' weights are others.
  [[nodiscard, gnu::always_inline]] bool are_plausible() const {
    int64_t implausible = 0;
    for (size_t i = 0; i < kBlockSize; ++i) {
      const double greatest = std::max(std::max(std::abs(l_[0][i]), std::abs(l_[1][i])), std::abs(l_[2][i]));
      implausible += greatest <= PrimitiveInterpolation::kPlausible * reciprocal_w_[i] ? 0 : 1;
    }
    return implausible == 0;
  }

  [[nodiscard, gnu::always_inline]] RowOfWeights smooth() const {
    RowOfWeights weights;
    for (size_t i = 0; i < kBlockSize; ++i) {
      const double w_at = 1 / reciprocal_w_[i];
      for (size_t v = 0; v < 3; ++v) weights[v][i] = l_[v][i] * w_at;
    }
    return weights;
  }

  [[nodiscard, gnu::always_inline]] RowOfWeights noperspective() const {
    RowOfWeights weights;
    for (size_t v = 0; v < 3; ++v) {
      for (size_t i = 0; i < kBlockSize; ++i) weights[v][i] = l_[v][i] * w_[v];
    }
    return weights;
  }

 private:
  RowOfWeights l_;
  std::array<double, kBlockSize> reciprocal_w_;
  std::array<double, 3> w_;
};

// interpolate() for a row. False if a value came out infinite, which interpolate() may keep finite.
[[gnu::always_inline]] inline bool interpolate_row(float value0, float value1, float value2,
                                                   const RowOfWeights& weights, RowOfValues& values) {
  uint32_t infinite = 0;
  for (size_t i = 0; i < kBlockSize; ++i) {
    values[i] = static_cast<float>(weights[0][i] * double{value0} + weights[1][i] * double{value1} +
                                   weights[2][i] * double{value2});
    constexpr uint32_t kInfinity = 0x7F800000;
    infinite |= (std::bit_cast<uint32_t>(values[i]) & ~0x80000000U) == kInfinity ? 1U : 0U;
  }
  return infinite == 0;
}

}  // namespace fillrule::renderer
