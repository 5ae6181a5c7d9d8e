#include "cases/model/case.h"

namespace fillrule {

uint32_t component_count(const std::vector<Varying>& varyings) {
  uint32_t count = 0;
  for (const Varying& varying : varyings) count += varying.components;
  return count;
}

uint32_t element_count(const Draw& draw) {
  return static_cast<uint32_t>(draw.indices ? draw.indices->size() : draw.positions.size());
}

uint32_t primitive_count(const Draw& draw) {
  const uint32_t elements = element_count(draw);
  if (draw.topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST) return elements / 3;
  return elements < 3 ? 0 : elements - 2;  // strip and fan
}

}  // namespace fillrule
