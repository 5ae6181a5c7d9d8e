#include "harness/exhaust/case_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "harness/exhaust/batch.h"
#include "reference/exact/small_world.h"
#include "reference/vulkan/hit_draw.h"

namespace fillrule::exhaust {
namespace {

exact::GridPosition grid_position(const World& world, uint32_t number) {
  const uint32_t side = world.grid * world.size + 1;
  return {number % side, number / side};
}

char symbol_of(uint8_t hits) {
  switch (hits) {
    case 0:
      return '.';
    case vulkan::kHit:
      return '#';
    case vulkan::kFrontHit:
      return 'F';
    default:
      return '?';
  }
}

std::string meaning_of(const Tally& tally) {
  if (tally.faults > 0) return "a fault";
  return tally.latitude > 0 ? "within the latitude of snapping" : "a tie, against the top-left rule alone";
}

}  // namespace

std::string vertices_text(const World& world, const Triple& triple) {
  std::string text;
  for (const uint32_t number : triple) {
    const exact::GridPosition at = grid_position(world, number);
    text += fmt::format("{}({}, {})", text.empty() ? "" : " ", static_cast<double>(at.x) / world.grid,
                        static_cast<double>(at.y) / world.grid);
  }
  return text;
}

std::string difference_text(const World& world, const std::string& party, const Difference& difference) {
  std::string text = fmt::format("{} draws triangle {} otherwise, {} px: {}\n", party, difference.number,
                                 vertices_text(world, difference.vertices), meaning_of(difference.tally));
  text += "  expected drawn\n";
  for (uint32_t row = 0; row < world.size; ++row) {
    std::string expected;
    std::string drawn;
    for (uint32_t column = 0; column < world.size; ++column) {
      expected += symbol_of(difference.expected[row * world.size + column]);
      drawn += symbol_of(difference.drawn[row * world.size + column]);
    }
    text += fmt::format("  {:<8} {}\n", expected, drawn);
  }
  return text;
}

Case difference_case(const World& world, const std::string& party, const Difference& difference) {
  const uint32_t size = std::bit_ceil(world.size);
  Draw draw;
  draw.state.viewport = {.width = static_cast<float>(size), .height = static_cast<float>(size), .maxDepth = 1.0F};
  draw.state.scissor = {.extent = {size, size}};
  for (const uint32_t number : difference.vertices) {
    const exact::GridPosition at = grid_position(world, number);
    const float scale = 2.0F / static_cast<float>(size * world.grid);  // exact: a power of two
    draw.positions.push_back(
        {static_cast<float>(at.x) * scale - 1.0F, static_cast<float>(at.y) * scale - 1.0F, 0.5F, 1.0F});
  }
  return {.name = fmt::format("{}x{}-{}-{}", world.grid, world.size, party, difference.number),
          .title = fmt::format("Triangle {} px", vertices_text(world, difference.vertices)),
          .why = fmt::format("fillrule exhaust --grid {} --size {} found that {} draws it otherwise than the oracle, "
                             "as one of many in a large target: {}.",
                             world.grid, world.size, party, meaning_of(difference.tally)),
          .spec = "Basic Polygon Rasterization",
          .tags = {"exhaust"},
          .target = {.width = size, .height = size},
          .draws = {std::move(draw)}};
}

}  // namespace fillrule::exhaust
