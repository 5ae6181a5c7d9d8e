// Primitive assembly (Vulkan, "Primitive Topologies", "Provoking Vertex", "Primitive restart"): which vertices form
// primitive i.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/result.h"

namespace fillrule::renderer {

using Indices = std::optional<std::span<const uint32_t>>;

// Triangle i's positions in the stream of vertices (or indices), the provoking one first. Every second triangle of a
// strip exchanges two of its vertices, so that all have the winding of the first. Which two, Vulkan makes depend on
// the provoking mode; going round from the provoking vertex, it is the same.
constexpr std::array<uint32_t, 3> triangle_elements(VkPrimitiveTopology topology, VkProvokingVertexModeEXT provoking,
                                                    uint32_t triangle) {
  const bool is_last = provoking == VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
  const auto from = [](uint32_t first, uint32_t second, uint32_t third, uint32_t start) {
    const std::array<uint32_t, 3> cycle{first, second, third};
    return std::array<uint32_t, 3>{cycle[start], cycle[(start + 1) % 3], cycle[(start + 2) % 3]};
  };
  switch (topology) {
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP: {
      const uint32_t odd = triangle & 1U;
      return from(triangle, triangle + 1 + odd, triangle + 2 - odd, is_last ? 2 - odd : 0);
    }
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN:
      return from(triangle + 1, triangle + 2, 0, is_last ? 1 : 0);
    default:
      return from(3 * triangle, 3 * triangle + 1, 3 * triangle + 2, is_last ? 2 : 0);
  }
}

// What a draw fills: its polygons, the rectangles or pixels of lines, the squares of points.
enum class Shape : uint8_t { kPolygon, kLine, kPoint };

constexpr bool is_polygon_topology(VkPrimitiveTopology topology) {
  return topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST || topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP ||
         topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN;
}

constexpr Shape shape_of(VkPrimitiveTopology topology, VkPolygonMode polygon_mode) {
  if (topology == VK_PRIMITIVE_TOPOLOGY_POINT_LIST) {
    return Shape::kPoint;
  }
  if (!is_polygon_topology(topology)) {
    return Shape::kLine;
  }
  switch (polygon_mode) {
    case VK_POLYGON_MODE_LINE:
      return Shape::kLine;
    case VK_POLYGON_MODE_POINT:
      return Shape::kPoint;
    default:
      return Shape::kPolygon;
  }
}

// A line's end points, or a polygon's edge, among the vertices of its primitive, which are in the order of
// primitive_elements(). A point has both at its vertex.
struct LineEnds {
  uint8_t from = 0;
  uint8_t to = 0;
};

// A primitive of lines goes in the order of its vertices, wherever the provoking one is.
constexpr LineEnds line_ends(VkProvokingVertexModeEXT provoking) {
  return provoking == VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT ? LineEnds{1, 0} : LineEnds{0, 1};
}

// Primitive i's positions in the stream, the provoking one first; of a line or a point, the last repeated up to
// three.
constexpr std::array<uint32_t, 3> primitive_elements(VkPrimitiveTopology topology, VkProvokingVertexModeEXT provoking,
                                                     uint32_t primitive) {
  if (topology == VK_PRIMITIVE_TOPOLOGY_POINT_LIST) {
    return {primitive, primitive, primitive};
  }
  if (is_polygon_topology(topology)) {
    return triangle_elements(topology, provoking, primitive);
  }
  const uint32_t from = topology == VK_PRIMITIVE_TOPOLOGY_LINE_LIST ? 2 * primitive : primitive;
  const bool is_last = provoking == VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
  return is_last ? std::array{from + 1, from, from} : std::array{from, from + 1, from + 1};
}

// The vertices (or indices) of a draw, in their order.
struct VertexStream {
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  uint32_t vertex_count = 0;
  Indices indices;            // absent: vertices are used in their order
  int32_t vertex_offset = 0;  // added to every index
  // Between restarts: in each run the strip or fan, and the parity of the strip, begins anew. Indices outside of all
  // runs are not looked at. Absent: one run of everything.
  std::optional<std::span<const ElementRun>> runs;
  std::span<const float> point_sizes;  // pixels, one for each vertex; empty: 1

  [[nodiscard]] float point_size(uint32_t vertex) const { return point_sizes.empty() ? 1.0F : point_sizes[vertex]; }
};

class PrimitiveAssembly {
 public:
  PrimitiveAssembly(const VertexStream& stream, VkProvokingVertexModeEXT provoking_vertex);

  // The complete primitives; incomplete ones at the end of a run are dropped. Numbers run on from run to run.
  [[nodiscard]] uint32_t count() const { return count_; }

  // The vertices of primitive i, the provoking one first; of a line or a point, the last repeated up to three.
  [[nodiscard]] std::array<uint32_t, 3> vertices(uint32_t primitive) const {
    const Run& run = runs_.size() == 1 ? runs_.front() : run_of(primitive);
    std::array<uint32_t, 3> vertices =
        primitive_elements(topology_, provoking_vertex_, primitive - run.first_primitive);
    for (uint32_t& vertex : vertices) {
      vertex = vertex_at(run.first_element + vertex);
    }
    return vertices;
  }

  // The same of as many primitives as there is room for, from `first` on.
  void vertices(uint32_t first, std::span<std::array<uint32_t, 3>> of_primitives) const;

 private:
  struct Run {
    uint32_t first_element = 0;
    uint32_t first_primitive = 0;
  };

  [[nodiscard]] const Run& run_of(uint32_t primitive) const;

  [[nodiscard]] uint32_t vertex_at(uint32_t element) const {
    return indices_ ? (*indices_)[element] + vertex_offset_ : element;
  }

  VkPrimitiveTopology topology_;
  VkProvokingVertexModeEXT provoking_vertex_;
  Indices indices_;
  uint32_t vertex_offset_;  // modulo 2^32
  std::vector<Run> runs_;   // those with a complete primitive
  uint32_t count_ = 0;
};

// Refuses an index without a vertex.
Result<void> check_indices(const VertexStream& stream);

}  // namespace fillrule::renderer
