#include "renderer/tile_bins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <vector>

namespace fillrule::renderer {
namespace {

// Those of a thread that takes every threads-th, in its order.
std::vector<uint32_t> tiles_of(uint32_t thread, uint32_t threads, const TileGrid& grid) {
  std::vector<uint32_t> tiles;
  for (uint32_t number = thread; number < grid.count(); number += threads) {
    tiles.push_back(grid.in_bands(number, threads));
  }
  return tiles;
}

TEST(TileGrid, HasEachTileOnceInBands) {
  for (const int32_t columns : {1, 2, 3, 7, 16}) {
    for (const int32_t rows : {1, 2, 3, 4, 5, 9, 16}) {
      const TileGrid grid({0, 0, columns * kTileSize, rows * kTileSize});
      std::vector<uint32_t> all(grid.count());
      std::iota(all.begin(), all.end(), 0U);
      for (const uint32_t threads : {1U, 2U, 3U, 5U, 256U}) {
        std::vector<uint32_t> tiles;
        for (uint32_t thread = 0; thread < threads; ++thread) {
          std::ranges::copy(tiles_of(thread, threads, grid), std::back_inserter(tiles));
        }
        std::ranges::sort(tiles);
        EXPECT_EQ(tiles, all) << columns << " x " << rows << " tiles, " << threads << " threads";
      }
    }
  }
}

// Of 4 rows and 2 threads either has two rows, which it goes along.
TEST(TileGrid, GivesAThreadNeighboursInBands) {
  const TileGrid grid({0, 0, 3 * kTileSize, 4 * kTileSize});
  EXPECT_EQ(tiles_of(0, 2, grid), (std::vector<uint32_t>{0, 3, 1, 4, 2, 5}));
  EXPECT_EQ(tiles_of(1, 2, grid), (std::vector<uint32_t>{6, 9, 7, 10, 8, 11}));
}

TEST(TileGrid, KnowsWhoseBandARowIsIn) {
  constexpr uint32_t kThreads = 3;
  const TileGrid grid({0, kTileSize, 5 * kTileSize, 13 * kTileSize});
  for (uint32_t number = 0; number < grid.count(); ++number) {
    const PixelRect pixels = grid.pixels(grid.in_bands(number, kThreads));
    EXPECT_EQ(grid.thread_of_row(pixels.top, kThreads), number % kThreads);
    EXPECT_EQ(grid.thread_of_row(pixels.bottom - 1, kThreads), number % kThreads);
  }
  EXPECT_EQ(grid.thread_of_row(-1000, kThreads), 0U);
  EXPECT_EQ(grid.thread_of_row(100'000, kThreads), 2U);
}

}  // namespace
}  // namespace fillrule::renderer
