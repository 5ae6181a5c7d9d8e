// Primitive assembly for the oracle (Vulkan specification, "Drawing Commands", "Primitive Topologies"): which
// vertices make each triangle. Written apart from the renderer's, so that the two cannot share a mistake.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cases/model/case.h"

namespace fillrule::exact {

struct AssembledTriangle {
  std::array<uint32_t, 3> vertices{};  // indices into Draw::positions, in the order that decides the facing
  uint32_t provoking = 0;              // which of the three: 0, 1 or 2
};

// True for lists, strips and fans of triangles, however their polygons are drawn.
bool draws_polygons(const Draw& draw);

// The vertex that the element-th index, or vertex, of a draw stands for.
uint32_t vertex_of_element(const Draw& draw, uint32_t element);

// What the cull distances of a primitive's vertices say: it is dropped where one of them is negative at all vertices.
// NaN is neither negative nor not: then it may be dropped.
enum class CullDistances : uint8_t { kKeep, kDrop, kEither };
CullDistances cull_distances_of(const Draw& draw, std::span<const uint32_t> vertices);

// The triangles of a draw, in order, across restarts; none where it draws no polygons.
std::vector<AssembledTriangle> assemble(const Draw& draw);

}  // namespace fillrule::exact
