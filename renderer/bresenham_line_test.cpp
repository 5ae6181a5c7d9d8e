#include "renderer/bresenham_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

using Pixels = std::multiset<std::pair<int32_t, int32_t>>;

constexpr PixelRect kTile{0, 0, kTileSize, kTileSize};

void add_pixels(const BresenhamLine& line, uint32_t bits, const PixelRect& rect, Pixels& pixels) {
  TileCoverage coverage;
  cover_by_diamond_exit(line, bits, rect, coverage);
  for (uint32_t i = 0; i < coverage.count; ++i) {
    const CoverageBlock& block = coverage.blocks[i];
    for (int32_t bit = 0; bit < 64; ++bit) {
      if ((block.mask >> bit & 1) != 0) {
        pixels.emplace(block.x + bit % 8, block.y + bit / 8);
      }
    }
  }
}

Pixels pixels_of(const BresenhamLine& line, uint32_t bits, const PixelRect& rect = kTile) {
  Pixels pixels;
  add_pixels(line, bits, rect, pixels);
  return pixels;
}

// The rule word by word, with e = 2^-12 subpixels, which is small enough for coordinates below 2^8 subpixels: those
// are counted in e^2 here. A segment meets a diamond if an end is inside or if it crosses one of the two diagonals.
class DiamondExit {
 public:
  DiamondExit(const FixedPosition& a, const FixedPosition& b, uint32_t bits)
      : a_(perturbed(a)), b_(perturbed(b)), bits_(bits) {}

  [[nodiscard]] bool covers(int32_t x, int32_t y) const {
    const int64_t half = kUnit << (bits_ - 1);
    const Point centre{(int64_t{x} << bits_) * kUnit + half, (int64_t{y} << bits_) * kUnit + half};
    const auto is_inside = [&](const Point& p) { return std::abs(p.x - centre.x) + std::abs(p.y - centre.y) < half; };
    const bool meets = is_inside(a_) || crosses({centre.x - half, centre.y}, {centre.x + half, centre.y}) ||
                       crosses({centre.x, centre.y - half}, {centre.x, centre.y + half});
    return meets && !is_inside(b_);
  }

 private:
  static constexpr int64_t kUnit = int64_t{1} << 24;

  struct Point {
    int64_t x;
    int64_t y;
  };

  static Point perturbed(const FixedPosition& p) {
    return {p.x_fixed * kUnit - (int64_t{1} << 12), p.y_fixed * kUnit - 1};
  }

  // Which side of the line through p and q; their distance in subpixels keeps the product small.
  static int side(const Point& p, const Point& q, const Point& r) {
    const int64_t dx = (q.x - p.x) / kUnit;
    const int64_t dy = (q.y - p.y) / kUnit;
    const int64_t value = dx * (r.y - p.y) - dy * (r.x - p.x);
    return value < 0 ? -1 : (value > 0 ? 1 : 0);
  }

  [[nodiscard]] bool crosses(const Point& p, const Point& q) const {
    return side(a_, b_, p) * side(a_, b_, q) < 0 && side(p, q, a_) * side(p, q, b_) < 0;
  }

  Point a_;
  Point b_;
  uint32_t bits_;
};

Pixels pixels_by_definition(const FixedPosition& a, const FixedPosition& b, uint32_t bits, const PixelRect& rect) {
  const DiamondExit rule(a, b, bits);
  Pixels pixels;
  for (int32_t y = rect.top; y < rect.bottom; ++y) {
    for (int32_t x = rect.left; x < rect.right; ++x) {
      if (rule.covers(x, y)) {
        pixels.emplace(x, y);
      }
    }
  }
  return pixels;
}

