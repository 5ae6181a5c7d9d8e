// How a case's varyings travel: their components packed into vec4 slots by kind, so that a pipeline depends on a few
// small counts instead of the case's declarations.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <numeric>
#include <vector>

#include "cases/model/case.h"

namespace fillrule::vulkan {

inline constexpr uint32_t kSlotComponents = 4;

// What fills a slot: interpolated values of the vertices, or a built-in of the fragment stage.
enum class SlotKind : uint8_t {
  kSmooth,
  kSmoothCentroid,
  kSmoothSample,
  kNoperspective,
  kNoperspectiveCentroid,
  kNoperspectiveSample,
  kFlat,
  kFragCoord,
  kPointCoord,
};
inline constexpr size_t kSlotKindCount = 9;
// The kinds before this one have values in the vertices.
inline constexpr auto kFirstBuiltIn = static_cast<size_t>(SlotKind::kFragCoord);

// How many slots of each kind. They lie in the order of the enumeration, so that a vertex needs the first ones alone.
struct SlotCounts {
  std::array<uint32_t, kSlotKindCount> of{};

  [[nodiscard]] uint32_t total() const { return std::accumulate(of.begin(), of.end(), 0U); }
  [[nodiscard]] uint32_t interpolated() const { return std::accumulate(of.begin(), of.begin() + kFirstBuiltIn, 0U); }
  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm at the comparison with zero
  auto operator<=>(const SlotCounts&) const = default;
};

// A range of a case's slots, drawn in one pass.
struct SlotRange {
  uint32_t first = 0;
  SlotCounts counts;
  uint32_t outputs = 0;  // of the fragment stage, a vec4 each: all of the slots, or a colour
};

// Where a component is found.
struct ComponentPlace {
  uint32_t slot = 0;
  uint32_t lane = 0;  // 0 to 3
  bool operator==(const ComponentPlace&) const = default;
};

struct Packing {
  SlotCounts counts;
  std::vector<ComponentPlace> components;         // in the order of Planes::varyings
  std::vector<ComponentPlace> vertex_components;  // in the order of Draw::varyings: those without built-ins
};

// Components of equal kind follow each other without gaps, in the order of declaration.
Packing pack(const std::vector<Varying>& varyings);

// The passes that a case of `counts` needs, at most `slots_per_pass` slots each; one pass where there are no slots.
// `draws_color` as in Program.
std::vector<SlotRange> split_into_passes(const SlotCounts& counts, uint32_t slots_per_pass, bool draws_color = false);

}  // namespace fillrule::vulkan
