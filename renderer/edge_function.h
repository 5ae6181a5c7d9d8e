// Edge functions in exact integers and the top-left rule (Vulkan, "Basic Polygon Rasterization"; Pineda 1988).
//
// Framebuffer coordinates, y down. A triangle is taken round so that its doubled area, hence all three edge functions
// inside, are positive. For sample p and the edge from a to b
//   E(p) = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)
// p is inside where E > 0, and where E = 0 on a top or a left edge. Subtracting 1 from E on all other edges makes
// both of them the one test E >= 0.
//
// Between pixel centres E changes by multiples of 2^subpixel_bits; so floor(E / 2^subpixel_bits) has the sign of E
// and steps by whole differences of coordinates: that is what EdgeFunction holds.
#pragma once

#include <cstdint>

#include "renderer/fixed_point.h"

namespace fillrule::renderer {

// Twice the signed area in subpixels squared; positive is clockwise as seen on the framebuffer (y down).
constexpr int64_t doubled_area(const FixedPosition& a, const FixedPosition& b, const FixedPosition& c) {
  return (int64_t{b.x_fixed} - a.x_fixed) * (int64_t{c.y_fixed} - a.y_fixed) -
         (int64_t{c.x_fixed} - a.x_fixed) * (int64_t{b.y_fixed} - a.y_fixed);
}

// The edge of a positively oriented triangle, by its direction: the interior is to the right of a left edge (which
// goes up) and below a top edge (horizontal, going right).
constexpr bool is_top_left(int32_t dx_fixed, int32_t dy_fixed) {
  return dy_fixed < 0 || (dy_fixed == 0 && dx_fixed > 0);
}

struct EdgeFunction {
  int64_t at_origin = 0;  // at the sample in pixel (0, 0); |at_origin| <= 2^61 / 2^subpixel_bits
  int32_t step_x = 0;     // a pixel to the right
  int32_t step_y = 0;     // a pixel down

  // Non-negative inside. |x|, |y| <= 2^15 px: at most 2^57 + 2 * 2^45.
  [[nodiscard]] constexpr int64_t at(int32_t x, int32_t y) const {
    return at_origin + int64_t{x} * step_x + int64_t{y} * step_y;
  }
};

// The edge from a to b for the sample at `sample_fixed` within each pixel, (half, half) being the centre.
constexpr EdgeFunction edge_function(const FixedPosition& a, const FixedPosition& b,
                                     const FixedPosition& sample_fixed, uint32_t subpixel_bits) {
  const int32_t dx = b.x_fixed - a.x_fixed;
  const int32_t dy = b.y_fixed - a.y_fixed;
  const int64_t value = int64_t{dx} * (int64_t{sample_fixed.y_fixed} - a.y_fixed) -
                        int64_t{dy} * (int64_t{sample_fixed.x_fixed} - a.x_fixed) - (is_top_left(dx, dy) ? 0 : 1);
  return {.at_origin = value >> subpixel_bits, .step_x = -dy, .step_y = dx};
}

}  // namespace fillrule::renderer
