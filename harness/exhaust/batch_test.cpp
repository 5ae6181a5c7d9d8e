#include "harness/exhaust/batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace fillrule::exhaust {
namespace {

using testing::ElementsAre;

TEST(CellLayout, CellsLieSideBySideWithinAnEmptyRing) {
  for (const uint32_t size : {1U, 2U, 3U, 4U}) {
    const CellLayout layout({.grid = 4, .size = size}, 64);
    std::set<std::pair<uint32_t, uint32_t>> pixels;
    for (uint32_t cell = 0; cell < layout.capacity(); ++cell) {
      const Pixel origin = layout.origin(cell);
      ASSERT_GE(origin.x, size);
      ASSERT_LE(origin.x + 2 * size, 64U);
      ASSERT_GE(origin.y, size);
      ASSERT_LE(origin.y + 2 * size, 64U);
      for (uint32_t i = 0; i < size * size; ++i) {
        ASSERT_TRUE(pixels.insert({origin.x + i % size, origin.y + i / size}).second) << "two cells share a pixel";
      }
    }
    EXPECT_EQ(pixels.size(), layout.capacity() * size * size);
  }
}

TEST(CellLayout, AboutAMillionCellsFitIntoTheDefaultTarget) {
  for (const uint32_t size : {1U, 2U, 3U, 4U}) {
    const CellLayout layout({.grid = 16, .size = size}, CellLayout::default_target_size(size));
    EXPECT_GE(layout.capacity(), 1'000'000U);
    EXPECT_LE(layout.target_size(), 8192U);
  }
}

// Every coordinate of the largest target goes to clip space and back without rounding.
TEST(CellLayout, PositionsAreExactInFloat32) {
  const World world{.grid = 16, .size = 4};
  const CellLayout layout(world, 4096);
  for (uint32_t pixel = 0; pixel < 4096; ++pixel) {
    for (uint32_t step = 0; step <= 16; ++step) {
      const auto [x, y] = layout.position({pixel, 4095 - pixel}, {step, 16 - step});
      ASSERT_EQ((double{x} + 1) * 2048 * 16, pixel * 16.0 + step);
      ASSERT_EQ((double{y} + 1) * 2048 * 16, (4095.0 - pixel) * 16 + 16 - step);
    }
  }
}

TEST(ExpectedHits, FrontFacesAreCounterClockwise) {
  EXPECT_THAT(expected_hits({.clockwise = 0b1010}, 2, 0), testing::Contains(1).Times(2));
  const CellHits front = expected_hits({.counter_clockwise = 0b0010}, 2, 0);
  EXPECT_EQ(front[1], 0x11);
  EXPECT_EQ(expected_hits({.counter_clockwise = 0b0010}, 2, VK_CULL_MODE_BACK_BIT), front);
  EXPECT_EQ(expected_hits({.counter_clockwise = 0b0010}, 2, VK_CULL_MODE_FRONT_BIT), CellHits{});
  EXPECT_EQ(expected_hits({.clockwise = 0b0010}, 2, VK_CULL_MODE_BACK_BIT), CellHits{});
}

TEST(Fill, PutsTrianglesAndTheirHitsIntoTheirCells) {
  const World world{.grid = 1, .size = 1};
  const exact::SmallWorld oracle(1, 1);
  const CellLayout layout(world, 8);
  // Positions 0 1 / 2 3: the triples from (0, 1, 2) on. Its edge 1 to 2 has the pixel's centre on it, and is neither
  // top nor left; that of (0, 1, 3), from 3 to 0, is a left one.
  Batch batch;
  fill(world, oracle, layout, 0, 6, 2, batch);
  EXPECT_EQ(batch.triangles, 2U);
  EXPECT_EQ(batch.covering, 1U);
  EXPECT_THAT(batch.positions_clip,
              ElementsAre(PlanePosition{-0.75F, -0.75F}, PlanePosition{-0.5F, -0.75F}, PlanePosition{-0.75F, -0.5F},
                          PlanePosition{-0.5F, -0.75F}, PlanePosition{-0.25F, -0.75F}, PlanePosition{-0.25F, -0.5F}));
  std::vector<uint8_t> expected(64, 0);
  expected[8 + 2] = 1;
  EXPECT_EQ(batch.expected, expected);
}

}  // namespace
}  // namespace fillrule::exhaust
