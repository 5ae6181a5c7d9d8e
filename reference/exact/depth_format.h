// What a depth format makes of a depth: the codes of the fixed-point ones (Vulkan specification, "Conversion From
// Floating-Point to Normalized Fixed-Point"). The specification permits either of the two closest codes and prefers
// the nearest.
#pragma once

#include <vulkan/vulkan_core.h>

namespace fillrule::exact {

// 2^n - 1 of a fixed-point format of n bits; 0 of a floating-point one, and without a format.
double largest_code(VkFormat format);

// Half the distance of two depths that the format has; 0 where it has all float32 numbers.
double half_step(VkFormat format);

// True if the depth is one that Planes::depth shows for some code.
bool is_depth_of(VkFormat format, float depth);

// The nearest one, as Planes::depth shows it.
float nearest_depth(VkFormat format, double depth);

// Depths from low to high. An empty range has low > high.
struct DepthRange {
  double low = 0;
  double high = 0;
};

// All that may be stored for depths in the range: the nearest alone, or either of the two closest.
DepthRange stored(VkFormat format, const DepthRange& depths, bool nearest);

// The same for the value that a target is cleared to, which parties multiply by 2^n - 1 in float32 or exactly.
DepthRange stored_clear(VkFormat format, float clear, bool nearest);

}  // namespace fillrule::exact
