#include "reference/vulkan/packing.h"

#include <algorithm>

namespace fillrule::vulkan {
namespace {

size_t kind_of(const Varying& varying) {
  if (varying.source == VaryingSource::kFragCoord) return static_cast<size_t>(SlotKind::kFragCoord);
  if (varying.source == VaryingSource::kPointCoord) return static_cast<size_t>(SlotKind::kPointCoord);
  if (varying.interpolation == Interpolation::kFlat) return static_cast<size_t>(SlotKind::kFlat);
  const SlotKind at_centers = varying.interpolation == Interpolation::kSmooth ? SlotKind::kSmooth  //
                                                                              : SlotKind::kNoperspective;
  return static_cast<size_t>(at_centers) + static_cast<size_t>(varying.sampling);
}

SlotCounts count_slots(const std::vector<Varying>& varyings) {
  SlotCounts counts;
  for (const Varying& varying : varyings) counts.of[kind_of(varying)] += varying.components;
  for (uint32_t& count : counts.of) count = (count + kSlotComponents - 1) / kSlotComponents;
  return counts;
}

// How much of [first, first + count) lies in [begin, end).
uint32_t overlap(uint32_t first, uint32_t count, uint32_t begin, uint32_t end) {
  const uint32_t low = std::max(first, begin);
  const uint32_t high = std::min(first + count, end);
  return high > low ? high - low : 0;
}

}  // namespace

Packing pack(const std::vector<Varying>& varyings) {
  Packing packing{.counts = count_slots(varyings)};
  std::array<uint32_t, kSlotKindCount> next{};  // counted in components
  std::exclusive_scan(packing.counts.of.begin(), packing.counts.of.end(), next.begin(), 0U);
  for (uint32_t& component : next) component *= kSlotComponents;
  for (const Varying& varying : varyings) {
    uint32_t& component = next[kind_of(varying)];
    for (uint32_t i = 0; i < varying.components; ++i, ++component) {
      const ComponentPlace place{.slot = component / kSlotComponents, .lane = component % kSlotComponents};
      packing.components.push_back(place);
      if (varying.source == VaryingSource::kVertices) packing.vertex_components.push_back(place);
    }
  }
  return packing;
}

std::vector<SlotRange> split_into_passes(const SlotCounts& counts, uint32_t slots_per_pass, bool draws_color) {
  std::vector<SlotRange> passes;
  uint32_t first = 0;
  do {
    const uint32_t count = std::min(slots_per_pass, counts.total() - first);
    passes.push_back({.first = first, .outputs = draws_color ? std::min(count, 1U) : count});
    uint32_t begin = 0;  // of the kind's slots
    for (size_t kind = 0; kind < kSlotKindCount; ++kind) {
      passes.back().counts.of[kind] = overlap(first, count, begin, begin + counts.of[kind]);
      begin += counts.of[kind];
    }
    first += count;
  } while (first < counts.total());
  return passes;
}

}  // namespace fillrule::vulkan
