#include "harness/exhaust/world.h"

#include <fmt/format.h>

#include <bit>

#include "reference/exact/small_world.h"

namespace fillrule::exhaust {
namespace {

constexpr uint32_t kMaxGrid = 16;

// How many pairs b <= c, and triples a <= b <= c, there are of n numbers.
uint64_t pairs_of(uint64_t n) {
  return n * (n + 1) / 2;
}
uint64_t triples_of(uint64_t n) {
  return n * (n + 1) / 2 * (n + 2) / 3;
}

}  // namespace

Result<void> check_world(uint32_t grid, uint32_t size) {
  if (!std::has_single_bit(grid) || grid > kMaxGrid) {
    return failure(fmt::format("a grid of 1/{} px", grid),
                   fmt::format("a power of two from 1 to {}: what every device's subpixel grid holds", kMaxGrid));
  }
  if (size == 0 || size > exact::kMaxCellSize) {
    return failure(fmt::format("cells of {} x {} px", size, size),
                   fmt::format("1 to {}: a coverage mask has {} bits", exact::kMaxCellSize,
                               exact::kMaxCellSize * exact::kMaxCellSize));
  }
  return {};
}

Triples default_triples(uint32_t grid, uint32_t size) {
  const bool is_small = triple_count({.grid = grid, .size = size}) <= kMaxOrderedByDefault;
  return is_small ? Triples::kOrdered : Triples::kUnordered;
}

uint32_t position_count(const World& world) {
  const uint32_t side = world.grid * world.size + 1;
  return side * side;
}

uint64_t triple_count(const World& world) {
  const uint64_t n = position_count(world);
  return world.triples == Triples::kOrdered ? n * n * n : triples_of(n);
}

Triple triple_at(const World& world, uint64_t number) {
  const uint64_t n = position_count(world);
  const auto triple = [](uint64_t a, uint64_t b, uint64_t c) {
    return Triple{static_cast<uint32_t>(a), static_cast<uint32_t>(b), static_cast<uint32_t>(c)};
  };
  if (world.triples == Triples::kOrdered) return triple(number / (n * n), number / n % n, number % n);
  uint64_t a = 0;
  for (; number >= pairs_of(n - a); ++a) number -= pairs_of(n - a);
  uint64_t b = a;
  for (; number >= n - b; ++b) number -= n - b;
  return triple(a, b, b + number);
}

}  // namespace fillrule::exhaust
