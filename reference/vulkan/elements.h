// The vertices and indices that a draw is handed to the driver with. With gl_PrimitiveID they are the case's own;
// without it each primitive needs a provoking vertex of its own, which carries the primitive's number.
#pragma once

#include <cstdint>
#include <vector>

#include "cases/model/case.h"

namespace fillrule::vulkan {

struct Elements {
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  std::vector<uint32_t> vertices;  // the case's vertex that each one handed over is
  bool indexed = false;            // by the case's indices, vertex offset and restart
  // Each is drawn by itself, so that the number of its first primitive is known: vertices, or indices.
  std::vector<ElementRun> runs;
};

Elements elements_of(const Draw& draw, bool use_primitive_id);

// How many vertices Elements has, at most.
uint64_t max_vertices(const Draw& draw, bool use_primitive_id);

}  // namespace fillrule::vulkan
