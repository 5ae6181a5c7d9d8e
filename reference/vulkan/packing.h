// How a case's varyings travel: their components packed into vec4 slots by interpolation, so that a pipeline depends
// on three small counts instead of the case's declarations.
#pragma once

#include <cstdint>
#include <vector>

#include "cases/model/case.h"

namespace fillrule::vulkan {

inline constexpr uint32_t kSlotComponents = 4;

// How many slots of each interpolation. Smooth slots come first, flat ones last.
struct SlotCounts {
  uint32_t smooth = 0;
  uint32_t noperspective = 0;
  uint32_t flat = 0;

  [[nodiscard]] uint32_t total() const { return smooth + noperspective + flat; }
  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm at the comparison with zero
  auto operator<=>(const SlotCounts&) const = default;
};

// A range of a case's slots, drawn in one pass.
struct SlotRange {
  uint32_t first = 0;
  SlotCounts counts;
};

// Where a component is found.
struct ComponentPlace {
  uint32_t slot = 0;
  uint32_t lane = 0;  // 0 to 3
  bool operator==(const ComponentPlace&) const = default;
};

struct Packing {
  SlotCounts counts;
  std::vector<ComponentPlace> components;  // in the order of Draw::varyings
};

// Components of equal interpolation follow each other without gaps, in the order of declaration.
Packing pack(const std::vector<Varying>& varyings);

// The passes that a case of `counts` needs, at most `slots_per_pass` slots each; one pass where there are no slots.
std::vector<SlotRange> split_into_passes(const SlotCounts& counts, uint32_t slots_per_pass);

}  // namespace fillrule::vulkan
