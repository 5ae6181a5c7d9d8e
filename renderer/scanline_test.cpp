#include "renderer/scanline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/clip.h"
#include "renderer/edge_function.h"
#include "renderer/stepped_quotient.h"
#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

using TileRows = std::array<uint64_t, kTileSize>;  // bit x of word y: a pixel of the tile at (0, 0)

TileRows rows_of(const TileCoverage& coverage) {
  TileRows rows{};
  for (uint32_t i = 0; i < coverage.count; ++i) {
    const CoverageBlock& block = coverage.blocks[i];
    for (int32_t bit = 0; bit < 64; ++bit) {
      if ((block.mask >> bit & 1) != 0) {
        rows.at(static_cast<size_t>(block.y) + static_cast<size_t>(bit) / 8) ^= uint64_t{1} << (block.x + bit % 8);
      }
    }
  }
  return rows;
}

// For the sample at (x_sample, y_sample) of each pixel, the edge functions of every triangle of the fan.
TileRows rows_by_edge_functions(std::span<const FixedPosition> outline, const FixedPosition& sample, uint32_t bits,
                                const PixelRect& rect) {
  TileRows rows{};
  for (size_t i = 2; i < outline.size(); ++i) {
    std::array<FixedPosition, 3> triangle = {outline[0], outline[i - 1], outline[i]};
    const int64_t area = doubled_area(triangle[0], triangle[1], triangle[2]);
    if (area == 0) {
      continue;
    }
    if (area < 0) {
      std::swap(triangle[1], triangle[2]);
    }
    for (int32_t y = rect.top; y < rect.bottom; ++y) {
      for (int32_t x = rect.left; x < rect.right; ++x) {
        bool is_inside = true;
        for (size_t k = 0; k < 3; ++k) {
          is_inside = is_inside && edge_function(triangle[k], triangle[(k + 1) % 3], sample, bits).at(x, y) >= 0;
        }
        rows[static_cast<size_t>(y)] ^= static_cast<uint64_t>(is_inside) << x;
      }
    }
  }
  return rows;
}

class Scene {
 public:
  // A polygon from tiny to far beyond the tile, on a grid so coarse that ties are many or on every subpixel; thin
  // where `flatness` says so.
  std::vector<FixedPosition> polygon(size_t count) {
    const double size = std::exp2(random_.uniform(0, 21)) * (1 << bits_);
    const double thinness = random_.bits() % 3 == 0 ? 1e-3 : 1;
    const int32_t grid = ~((1 << random_.bits() % (bits_ + 1)) - 1);
    const bool is_steep = random_.bits() % 2 == 0;
    const double centre_x = random_.uniform(0, 64 << bits_);
    const double centre_y = random_.uniform(0, 64 << bits_);
    const auto coordinate = [&](double centre, double extent) {
      const double limit = (1 << 21) * static_cast<double>(1U << bits_);
      return static_cast<int32_t>(std::clamp(centre + random_.uniform(-extent, extent), -limit, limit)) & grid;
    };
    std::vector<FixedPosition> polygon(count);
    for (FixedPosition& vertex : polygon) {
      vertex = {coordinate(centre_x, is_steep ? size * thinness : size),
                coordinate(centre_y, is_steep ? size : size * thinness)};
    }
    return polygon;
  }

  PixelRect rect() {
    if (random_.bits() % 2 == 0) {
      return {0, 0, kTileSize, kTileSize};
    }
    const auto low = [&] { return static_cast<int32_t>(random_.bits() % 60); };
    const auto extent = [&](int32_t from) {
      return 1 + static_cast<int32_t>(random_.bits() % static_cast<uint32_t>(kTileSize - from));
    };
    PixelRect rect{low(), low(), 0, 0};
    rect.right = rect.left + extent(rect.left);
    rect.bottom = rect.top + extent(rect.top);
    return rect;
  }

  FixedPosition sample() {
    const uint32_t mask = (1U << bits_) - 1;
    return {static_cast<int32_t>(random_.bits() & mask), static_cast<int32_t>(random_.bits() & mask)};
  }

  void choose_bits() { bits_ = kMinSubpixelBits + random_.bits() % 5; }
  [[nodiscard]] uint32_t bits() const { return bits_; }
  uint32_t number(uint32_t below) { return random_.bits() % below; }

 private:
  SeededRandom random_;
  uint32_t bits_ = kMaxSubpixelBits;
};

TEST(SteppedQuotient, EqualsTheDivisionAfterAnyNumberOfSteps) {
  SeededRandom random;
  for (int i = 0; i < 2000; ++i) {
    const auto dividend = static_cast<int64_t>(random.uniform(-0x1p40, 0x1p40));
    const auto step = static_cast<int64_t>(random.uniform(-1, 1) * std::exp2(random.uniform(0, 30)));
    const int64_t divisor = 1 + static_cast<int64_t>(std::exp2(random.uniform(0, 30)));
    SteppedQuotient quotient(dividend, step, divisor);
    for (int64_t k = 0; k < 40; ++k) {
      const int64_t exact = dividend + k * step;
      ASSERT_LE(quotient.value() * divisor, exact);
      ASSERT_GT((quotient.value() + 1) * divisor, exact);
      quotient.step();
    }
  }
}

