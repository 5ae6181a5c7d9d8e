// Where the Vulkan specification says nothing of a vertex.
#pragma once

#include <vulkan/vulkan_core.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <span>

#include "cases/model/case.h"

namespace fillrule::exact {

// Above this, sums and differences of coordinates leave float32.
inline constexpr float kLargestCoordinate = FLT_MAX / 16;

inline bool coordinates_leave_float32(const ClipPosition& p, const VkViewport& viewport) {
  for (const float coordinate : p) {
    if (!std::isfinite(coordinate) || std::abs(coordinate) > kLargestCoordinate) return true;
  }
  const double w = std::abs(double{p[3]});
  if (w == 0) return p[0] == 0 && p[1] == 0 && p[2] == 0;  // the apex of the view volume projects to 0 / 0
  if (w < double{FLT_MIN}) return true;                    // denormal: 1 / w overflows, or w is flushed to zero
  return std::abs(double{p[0]}) * double{viewport.width} > w * double{FLT_MAX} ||
         std::abs(double{p[1]} * double{viewport.height}) > w * double{FLT_MAX} ||
         std::abs(double{p[2]}) > w * double{FLT_MAX};
}

// Vulkan lets denormals be flushed to zero, which moves such a primitive onto the near plane, where it is drawn.
inline bool near_plane_by_flushing(std::span<const ClipPosition> vertices) {
  return std::all_of(vertices.begin(), vertices.end(),
                     [](const ClipPosition& p) { return p[2] <= 0 && p[2] > -FLT_MIN; }) &&
         std::any_of(vertices.begin(), vertices.end(), [](const ClipPosition& p) { return p[2] < 0; });
}

}  // namespace fillrule::exact
