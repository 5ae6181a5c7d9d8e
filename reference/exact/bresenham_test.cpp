#include "reference/exact/bresenham.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fillrule::exact {
namespace {

constexpr uint32_t kSize = 64;

RasterState state_of() {
  RasterState state;
  state.viewport = {.x = 0, .y = 0, .width = kSize, .height = kSize, .minDepth = 0, .maxDepth = 1};
  return state;
}

Latitude latitude(uint32_t bits = 8) {
  return latitude_of(state_of().viewport, bits);
}

ClipPosition at(double x, double y) {
  return {static_cast<float>(x / 32 - 1), static_cast<float>(y / 32 - 1), 0.5F, 1};
}

BresenhamLine line(double ax, double ay, double bx, double by, float width = 1) {
  return BresenhamLine(Segment({at(ax, ay), at(bx, by)}, {}, state_of()), width);
}

struct Position {
  double x = 0;
  double y = 0;
};

// The specification's words, with a small number for the infinitesimal one: the segment from a - (e, e^2) to
// b - (e, e^2) intersects the open diamond, and b - (e, e^2) is not in it.
bool by_the_letter(Position a, Position b, double centre_x, double centre_y) {
  constexpr double kEpsilon = 0x1p-12;
  const auto perturbed = [](Position p) { return Position{p.x - kEpsilon, p.y - kEpsilon * kEpsilon}; };
  a = perturbed(a);
  b = perturbed(b);
  if (std::abs(b.x - centre_x) + std::abs(b.y - centre_y) < 0.5) return false;
  double begin = 0;
  double end = 1;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      const double fa = 0.5 - sx * (a.x - centre_x) - sy * (a.y - centre_y);
      const double fb = 0.5 - sx * (b.x - centre_x) - sy * (b.y - centre_y);
      if (fa <= 0 && fb <= 0) return false;
      if (fa < 0) begin = std::max(begin, fa / (fa - fb));
      if (fb < 0) end = std::min(end, fa / (fa - fb));
    }
  }
  return end - begin > 1e-10;
}

TEST(BresenhamLine, OwnsWhatTheDiamondExitRuleSaysWhereverItsEndsAre) {
  // All ends on a grid of 1/4 px in 2x2 pixels, at their corners, edges and centres too.
  constexpr int kSteps = 9;
  const auto position = [](int number) {
    const int row = number / kSteps;
    return Position{20 + number % kSteps / 4.0, 30 + row / 4.0};
  };
  for (int i = 0; i < kSteps * kSteps; ++i) {
    for (int j = 0; j < kSteps * kSteps; ++j) {
      if (i == j) continue;
      const Position a = position(i);
      const Position b = position(j);
      const BresenhamLine drawn = line(a.x, a.y, b.x, b.y);
      ASSERT_TRUE(drawn.on_grid(4));
      int64_t columns = 0;
      for (int row = 28; row < 34; ++row) {
        for (int column = 18; column < 24; ++column) {
          const double x = column + 0.5;
          const double y = row + 0.5;
          const bool owns = drawn.owns(x, y);
          ASSERT_EQ(owns, by_the_letter(a, b, x, y))
              << a.x << "," << a.y << " to " << b.x << "," << b.y << " at " << x << "," << y;
          ASSERT_TRUE(!owns || drawn.classify(x, y, latitude()).coverage == Coverage::kMay);
          columns += owns ? 1 : 0;
        }
      }
      if (!drawn.has_rules(latitude())) continue;
      EXPECT_LE(drawn.columns(latitude()).least, columns);
      EXPECT_GE(drawn.columns(latitude()).most, columns);
    }
  }
}

TEST(BresenhamLine, KnowsTheDiamondsOfTheSpecificationsExamples) {
  EXPECT_TRUE(line(10.99, 20.5, 15, 20.5).classify(10.5, 20.5, latitude()).coverage == Coverage::kMay);
  EXPECT_TRUE(line(10.96875, 20.5, 15, 20.5).owns(10.5, 20.5));
  EXPECT_FALSE(line(10.96875, 20.4375, 15, 20.4375).owns(10.5, 20.5));  // just outside of the diamond
  EXPECT_TRUE(line(10.5, 20.1875, 15, 20.1875).owns(10.5, 20.5));
  EXPECT_FALSE(line(10.71875, 20.1875, 15, 20.1875).owns(10.5, 20.5));
}