TEST(Scanline, EqualsTheEdgeFunctionsOfTrianglesForAnySample) {
  Scene scene;
  for (int i = 0; i < 4000; ++i) {
    scene.choose_bits();
    const std::vector<FixedPosition> triangle = scene.polygon(3);
    const FixedPosition sample = scene.sample();
    const PixelRect rect = scene.rect();
    TileCoverage coverage;
    cover_by_scanlines(triangle, sample, scene.bits(), rect, coverage);
    ASSERT_EQ(rows_of(coverage), rows_by_edge_functions(triangle, sample, scene.bits(), rect)) << i;
  }
}

// Polygons that cross themselves are the worst that clipping and snapping can make; the parity counts.
TEST(Scanline, EqualsTheEdgeFunctionsOfPolygons) {
  Scene scene;
  for (int i = 0; i < 2000; ++i) {
    scene.choose_bits();
    const std::vector<FixedPosition> polygon = scene.polygon(3 + scene.number(kMaxPolygonVertices - 2));
    const FixedPosition sample = scene.sample();
    const PixelRect rect = scene.rect();
    TileCoverage coverage;
    cover_by_scanlines(polygon, sample, scene.bits(), rect, coverage);
    ASSERT_EQ(rows_of(coverage), rows_by_edge_functions(polygon, sample, scene.bits(), rect)) << i;
  }
}

// Every triangle on a grid of 1/2 px in 3x3 px, with the sample on the grid: all ties that there are.
TEST(Scanline, EqualsTheEdgeFunctionsOfAllSmallTrianglesWithTies) {
  constexpr uint32_t kBits = 4;
  constexpr int32_t kGrid = 8;
  constexpr uint32_t kPoints = 6;
  const FixedPosition sample{kGrid, kGrid};
  const PixelRect rect{0, 0, 4, 4};
  const auto vertex = [](uint32_t i) {
    return FixedPosition{static_cast<int32_t>(i % kPoints) * kGrid, static_cast<int32_t>(i / kPoints) * kGrid};
  };
  for (uint32_t a = 0; a < kPoints * kPoints; ++a) {
    for (uint32_t b = 0; b < kPoints * kPoints; ++b) {
      for (uint32_t c = 0; c < kPoints * kPoints; ++c) {
        const std::array<FixedPosition, 3> triangle = {vertex(a), vertex(b), vertex(c)};
        TileCoverage coverage;
        cover_by_scanlines(triangle, sample, kBits, rect, coverage);
        ASSERT_EQ(rows_of(coverage), rows_by_edge_functions(triangle, sample, kBits, rect))
            << a << ' ' << b << ' ' << c;
      }
    }
  }
}

TEST(Scanline, TheLargestCoordinatesDoNotOverflow) {
  constexpr int32_t kLimit = 1 << 29;
  const PixelRect tile{0, 0, kTileSize, kTileSize};
  const FixedPosition centre{128, 128};
  const std::vector<std::array<FixedPosition, 3>> triangles = {
      {{{-kLimit, -kLimit}, {kLimit, -kLimit}, {-kLimit, kLimit}}},
      {{{kLimit, kLimit}, {kLimit, -kLimit}, {-kLimit, kLimit}}},
      {{{-kLimit, -kLimit}, {kLimit, kLimit}, {128 + 256 * 40, 127 + 256 * 40}}},
      {{{-kLimit, 256 * 20}, {kLimit, 256 * 20 + 1}, {kLimit, 256 * 20 + 200}}}};
  for (const auto& triangle : triangles) {
    TileCoverage coverage;
    cover_by_scanlines(triangle, centre, 8, tile, coverage);
    EXPECT_EQ(rows_of(coverage), rows_by_edge_functions(triangle, centre, 8, tile));
  }
}

// Whole draws, clipped by near plane and guard band too: not a byte of any plane differs.
TEST(Scanline, DrawsEqualThoseOfTheEdgeFunctions) {
  SeededRandom random;
  for (const uint32_t samples : {1U, 2U, 4U, 8U, 16U}) {
    TestScene scene(100, 90);
    scene.samples = samples;
    scene.state.depth_test = true;
    scene.state.viewport = {-3.25F, 2.5F, 90, 80, 0, 1};
    for (int i = 0; i < 300; ++i) {
      const double size = i % 9 < 3 ? std::exp2(random.uniform(0, 20)) : 1.5;
      const auto coordinate = [&](double extent) { return static_cast<float>(random.uniform(-extent, extent)); };
      const float w = i % 9 < 3 ? coordinate(2) : 1;
      scene.positions.push_back({coordinate(size), coordinate(size), 0.5F + coordinate(0.6), w});
      scene.values.push_back(coordinate(1));
    }
    const TestPlanes expected = render(scene);
    EXPECT_LT(count_of(expected.hits, 0), expected.hits.size() / 2);
    EXPECT_TRUE(same_bytes(render(scene, {.fill = Fill::kScanline}), expected)) << samples << " samples";
  }
}

}  // namespace
}  // namespace fillrule::renderer
