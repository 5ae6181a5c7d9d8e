#include "reference/exact/assembly.h"

namespace fillrule::exact {

std::vector<AssembledTriangle> assemble(const Draw& draw) {
  const auto vertex = [&draw](uint32_t element) { return draw.indices ? (*draw.indices)[element] : element; };
  const uint32_t count = primitive_count(draw);
  std::vector<AssembledTriangle> triangles;
  triangles.reserve(count);
  for (uint32_t i = 0; i < count; ++i) {
    switch (draw.topology) {
      case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP:
        // Every other triangle has its last two vertices swapped, which keeps the winding.
        triangles.push_back({.vertices = i % 2 == 0 ? std::array{vertex(i), vertex(i + 1), vertex(i + 2)}
                                                    : std::array{vertex(i), vertex(i + 2), vertex(i + 1)}});
        break;
      case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN:
        triangles.push_back({.vertices = {vertex(i + 1), vertex(i + 2), vertex(0)}});
        break;
      default:
        triangles.push_back({.vertices = {vertex(3 * i), vertex(3 * i + 1), vertex(3 * i + 2)}});
    }
  }
  return triangles;
}

}  // namespace fillrule::exact
