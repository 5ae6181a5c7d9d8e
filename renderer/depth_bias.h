// The depth bias of a polygon, drawn filled, as lines or as points (Vulkan, "Depth Bias Computation"). Vulkan lets an
// implementation bias the topologies of lines and points too; this one does not, as the reference drivers.
#pragma once

#include <cstdint>

#include "cases/model/case.h"
#include "renderer/interpolation.h"

namespace fillrule::renderer {

// What is added to the depth all over the polygon, framebuffer depth. `depth_framebuffer` is its plane of depth;
// `max_code` is its attachment's (depth.h), 0 for floating point; `greatest_depth` is the greatest |depth| in it, on
// which the resolution of a floating-point format depends.
double depth_bias(const DepthBias& bias, const WindowPlane& depth_framebuffer, uint32_t max_code,
                  double greatest_depth);

}  // namespace fillrule::renderer
