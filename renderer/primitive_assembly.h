// Primitive assembly (Vulkan, "Primitive Topologies", "Provoking Vertex"): which vertices form primitive i.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "cases/model/case.h"

namespace fillrule::renderer {

// The complete triangles that so many vertices (or indices) form; incomplete ones are dropped.
constexpr uint32_t triangle_count(VkPrimitiveTopology topology, uint32_t elements) {
  if (topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST) {
    return elements / 3;
  }
  return elements < 3 ? 0 : elements - 2;
}

// The triangle's positions in the stream of vertices (or indices), the provoking one (Vulkan's default: the first)
// first. Every second triangle of a strip exchanges its last two, so that all have the winding of the first.
constexpr std::array<uint32_t, 3> triangle_elements(VkPrimitiveTopology topology, uint32_t primitive) {
  switch (topology) {
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP: {
      const uint32_t odd = primitive & 1U;
      return {primitive, primitive + 1 + odd, primitive + 2 - odd};
    }
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN:
      return {primitive + 1, primitive + 2, 0};
    default:
      return {3 * primitive, 3 * primitive + 1, 3 * primitive + 2};
  }
}

using Indices = std::optional<std::span<const uint32_t>>;

// The triangle's vertices, the provoking one first.
constexpr std::array<uint32_t, 3> triangle_vertices(VkPrimitiveTopology topology, const Indices& indices,
                                                    uint32_t primitive) {
  std::array<uint32_t, 3> vertices = triangle_elements(topology, primitive);
  if (indices) {
    for (uint32_t& vertex : vertices) {
      vertex = (*indices)[vertex];
    }
  }
  return vertices;
}

}  // namespace fillrule::renderer
