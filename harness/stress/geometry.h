// Random triangles in clip space, placed in the framebuffer (pixels, y down) of a given viewport.
#pragma once

#include <array>
#include <vector>

#include "cases/model/case.h"
#include "harness/stress/family.h"
#include "harness/stress/random.h"

namespace fillrule::stress {

// One triangle of the family; of kSharedEdges see random_mesh().
std::array<ClipPosition, 3> random_triangle(Family family, const VkViewport& viewport, Random& random);

// Vertices and how to join them: triangles that share edges with identical end points.
struct Mesh {
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  std::vector<ClipPosition> positions;
  std::optional<std::vector<uint32_t>> indices;
};
Mesh random_mesh(uint32_t triangles, const VkViewport& viewport, Random& random);

}  // namespace fillrule::stress
