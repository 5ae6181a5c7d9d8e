#include "reference/exact/latitude.h"

#include <algorithm>
#include <cmath>

namespace fillrule::exact {
namespace {

// The size of the largest coordinate that the viewport transform adds up.
double extent(float offset, float size) {
  return std::max(std::abs(double{offset}), std::abs(double{offset} + double{size}));
}

}  // namespace

Latitude latitude_of(const VkViewport& viewport, uint32_t subpixel_bits) {
  const double half_step = std::ldexp(0.5, -static_cast<int>(subpixel_bits));
  return {.x = half_step + 0x1p-22 * extent(viewport.x, viewport.width),
          .y = half_step + 0x1p-22 * extent(viewport.y, viewport.height)};
}

}  // namespace fillrule::exact
