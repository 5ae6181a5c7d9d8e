#include "reference/vulkan/packing.h"

#include <algorithm>
#include <array>

namespace fillrule::vulkan {
namespace {

constexpr std::array kSlotOrder = {Interpolation::kSmooth, Interpolation::kNoperspective, Interpolation::kFlat};

uint32_t slots_of(const std::vector<Varying>& varyings, Interpolation interpolation) {
  uint32_t components = 0;
  for (const Varying& varying : varyings) {
    if (varying.interpolation == interpolation) components += varying.components;
  }
  return (components + kSlotComponents - 1) / kSlotComponents;
}

// How much of [first, first + count) lies in [begin, end).
uint32_t overlap(uint32_t first, uint32_t count, uint32_t begin, uint32_t end) {
  const uint32_t low = std::max(first, begin);
  const uint32_t high = std::min(first + count, end);
  return high > low ? high - low : 0;
}

}  // namespace

Packing pack(const std::vector<Varying>& varyings) {
  Packing packing{.counts = {.smooth = slots_of(varyings, Interpolation::kSmooth),
                             .noperspective = slots_of(varyings, Interpolation::kNoperspective),
                             .flat = slots_of(varyings, Interpolation::kFlat)}};
  std::array<uint32_t, kSlotOrder.size()> next{};  // counted in components
  next[1] = packing.counts.smooth * kSlotComponents;
  next[2] = next[1] + packing.counts.noperspective * kSlotComponents;
  for (const Varying& varying : varyings) {
    uint32_t& component =
        next[static_cast<size_t>(std::ranges::find(kSlotOrder, varying.interpolation) - kSlotOrder.begin())];
    for (uint32_t i = 0; i < varying.components; ++i, ++component) {
      packing.components.push_back({.slot = component / kSlotComponents, .lane = component % kSlotComponents});
    }
  }
  return packing;
}

std::vector<SlotRange> split_into_passes(const SlotCounts& counts, uint32_t slots_per_pass) {
  const uint32_t flat_begin = counts.smooth + counts.noperspective;
  std::vector<SlotRange> passes;
  uint32_t first = 0;
  do {
    const uint32_t count = std::min(slots_per_pass, counts.total() - first);
    passes.push_back({.first = first,
                      .counts = {.smooth = overlap(first, count, 0, counts.smooth),
                                 .noperspective = overlap(first, count, counts.smooth, flat_begin),
                                 .flat = overlap(first, count, flat_begin, counts.total())}});
    first += count;
  } while (first < counts.total());
  return passes;
}

}  // namespace fillrule::vulkan
