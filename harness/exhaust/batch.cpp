#include "harness/exhaust/batch.h"

#include <algorithm>
#include <bit>

#include "reference/vulkan/hit_draw.h"

namespace fillrule::exhaust {

CellLayout::CellLayout(const World& world, uint32_t target_size)
    : grid_(world.grid),
      cell_size_(world.size),
      target_size_(target_size),
      cells_in_row_(target_size / world.size - 2),
      scale_(2.0F / static_cast<float>(target_size * world.grid)) {}

uint32_t CellLayout::default_target_size(uint32_t cell_size) {
  constexpr uint32_t kCellsInRow = 1024;
  return std::bit_ceil(cell_size) * kCellsInRow;
}

CellHits expected_hits(const exact::WoundCoverage& coverage, uint32_t cell_size, VkCullModeFlags cull_mode) {
  const uint32_t front = (cull_mode & VK_CULL_MODE_FRONT_BIT) != 0 ? 0U : coverage.counter_clockwise;
  const uint32_t back = (cull_mode & VK_CULL_MODE_BACK_BIT) != 0 ? 0U : coverage.clockwise;
  CellHits hits{};
  for (uint32_t pixel = 0; pixel < cell_size * cell_size; ++pixel) {
    const uint32_t value = (front >> pixel & 1U) * vulkan::kFrontHit + (back >> pixel & 1U) * vulkan::kHit;
    hits[pixel] = static_cast<uint8_t>(value);
  }
  return hits;
}

void fill(const World& world, const exact::SmallWorld& oracle, const CellLayout& layout, VkCullModeFlags cull_mode,
          uint64_t first, uint32_t triangles, Batch& batch) {
  batch.first = first;
  batch.triangles = triangles;
  batch.covering = 0;
  batch.positions_clip.resize(size_t{triangles} * 3);
  batch.expected.assign(size_t{layout.target_size()} * layout.target_size(), 0);
  const uint32_t size = layout.cell_size();
  const uint32_t positions = oracle.positions();
  Triple triple = triple_at(world, first);
  for (uint32_t i = 0; i < triangles; ++i, advance(world.triples, positions, triple)) {
    const auto& [a, b, c] = triple;
    const Pixel origin = layout.origin(i);
    PlanePosition* const vertices = &batch.positions_clip[size_t{i} * 3];
    vertices[0] = layout.position(origin, oracle.position(a));
    vertices[1] = layout.position(origin, oracle.position(b));
    vertices[2] = layout.position(origin, oracle.position(c));
    const exact::WoundCoverage coverage = oracle.coverage(a, b, c);
    if ((coverage.clockwise | coverage.counter_clockwise) == 0) continue;
    ++batch.covering;
    const CellHits hits = expected_hits(coverage, size, cull_mode);
    for (uint32_t row = 0; row < size; ++row) {
      uint8_t* const target = &batch.expected[size_t{origin.y + row} * layout.target_size() + origin.x];
      std::copy_n(&hits[size_t{row} * size], size, target);
    }
  }
}

}  // namespace fillrule::exhaust
