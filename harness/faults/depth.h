// Depth bias, clamp, the depth format and the tests (Vulkan specification, "Depth Bias Computation", "Depth
// Clamping", "Depth Bounds Test", "Depth Test"). Depths are in window space.
#pragma once

#include "harness/faults/interpolation.h"

namespace fillrule::faults {

// What the depth of every fragment of a polygon is increased by.
double depth_bias(const Context& context, const Interpolant& polygon);

// What the attachment holds of a depth within [0, 1], as Planes::depth shows it.
float rounded_to_format(VkFormat format, double depth);

// Whether a fragment of this depth passes against what is stored; stores its own if it does and is to be written.
bool passes_depth(const Context& context, double depth, float& stored);

}  // namespace fillrule::faults
