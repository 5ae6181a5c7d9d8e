#include "renderer/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/edge_function.h"
#include "renderer/sample_locations.h"
#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

constexpr FixedPosition kCentre = pixel_centre_fixed(8);

// Whether a pixel's sample, moved right by an infinitesimal and down by its square, is inside of the triangle: the
// meaning of the top-left rule, without edge classes. All in exact integers.
bool covers(const std::array<FixedPosition, 3>& triangle, int32_t x, int32_t y, const FixedPosition& sample,
            uint32_t bits) {
  const int64_t x_sample = (int64_t{x} << bits) + sample.x_fixed;
  const int64_t y_sample = (int64_t{y} << bits) + sample.y_fixed;
  int positive = 0;
  int negative = 0;
  for (size_t i = 0; i < 3; ++i) {
    const FixedPosition& a = triangle[i];
    const FixedPosition& b = triangle[(i + 1) % 3];
    const int64_t dx = int64_t{b.x_fixed} - a.x_fixed;
    const int64_t dy = int64_t{b.y_fixed} - a.y_fixed;
    const int64_t value = dx * (y_sample - a.y_fixed) - dy * (x_sample - a.x_fixed);
    const int64_t decisive = value != 0 ? value : (dy != 0 ? -dy : dx);
    positive += decisive > 0 ? 1 : 0;
    negative += decisive < 0 ? 1 : 0;
  }
  return positive == 3 || negative == 3;
}

std::vector<bool> pixels_of(const TileCoverage& coverage) {
  std::vector<bool> pixels(size_t{kTileSize} * kTileSize);
  for (uint32_t i = 0; i < coverage.count; ++i) {
    const CoverageBlock& block = coverage.blocks[i];
    for (int32_t bit = 0; bit < 64; ++bit) {
      if ((block.mask >> bit & 1) != 0) {
        const int32_t x = block.x + bit % 8;
        const int32_t y = block.y + bit / 8;
        const size_t pixel = static_cast<size_t>(y) * kTileSize + static_cast<size_t>(x);
        EXPECT_FALSE(pixels.at(pixel)) << "twice";
        pixels.at(pixel) = true;
      }
    }
  }
  return pixels;
}

void expect_exact(const std::array<FixedPosition, 3>& triangle, const PixelRect& rect, const FixedPosition& sample,
                  uint32_t bits) {
  TileCoverage coverage;
  cover(triangle, sample, bits, rect, coverage);
  const std::vector<bool> pixels = pixels_of(coverage);
  for (int32_t y = 0; y < kTileSize; ++y) {
    for (int32_t x = 0; x < kTileSize; ++x) {
      const bool in_rect = x >= rect.left && x < rect.right && y >= rect.top && y < rect.bottom;
      const bool expected =
          in_rect && doubled_area(triangle[0], triangle[1], triangle[2]) != 0 && covers(triangle, x, y, sample, bits);
      ASSERT_EQ(pixels[static_cast<size_t>(y * kTileSize + x)], expected) << x << ", " << y;
    }
  }
}

TEST(Cover, EqualsTheDefinitionForRandomTriangles) {
  SeededRandom random;
  for (int i = 0; i < 3000; ++i) {
    const uint32_t bits = kMinSubpixelBits + random.bits() % 5;
    // From tiny to far beyond the tile, on a grid so coarse that ties are many or on every subpixel.
    const double size = std::exp2(random.uniform(0, 21)) * (1 << bits);
    const uint32_t grid_bits = random.bits() % (bits + 1);
    const double centre_x = random.uniform(0, 64 << bits);
    const double centre_y = random.uniform(0, 64 << bits);
    std::array<FixedPosition, 3> triangle;
    for (FixedPosition& vertex : triangle) {
      const auto coordinate = [&](double centre) {
        const double limit = (1 << 21) * static_cast<double>(1U << bits);
        const double value = std::clamp(centre + random.uniform(-size, size), -limit, limit);
        return static_cast<int32_t>(value) & ~((1 << grid_bits) - 1);
      };
      vertex = {coordinate(centre_x), coordinate(centre_y)};
    }
    PixelRect rect{0, 0, kTileSize, kTileSize};
    if (random.bits() % 2 == 0) {
      rect.left = static_cast<int32_t>(random.bits() % 60);
      rect.top = static_cast<int32_t>(random.bits() % 60);
      rect.right = rect.left + 1 + static_cast<int32_t>(random.bits() % static_cast<uint32_t>(64 - rect.left));
      rect.bottom = rect.top + 1 + static_cast<int32_t>(random.bits() % static_cast<uint32_t>(64 - rect.top));
    }
    const std::span<const SampleLocation> locations = standard_sample_locations(1U << random.bits() % 5);
    expect_exact(triangle, rect, locations[random.bits() % locations.size()].fixed(bits), bits);
    if (::testing::Test::HasFatalFailure()) {
      return;
    }
  }
}

