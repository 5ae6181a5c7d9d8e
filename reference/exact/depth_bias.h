// The depth biases that the specification allows for one polygon (Vulkan specification, "Depth Bias Computation"):
// o = dbclamp(m * slope factor + r * constant factor). README.md, "Depth", derives the ranges of m and r.
#pragma once

#include <vulkan/vulkan_core.h>

#include "cases/model/case.h"

namespace fillrule::exact {

// What the bias of a polygon depends on, depths and pixels in window space.
struct PolygonDepth {
  double gradient_x = 0;          // |dz/dx|, 1/pixel
  double gradient_y = 0;          // |dz/dy|
  double gradient_tolerance = 0;  // how far an implementation's may be from both together
  // The largest |z| that the polygon spans lies in between: clipped and not clipped.
  double least_depth = 0;
  double most_depth = 0;
};

// Any bias from low to high is right; float32 may miss either by the tolerance (infinite: not known).
struct BiasRange {
  double low = 0;
  double high = 0;
  double tolerance = 0;

  [[nodiscard]] double middle() const { return (low + high) / 2; }
  [[nodiscard]] double spread() const { return (high - low) / 2; }
};

BiasRange bias_range(const DepthBias& bias, VkFormat format, const PolygonDepth& polygon);

// The same for a line or a point that is no part of a polygon. It may be biased and need not be, and the slope is
// defined for triangles alone: anything from 0 to the given one is right.
BiasRange optional_bias_range(const DepthBias& bias, VkFormat format, const PolygonDepth& primitive);

}  // namespace fillrule::exact
