#include "reference/exact/assembly.h"

#include <algorithm>
#include <cmath>

namespace fillrule::exact {
namespace {

// The i-th triangle of a run, `at` giving the run's vertices. Every other triangle of a strip has two vertices
// swapped, which keeps the winding; which two depends on the provoking mode, so that the provoking vertex stays first
// or last.
AssembledTriangle triangle_of_strip(uint32_t i, bool last, const auto& at) {
  const uint32_t odd = i % 2;
  if (last) return {.vertices = {at(i + odd), at(i + 1 - odd), at(i + 2)}, .provoking = 2};
  return {.vertices = {at(i), at(i + 1 + odd), at(i + 2 - odd)}, .provoking = 0};
}

AssembledTriangle assemble_one(VkPrimitiveTopology topology, uint32_t i, bool last, const auto& at) {
  switch (topology) {
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP:
      return triangle_of_strip(i, last, at);
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN:
      return {.vertices = {at(i + 1), at(i + 2), at(0)}, .provoking = last ? 1U : 0U};
    default:
      return {.vertices = {at(3 * i), at(3 * i + 1), at(3 * i + 2)}, .provoking = last ? 2U : 0U};
  }
}

}  // namespace

bool draws_polygons(const Draw& draw) {
  return draw.topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST ||
         draw.topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP || draw.topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN;
}

uint32_t vertex_of_element(const Draw& draw, uint32_t element) {
  if (!draw.indices) return element;
  // Wraps around as signed addition does.
  return (*draw.indices)[element] + static_cast<uint32_t>(draw.vertex_offset);
}

CullDistances cull_distances_of(const Draw& draw, std::span<const uint32_t> vertices) {
  CullDistances result = CullDistances::kKeep;
  for (size_t i = 0; i < draw.cull_distance_count; ++i) {
    const auto distance = [&](uint32_t vertex) {
      return draw.cull_distances[size_t{vertex} * draw.cull_distance_count + i];
    };
    const bool all_negative = std::ranges::all_of(vertices, [&](uint32_t vertex) { return distance(vertex) < 0; });
    if (all_negative) return CullDistances::kDrop;
    const bool any_nan = std::ranges::any_of(vertices, [&](uint32_t vertex) { return std::isnan(distance(vertex)); });
    if (any_nan) result = CullDistances::kEither;
  }
  return result;
}

std::vector<AssembledTriangle> assemble(const Draw& draw) {
  const bool last = draw.state.provoking_vertex == VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
  std::vector<AssembledTriangle> triangles;
  if (!draws_polygons(draw)) return triangles;
  triangles.reserve(primitive_count(draw));
  for (const ElementRun& run : element_runs(draw)) {
    const auto at = [&](uint32_t i) { return vertex_of_element(draw, run.first + i); };
    const uint32_t count = primitives_in_run(draw.topology, run.count);
    for (uint32_t i = 0; i < count; ++i) triangles.push_back(assemble_one(draw.topology, i, last, at));
  }
  return triangles;
}

}  // namespace fillrule::exact