// Every pair of ends on a grid of 1/4 px: all ties at diamonds' borders and corners, all octants.
TEST(BresenhamLine, EqualsTheDiamondExitRuleForAllSmallLines) {
  constexpr uint32_t kBits = 4;
  constexpr int32_t kGrid = 4;
  constexpr int32_t kPoints = 17;
  const PixelRect rect{0, 0, 6, 6};
  const auto end = [](int32_t i) { return FixedPosition{16 + i % kPoints * kGrid, 16 + i / kPoints * kGrid}; };
  for (int32_t i = 0; i < kPoints * kPoints; ++i) {
    for (int32_t k = 0; k < kPoints * kPoints; ++k) {
      const FixedPosition a = end(i);
      const FixedPosition b = end(k);
      ASSERT_EQ(pixels_of({a, b}, kBits, rect), pixels_by_definition(a, b, kBits, rect))
          << a.x_fixed << ',' << a.y_fixed << " to " << b.x_fixed << ',' << b.y_fixed;
    }
  }
}

TEST(BresenhamLine, EqualsTheDiamondExitRuleForRandomLines) {
  SeededRandom random;
  constexpr uint32_t kBits = 4;
  const PixelRect rect{0, 0, 16, 16};
  for (int i = 0; i < 20000; ++i) {
    const auto coordinate = [&] { return static_cast<int32_t>(random.bits() % 256); };
    const FixedPosition a{coordinate(), coordinate()};
    const FixedPosition b{coordinate(), coordinate()};
    ASSERT_EQ(pixels_of({a, b}, kBits, rect), pixels_by_definition(a, b, kBits, rect))
        << a.x_fixed << ',' << a.y_fixed << " to " << b.x_fixed << ',' << b.y_fixed;
  }
}

// The second segment goes on straight from the end of the first: together they are the whole, no pixel twice.
TEST(BresenhamLine, SegmentsThatShareAnEndNeitherShareNorLoseAPixel) {
  SeededRandom random;
  for (int i = 0; i < 5000; ++i) {
    const auto coordinate = [&] { return static_cast<int32_t>(random.bits() % (20 * 256)) + 20 * 256; };
    const auto distance = [&] { return static_cast<int32_t>(random.bits() % (8 * 256)) - 4 * 256; };
    const FixedPosition a{coordinate(), coordinate()};
    const FixedPosition step{distance(), distance()};
    const FixedPosition b{a.x_fixed + step.x_fixed, a.y_fixed + step.y_fixed};
    const FixedPosition c{b.x_fixed + step.x_fixed, b.y_fixed + step.y_fixed};
    Pixels parts = pixels_of({a, b}, 8);
    add_pixels({b, c}, 8, kTile, parts);
    ASSERT_EQ(parts, pixels_of({a, c}, 8));
  }
}

TEST(BresenhamLine, BetweenPixelCentresAllButTheLastPixelAreDrawn) {
  const auto centre = [](int32_t x, int32_t y) { return FixedPosition{x * 256 + 128, y * 256 + 128}; };
  EXPECT_EQ(pixels_of({centre(2, 3), centre(6, 3)}, 8), (Pixels{{2, 3}, {3, 3}, {4, 3}, {5, 3}}));
  EXPECT_EQ(pixels_of({centre(6, 3), centre(2, 3)}, 8), (Pixels{{6, 3}, {5, 3}, {4, 3}, {3, 3}}));
  EXPECT_EQ(pixels_of({centre(2, 3), centre(2, 6)}, 8), (Pixels{{2, 3}, {2, 4}, {2, 5}}));
  EXPECT_EQ(pixels_of({centre(2, 2), centre(5, 5)}, 8), (Pixels{{2, 2}, {3, 3}, {4, 4}}));
  EXPECT_EQ(pixels_of({centre(2, 2), centre(2, 2)}, 8), Pixels{});
}

