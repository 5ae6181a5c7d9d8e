#include "harness/exhaust/compare.h"

#include <algorithm>
#include <cstring>

#include "reference/exact/triangle.h"
#include "reference/vulkan/hit_draw.h"

namespace fillrule::exhaust {
namespace {

constexpr uint8_t kHitsOfPixel = 0x0F;

// The bytes of the cell whose first pixel this is.
CellHits cell_at(std::span<const uint8_t> target, const CellLayout& layout, const Pixel& origin) {
  CellHits hits{};
  const uint32_t size = layout.cell_size();
  for (uint32_t row = 0; row < size; ++row) {
    const size_t begin = size_t{origin.y + row} * layout.target_size() + origin.x;
    std::copy_n(target.begin() + static_cast<ptrdiff_t>(begin), size, hits.begin() + ptrdiff_t{row} * size);
  }
  return hits;
}

// The triangle where it was drawn, for the oracle's general answer.
exact::Triangle triangle_of(const Judgement& judgement, const Batch& batch, uint32_t triangle) {
  std::array<ClipPosition, 3> vertices{};
  for (size_t i = 0; i < 3; ++i) {
    const auto& [x, y] = batch.positions_clip[size_t{triangle} * 3 + i];
    vertices[i] = {x, y, 0.5F, 1.0F};
  }
  const auto size = static_cast<float>(judgement.layout.target_size());
  return {vertices, {.width = size, .height = size, .maxDepth = 1.0F}};
}

bool is_culled(const exact::Triangle& triangle, VkCullModeFlags cull_mode) {
  const bool is_front = triangle.orientation() < 0;
  return (cull_mode & (is_front ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_BACK_BIT)) != 0;
}

// On one edge and outside of none. Vertices and samples of a small world are such short numbers that edge functions
// do not round.
bool is_tie(const exact::Triangle& triangle, double x, double y) {
  double least = triangle.edge(0).at(x - triangle.centre_x(), y - triangle.centre_y());
  for (size_t i = 1; i < 3; ++i) {
    least = std::min(least, triangle.edge(i).at(x - triangle.centre_x(), y - triangle.centre_y()));
  }
  return least == 0;
}

// What a pixel's difference means, counted.
void classify(const Judgement& judgement, const exact::Triangle& triangle, const Pixel& pixel, uint8_t expected,
              uint8_t drawn, Tally& tally) {
  const exact::Latitude latitude = exact::latitude_of(triangle.viewport(), judgement.subpixel_bits);
  const int hits = drawn & kHitsOfPixel;
  const bool is_facing_wrong = hits == (expected & kHitsOfPixel);
  const bool may_turn_over = triangle.orientation_in_doubt(latitude);
  if (hits > 1 || (drawn != 0 && drawn != vulkan::kHit && drawn != vulkan::kFrontHit)) {
    ++tally.faults;
  } else if (is_facing_wrong || is_culled(triangle, judgement.cull_mode)) {
    ++(may_turn_over ? tally.latitude : tally.faults);
  } else {
    const double x = pixel.x + 0.5;
    const double y = pixel.y + 0.5;
    if (triangle.classify(x, y, latitude).coverage != exact::Coverage::kMay) {
      ++tally.faults;
    } else {
      ++(is_tie(triangle, x, y) ? tally.ties : tally.latitude);
    }
  }
}

Difference describe(const Judgement& judgement, const Batch& batch, std::span<const uint8_t> drawn, uint32_t number) {
  const Pixel origin = judgement.layout.origin(number);
  const exact::Triangle triangle = triangle_of(judgement, batch, number);
  Difference difference{.number = batch.first + number,
                        .vertices = triple_at(judgement.world, batch.first + number),
                        .expected = cell_at(batch.expected, judgement.layout, origin),
                        .drawn = cell_at(drawn, judgement.layout, origin),
                        .tally = {.triangles = 1}};
  const uint32_t size = judgement.layout.cell_size();
  for (uint32_t pixel = 0; pixel < size * size; ++pixel) {
    const uint8_t expected_hits = difference.expected[pixel];
    const uint8_t drawn_hits = difference.drawn[pixel];
    if (expected_hits == drawn_hits) continue;
    classify(judgement, triangle, {origin.x + pixel % size, origin.y + pixel / size}, expected_hits, drawn_hits,
             difference.tally);
  }
  return difference;
}

}  // namespace

void Tally::add(const Tally& other) {
  triangles += other.triangles;
  faults += other.faults;
  latitude += other.latitude;
  ties += other.ties;
  strays += other.strays;
}

Comparison compare(const Judgement& judgement, const Batch& batch, std::span<const uint8_t> drawn, size_t max_first) {
  Comparison comparison;
  const CellLayout& layout = judgement.layout;
  const size_t target_size = layout.target_size();
  if (std::memcmp(batch.expected.data(), drawn.data(), batch.expected.size()) == 0) return comparison;

  // Step 1: the triangles' cells.
  uint64_t differing_pixels_in_cells = 0;
  for (uint32_t i = 0; i < batch.triangles; ++i) {
    const Pixel origin = layout.origin(i);
    const CellHits expected_hits = cell_at(batch.expected, layout, origin);
    const CellHits drawn_hits = cell_at(drawn, layout, origin);
    if (expected_hits == drawn_hits) continue;
    const Difference difference = describe(judgement, batch, drawn, i);
    comparison.tally.add(difference.tally);
    if (comparison.first.size() < max_first) comparison.first.push_back(difference);
    differing_pixels_in_cells += difference.tally.faults + difference.tally.latitude + difference.tally.ties;
  }
  // Step 2: what differs anywhere else.
  uint64_t differing_pixels = 0;
  for (size_t i = 0; i < target_size * target_size; ++i) differing_pixels += batch.expected[i] != drawn[i] ? 1 : 0;
  comparison.tally.strays = differing_pixels - differing_pixels_in_cells;
  return comparison;
}

}  // namespace fillrule::exhaust
