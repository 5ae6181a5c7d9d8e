// A party's target against the oracle's, byte for byte, and what a difference means.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "harness/exhaust/batch.h"

namespace fillrule::exhaust {

// Pixels in which a party differs, by what the specification says of them.
struct Tally {
  uint64_t triangles = 0;  // that differ in a pixel
  uint64_t faults = 0;     // outside of must or must not, hit more than once, or of the wrong facing
  uint64_t latitude = 0;   // within the latitude of snapping, off the edge: Vulkan permits it
  uint64_t ties = 0;       // on an edge: against the top-left rule, which Vulkan does not ask for
  uint64_t strays = 0;     // outside of every triangle's cell

  [[nodiscard]] bool any() const { return triangles > 0 || strays > 0; }
  void add(const Tally& other);
  bool operator==(const Tally&) const = default;
};

// One triangle that a party drew otherwise.
struct Difference {
  uint64_t number = 0;  // of the triple
  Triple vertices{};
  CellHits expected{};
  CellHits drawn{};
  Tally tally;
  bool operator==(const Difference&) const = default;
};

struct Comparison {
  Tally tally;
  std::vector<Difference> first;  // at most as many as were asked for
};

// What the comparison needs to know besides the bytes.
struct Judgement {
  const World& world;
  const CellLayout& layout;
  VkCullModeFlags cull_mode = VK_CULL_MODE_NONE;
  uint32_t subpixel_bits = 8;  // of the party
};

Comparison compare(const Judgement& judgement, const Batch& batch, std::span<const uint8_t> drawn, size_t max_first);

}  // namespace fillrule::exhaust
