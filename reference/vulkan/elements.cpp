#include "reference/vulkan/elements.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace fillrule::vulkan {
namespace {

// Polygons drawn as lines or points: SwiftShader takes the flat values of an edge from the edge's own first vertex,
// not from the polygon's provoking one, so every vertex of the polygon carries the number.
bool needs_triangle_list(const Draw& draw) {
  return draw.topology >= VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST && draw.state.polygon_mode != VK_POLYGON_MODE_FILL;
}

// The vertices of triangle i in the order that the specification gives ("Drawing Commands", "Primitive Topologies").
std::array<uint32_t, 3> triangle_of(const Draw& draw, uint32_t i) {
  const bool last = draw.state.provoking_vertex == VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
  switch (draw.topology) {
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP:
      if (i % 2 == 0) return {i, i + 1, i + 2};
      return last ? std::array{i + 1, i, i + 2} : std::array{i, i + 2, i + 1};
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN:
      return last ? std::array{0U, i + 1, i + 2} : std::array{i + 1, i + 2, 0U};
    default:
      return {3 * i, 3 * i + 1, 3 * i + 2};
  }
}

uint32_t vertex_of(const Draw& draw, uint32_t element) {
  return draw.indices ? (*draw.indices)[element] + static_cast<uint32_t>(draw.vertex_offset) : element;
}

Elements as_triangle_list(const Draw& draw) {
  Elements elements;
  for (const ElementRun& run : element_runs(draw)) {
    for (uint32_t i = 0; i < primitives_in_run(draw.topology, run.count); ++i) {
      for (const uint32_t element : triangle_of(draw, i)) {
        elements.vertices.push_back(vertex_of(draw, run.first + element));
      }
    }
  }
  elements.runs = {{.count = static_cast<uint32_t>(elements.vertices.size())}};
  return elements;
}

Elements without_indices(const Draw& draw) {
  Elements elements{.topology = draw.topology};
  for (const ElementRun& run : element_runs(draw)) {
    elements.runs.push_back({.first = static_cast<uint32_t>(elements.vertices.size()), .count = run.count});
    for (uint32_t i = 0; i < run.count; ++i) elements.vertices.push_back(vertex_of(draw, run.first + i));
  }
  return elements;
}

}  // namespace

Elements elements_of(const Draw& draw, bool use_primitive_id) {
  if (!use_primitive_id && needs_triangle_list(draw)) return as_triangle_list(draw);
  if (!use_primitive_id && draw.indices) return without_indices(draw);
  Elements elements{.topology = draw.topology,
                    .vertices = std::vector<uint32_t>(draw.positions.size()),
                    .indexed = draw.indices.has_value(),
                    .runs = {{.count = element_count(draw)}}};
  std::iota(elements.vertices.begin(), elements.vertices.end(), 0U);
  return elements;
}

uint64_t max_vertices(const Draw& draw, bool use_primitive_id) {
  if (!use_primitive_id && needs_triangle_list(draw)) return uint64_t{3} * primitive_count(draw);
  return !use_primitive_id && draw.indices ? draw.indices->size() : draw.positions.size();
}

}  // namespace fillrule::vulkan