TEST(BresenhamLine, WideOnesAreColumnsOrRowsOfTheirWidth) {
  const auto centre = [](int32_t x, int32_t y) { return FixedPosition{x * 256 + 128, y * 256 + 128}; };
  // An odd width is centred on the line; an even one, on a row of centres, is moved by half a pixel and meets a tie,
  // which goes up or to the left; but down where moving the line a bit to the left moves it down.
  EXPECT_EQ(pixels_of({centre(2, 5), centre(4, 5), 3}, 8), (Pixels{{2, 4}, {2, 5}, {2, 6}, {3, 4}, {3, 5}, {3, 6}}));
  EXPECT_EQ(pixels_of({centre(2, 5), centre(4, 5), 2}, 8), (Pixels{{2, 4}, {2, 5}, {3, 4}, {3, 5}}));
  EXPECT_EQ(pixels_of({centre(5, 2), centre(5, 4), 2}, 8), (Pixels{{4, 2}, {5, 2}, {4, 3}, {5, 3}}));
  EXPECT_EQ(pixels_of({centre(2, 2), centre(4, 4), 2}, 8), (Pixels{{2, 2}, {2, 3}, {3, 3}, {3, 4}}));
}

TEST(BresenhamLine, EveryColumnOfAWideLineIsTheMovedLineRepeated) {
  SeededRandom random;
  for (int i = 0; i < 2000; ++i) {
    const auto coordinate = [&] { return static_cast<int32_t>(random.bits() % (30 * 256)) + 15 * 256; };
    const auto width = static_cast<int32_t>(1 + random.bits() % 9);
    BresenhamLine line{{coordinate(), coordinate()}, {coordinate(), coordinate()}, static_cast<uint32_t>(width)};
    const Pixels wide = pixels_of(line, 8);
    const bool x_major = is_x_major(line);
    for (FixedPosition* end : {&line.a, &line.b}) {
      (x_major ? end->y_fixed : end->x_fixed) -= (width - 1) * 128;
    }
    line.width = 1;
    Pixels repeated;
    for (const auto& [x, y] : pixels_of(line, 8)) {
      for (int32_t k = 0; k < width; ++k) {
        repeated.emplace(x_major ? x : x + k, x_major ? y + k : y);
      }
    }
    ASSERT_EQ(wide, repeated);
  }
}

TEST(BresenhamLine, TilesAndBoundsHoldAllOfIt) {
  SeededRandom random;
  for (int i = 0; i < 500; ++i) {
    const auto coordinate = [&] { return static_cast<int32_t>(random.bits() % (120 * 256)) + 4 * 256; };
    const BresenhamLine line{{coordinate(), coordinate()}, {coordinate(), coordinate()}, 1 + random.bits() % 4};
    const PixelRect bounds = bounding_pixels(line, 8);
    Pixels tiles;
    Pixels parts;
    for (int32_t y = 0; y < 128; y += kTileSize) {
      for (int32_t x = 0; x < 128; x += kTileSize) {
        const PixelRect tile{x, y, x + kTileSize, y + kTileSize};
        add_pixels(line, 8, tile, tiles);
        for (int32_t part = 0; part < kTileSize; part += 16) {
          add_pixels(line, 8, {x + part, y, x + part + 16, y + 23}, parts);
          add_pixels(line, 8, {x + part, y + 23, x + part + 16, y + kTileSize}, parts);
        }
      }
    }
    ASSERT_EQ(tiles, parts);
    for (const auto& [x, y] : tiles) {
      ASSERT_TRUE(x >= bounds.left && x < bounds.right && y >= bounds.top && y < bounds.bottom) << x << ", " << y;
    }
    // One for each row or column that the line spans, but for the ends.
    const int32_t length =
        std::max(std::abs(line.b.x_fixed - line.a.x_fixed), std::abs(line.b.y_fixed - line.a.y_fixed));
    ASSERT_NEAR(static_cast<double>(tiles.size()) / line.width, length / 256.0, 2);
  }
}

TEST(BresenhamLine, WidthsAreRoundedToWholePixels) {
  EXPECT_EQ(bresenham_width(0.25F), 1U);
  EXPECT_EQ(bresenham_width(1.0F), 1U);
  EXPECT_EQ(bresenham_width(1.5F), 2U);
  EXPECT_EQ(bresenham_width(7.4F), 7U);
}

}  // namespace
}  // namespace fillrule::renderer
