// Primitive assembly for the oracle (Vulkan specification, "Drawing Commands", "Primitive Topologies"): which
// vertices make each triangle. Written apart from the renderer's, so that the two cannot share a mistake.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cases/model/case.h"

namespace fillrule::exact {

struct AssembledTriangle {
  std::array<uint32_t, 3> vertices{};  // indices into Draw::positions, in the order that decides the facing
  uint32_t provoking = 0;              // which of the three: 0, 1 or 2
};

std::vector<AssembledTriangle> assemble(const Draw& draw);

}  // namespace fillrule::exact
