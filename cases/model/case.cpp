#include "cases/model/case.h"

namespace fillrule {

uint32_t component_count(const std::vector<Varying>& varyings) {
  uint32_t count = 0;
  for (const Varying& varying : varyings) count += varying.components;
  return count;
}

uint32_t vertex_component_count(const std::vector<Varying>& varyings) {
  uint32_t count = 0;
  for (const Varying& varying : varyings) {
    if (varying.source == VaryingSource::kVertices) count += varying.components;
  }
  return count;
}

uint32_t element_count(const Draw& draw) {
  return static_cast<uint32_t>(draw.indices ? draw.indices->size() : draw.positions.size());
}

uint32_t restart_index(VkIndexType type) {
  switch (type) {
    case VK_INDEX_TYPE_UINT8_EXT:
      return 0xFFU;
    case VK_INDEX_TYPE_UINT16:
      return 0xFFFFU;
    default:
      return 0xFFFFFFFFU;
  }
}

std::vector<ElementRun> element_runs(const Draw& draw) {
  const uint32_t elements = element_count(draw);
  if (!draw.primitive_restart || !draw.indices) return {{.first = 0, .count = elements}};
  std::vector<ElementRun> runs;
  const uint32_t restart = restart_index(draw.index_type);
  uint32_t first = 0;
  for (uint32_t i = 0; i <= elements; ++i) {
    if (i < elements && (*draw.indices)[i] != restart) continue;
    if (i > first) runs.push_back({.first = first, .count = i - first});
    first = i + 1;
  }
  return runs;
}

uint32_t primitives_in_run(VkPrimitiveTopology topology, uint32_t elements) {
  switch (topology) {
    case VK_PRIMITIVE_TOPOLOGY_POINT_LIST:
      return elements;
    case VK_PRIMITIVE_TOPOLOGY_LINE_LIST:
      return elements / 2;
    case VK_PRIMITIVE_TOPOLOGY_LINE_STRIP:
      return elements < 2 ? 0 : elements - 1;
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST:
      return elements / 3;
    default:  // strip and fan
      return elements < 3 ? 0 : elements - 2;
  }
}

uint32_t primitive_count(const Draw& draw) {
  uint32_t count = 0;
  for (const ElementRun& run : element_runs(draw)) count += primitives_in_run(draw.topology, run.count);
  return count;
}

}  // namespace fillrule
