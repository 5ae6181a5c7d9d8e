// The small world: every triangle whose vertices lie on a grid of 1/grid pixels in a cell of size x size pixels, and
// the order in which they are gone through.
#pragma once

#include <array>
#include <cstdint>

#include "cases/model/result.h"

namespace fillrule::exhaust {

enum class Triples : uint8_t {
  kOrdered,    // every order of three vertices by itself
  kUnordered,  // one order of each three; equal vertices are among them
};

struct World {
  uint32_t grid = 4;  // steps in a pixel: a power of two up to 16, since every Vulkan device has 4 subpixel bits
  uint32_t size = 4;  // pixels: 1 to exact::kMaxCellSize
  Triples triples = Triples::kOrdered;
};

// An error names the value that is out of range.
Result<void> check_world(uint32_t grid, uint32_t size);

// Above this, a world is gone through up to the order of the vertices unless told otherwise.
inline constexpr uint64_t kMaxOrderedByDefault = 100'000'000;
Triples default_triples(uint32_t grid, uint32_t size);

// Numbers of grid positions (exact::SmallWorld).
using Triple = std::array<uint32_t, 3>;

uint32_t position_count(const World& world);
uint64_t triple_count(const World& world);

// Triples are in lexicographic order; unordered ones ascend. `number` is below triple_count().
Triple triple_at(const World& world, uint64_t number);

// The triple after this one; of the last one, anything.
inline void advance(Triples triples, uint32_t positions, Triple& triple) {
  auto& [a, b, c] = triple;
  if (++c < positions) return;
  if (++b == positions) {
    ++a;
    b = triples == Triples::kOrdered ? 0 : a;
  }
  c = triples == Triples::kOrdered ? 0 : b;
}

}  // namespace fillrule::exhaust