TEST(BresenhamLine, SharedEndsAreNeitherDoubledNorLeftOut) {
  const BresenhamLine first = line(10.25, 20.5, 17.75, 23.125);
  const BresenhamLine second = line(17.75, 23.125, 30.5, 19);
  for (int x = 12; x < 30; ++x) {
    int fragments = 0;
    for (int y = 15; y < 30; ++y) {
      fragments += (first.owns(x + 0.5, y + 0.5) ? 1 : 0) + (second.owns(x + 0.5, y + 0.5) ? 1 : 0);
    }
    EXPECT_EQ(fragments, 1) << x;
  }
}

TEST(BresenhamLine, FragmentsMayDeviateByOnePixel) {
  const BresenhamLine horizontal = line(10.5, 20.5, 30.5, 20.5);
  for (const double y : {19.5, 20.5, 21.5}) {
    EXPECT_EQ(horizontal.classify(20.5, y, latitude()).coverage, Coverage::kMay) << y;
  }
  EXPECT_EQ(horizontal.classify(20.5, 18.5, latitude()).coverage, Coverage::kMustNot);
  EXPECT_EQ(horizontal.classify(20.5, 22.5, latitude()).coverage, Coverage::kMustNot);
  EXPECT_EQ(horizontal.classify(9.5, 20.5, latitude()).coverage, Coverage::kMay);
  EXPECT_EQ(horizontal.classify(8.5, 20.5, latitude()).coverage, Coverage::kMustNot);
  EXPECT_EQ(horizontal.classify(32.5, 20.5, latitude()).coverage, Coverage::kMustNot);
  // All samples of a pixel are one.
  EXPECT_EQ(horizontal.classify(20.1, 19.01, latitude()).coverage, Coverage::kMay);
}

TEST(BresenhamLine, WideOnesAreReplicatedAlongTheMinorAxis) {
  const BresenhamLine three = line(10.5, 20.5, 30.5, 20.5, 3);
  for (const double y : {19.5, 20.5, 21.5}) EXPECT_TRUE(three.owns(15.5, y)) << y;
  EXPECT_FALSE(three.owns(15.5, 18.5));
  EXPECT_FALSE(three.owns(15.5, 22.5));
  const BresenhamLine upright = line(10.5, 10.5, 12.5, 30.5, 2.4F);
  EXPECT_EQ(upright.width(), 2);
  int fragments = 0;
  for (int x = 5; x < 20; ++x) fragments += upright.owns(x + 0.5, 20.5) ? 1 : 0;
  EXPECT_EQ(fragments, 2);
}

TEST(BresenhamLine, HasRulesOnlyWhereTheyAreCertain) {
  EXPECT_TRUE(line(10.5, 10.5, 30.5, 20.5).has_rules(latitude()));
  EXPECT_FALSE(line(10.5, 10.5, 30.5, 30.5).has_rules(latitude()));        // rounding may change the major axis
  EXPECT_FALSE(line(10.5, 10.5, 70.5, 20.5).has_rules(latitude()));        // clipped
  EXPECT_FALSE(line(10.5, 10.5, 30.5, 20.5, 2.5F).has_rules(latitude()));  // 2 or 3 wide
  EXPECT_TRUE(line(10.5, 10.5, 10.5, 10.5).classify(10.5, 10.5, latitude()).coverage == Coverage::kMay);
}

TEST(BresenhamLine, OffTheGridNothingIsOwned) {
  EXPECT_FALSE(line(10.5 + 1.0 / 512, 10.5, 30.5, 20.5).on_grid(8));
  EXPECT_TRUE(line(10.5 + 1.0 / 256, 10.5, 30.5, 20.5).on_grid(8));
  EXPECT_FALSE(line(10.5 + 1.0 / 256, 10.5, 30.5, 20.5).on_grid(4));
  EXPECT_FALSE(line(10.5, 10.5, 70.5, 20.5).on_grid(8));
}

}  // namespace
}  // namespace fillrule::exact
