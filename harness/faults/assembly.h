// Primitive assembly: which vertices make each primitive (Vulkan specification, "Primitive Topologies").
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "harness/faults/context.h"

namespace fillrule::faults {

struct Primitive {
  uint32_t number = 0;                 // in the draw
  std::array<uint32_t, 3> vertices{};  // of the draw; of a line two count, of a point one
  uint32_t size = 3;                   // how many count
  uint32_t provoking = 0;              // the vertex of the draw that flat varyings come from
};

// In the order in which they are to be drawn.
std::vector<Primitive> assemble(const Context& context);

}  // namespace fillrule::faults
