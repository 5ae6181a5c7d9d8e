#include "renderer/outlines.h"

#include <algorithm>
#include <cmath>

namespace fillrule::renderer {
namespace {

int32_t snap_away(double coordinate, uint32_t subpixel_bits) {
  return static_cast<int32_t>(std::round(coordinate * (1U << subpixel_bits)));
}

FixedPosition operator+(const FixedPosition& a, const FixedPosition& b) {
  return {a.x_fixed + b.x_fixed, a.y_fixed + b.y_fixed};
}

FixedPosition operator-(const FixedPosition& a, const FixedPosition& b) {
  return {a.x_fixed - b.x_fixed, a.y_fixed - b.y_fixed};
}

}  // namespace

float effective_point_size(float point_size) {
  // std::max(a, b) is a unless a < b, which NaN never is.
  return std::min(std::max(kMinPointSize, point_size), kMaxPointSize);
}

FixedPosition snapped_end(const FramebufferPosition& position, uint32_t subpixel_bits) {
  return {snap_away(position.x, subpixel_bits), snap_away(position.y, subpixel_bits)};
}

FixedQuad point_outline(const FramebufferPosition& centre, float effective_size, uint32_t subpixel_bits) {
  const int32_t size = snap_away(effective_size, subpixel_bits);
  const FixedPosition low = snapped_end(centre, subpixel_bits) - FixedPosition{size / 2, size / 2};
  const FixedPosition high = low + FixedPosition{size, size};
  return {{low, {high.x_fixed, low.y_fixed}, high, {low.x_fixed, high.y_fixed}}};
}

std::optional<FixedQuad> line_outline(const FramebufferPosition& a, const FramebufferPosition& b, float width,
                                      uint32_t subpixel_bits) {
  // In float32, as lavapipe has it: the half width's rounding decides about samples.
  const float dx = static_cast<float>(a.x) - static_cast<float>(b.x);
  const float dy = static_cast<float>(a.y) - static_cast<float>(b.y);
  const float length_squared = dx * dx + dy * dy;
  if (length_squared == 0) {
    return std::nullopt;
  }
  const float scale = width * 0.5F / std::sqrt(length_squared);
  const FixedPosition aside{snap_away(-dy * scale, subpixel_bits), snap_away(dx * scale, subpixel_bits)};
  const FixedPosition from = snapped_end(a, subpixel_bits);
  const FixedPosition to = snapped_end(b, subpixel_bits);
  return FixedQuad{{from - aside, to - aside, to + aside, from + aside}};
}

}  // namespace fillrule::renderer