TEST(Cover, TheLargestCoordinatesDoNotOverflow) {
  constexpr int32_t kLimit = 1 << 29;
  const PixelRect tile{0, 0, kTileSize, kTileSize};
  expect_exact({{{-kLimit, -kLimit}, {kLimit, -kLimit}, {-kLimit, kLimit}}}, tile, kCentre, 8);
  expect_exact({{{kLimit, kLimit}, {kLimit, -kLimit}, {-kLimit, kLimit}}}, tile, kCentre, 8);
  expect_exact({{{-kLimit, -kLimit}, {kLimit, kLimit}, {128 + 256 * 40, 127 + 256 * 40}}}, tile, kCentre, 8);
}

// An axis-aligned square on pixel centres, its diagonal too: in each of the four mirrorings and three rotations of
// the vertices exactly the samples on the left and top edges count, and the two halves share none and lose none.
TEST(Cover, TopLeftRuleInEveryMirroringAndRotation) {
  const auto at_centre = [](int32_t x, int32_t y) { return FixedPosition{x * 256 + 128, y * 256 + 128}; };
  const FixedPosition left_top = at_centre(8, 16);
  const FixedPosition right_top = at_centre(20, 16);
  const FixedPosition left_bottom = at_centre(8, 28);
  const FixedPosition right_bottom = at_centre(20, 28);
  const auto pixels = [](std::array<FixedPosition, 3> triangle, int rotation, bool is_reversed) {
    std::rotate(triangle.begin(), triangle.begin() + rotation, triangle.end());
    if (is_reversed) {
      std::reverse(triangle.begin(), triangle.end());
    }
    TileCoverage coverage;
    cover(triangle, kCentre, 8, {0, 0, kTileSize, kTileSize}, coverage);
    return pixels_of(coverage);
  };
  const auto diagonal = [&](bool is_falling, int half, int rotation, bool is_reversed) {
    const FixedPosition& corner =
        is_falling ? (half == 0 ? right_top : left_bottom) : (half == 0 ? left_top : right_bottom);
    return pixels({is_falling ? left_top : right_top, corner, is_falling ? right_bottom : left_bottom}, rotation,
                  is_reversed);
  };
  for (const bool is_falling : {false, true}) {
    for (int rotation = 0; rotation < 3; ++rotation) {
      for (const bool is_reversed : {false, true}) {
        const std::vector<bool> first = diagonal(is_falling, 0, rotation, is_reversed);
        const std::vector<bool> second = diagonal(is_falling, 1, rotation, is_reversed);
        for (int32_t y = 0; y < kTileSize; ++y) {
          for (int32_t x = 0; x < kTileSize; ++x) {
            const size_t pixel = static_cast<size_t>(y) * kTileSize + static_cast<size_t>(x);
            const bool in_square = x >= 8 && x < 20 && y >= 16 && y < 28;
            ASSERT_EQ(int{first[pixel]} + int{second[pixel]}, in_square ? 1 : 0) << x << ", " << y;
          }
        }
        // On the diagonal itself the sample belongs to the triangle to the right of it.
        const size_t on_diagonal = is_falling ? 20 * kTileSize + 12 : 20 * kTileSize + 16;
        EXPECT_EQ(is_falling ? first[on_diagonal] : second[on_diagonal], true);
      }
    }
  }
}

TEST(Cover, AFoldedPolygonCountsByParity) {
  // A fan whose second piece is turned over and lies within the first.
  const std::array<FixedPosition, 4> outline = {{{0, 0}, {40 * 256, 0}, {40 * 256, 40 * 256}, {30 * 256, 10 * 256}}};
  TileCoverage coverage;
  cover(outline, kCentre, 8, {0, 0, kTileSize, kTileSize}, coverage);
  const std::vector<bool> pixels = pixels_of(coverage);
  // The same by the way of small rectangles.
  std::vector<bool> pixels_of_blocks(pixels.size());
  for (int32_t y = 0; y < kTileSize; y += kBlockSize) {
    for (int32_t x = 0; x < kTileSize; x += kBlockSize) {
      TileCoverage one;
      cover(outline, kCentre, 8, {x, y, x + kBlockSize, y + kBlockSize}, one);
      const std::vector<bool> block = pixels_of(one);
      for (size_t pixel = 0; pixel < block.size(); ++pixel) {
        pixels_of_blocks[pixel] = pixels_of_blocks[pixel] || block[pixel];
      }
    }
  }
  EXPECT_EQ(pixels_of_blocks, pixels);
  const std::array<FixedPosition, 3> outer = {outline[0], outline[1], outline[2]};
  const std::array<FixedPosition, 3> inner = {outline[0], outline[2], outline[3]};
  size_t count = 0;
  for (int32_t y = 0; y < kTileSize; ++y) {
    for (int32_t x = 0; x < kTileSize; ++x) {
      const bool expected = covers(outer, x, y, kCentre, 8) != covers(inner, x, y, kCentre, 8);
      ASSERT_EQ(pixels[static_cast<size_t>(y * kTileSize + x)], expected);
      count += expected ? 1U : 0U;
    }
  }
  EXPECT_GT(count, 0U);
}

}  // namespace
}  // namespace fillrule::renderer
