// Clipping in homogeneous clip space, plane by plane (Vulkan specification, "Primitive Clipping"), in numbers of 113
// bits: positions up to 1e30 that are cut to a window of 1 lose all digits of a double.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "harness/faults/assembly.h"
#include "harness/faults/context.h"

namespace fillrule::faults {

using Wide = __float128;

// A corner of what is left of a primitive.
struct Corner {
  std::array<Wide, 4> position{};                          // clip space
  std::array<Wide, 3> weights{};                           // of the primitive's vertices: what it is a mixture of
  std::array<Wide, kMaxClipAndCullDistances> distances{};  // user clip distances
  bool is_new = false;                                     // made by clipping
};

// What is left of a polygon, a line or a point; empty: nothing.
std::vector<Corner> clip(const Context& context, const Primitive& primitive);

// True if the primitive is dropped by its cull distances.
bool culled_by_distances(const Context& context, const Primitive& primitive);

}  // namespace fillrule::faults
