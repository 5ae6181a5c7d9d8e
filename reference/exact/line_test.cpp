#include "reference/exact/line.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <limits>

namespace fillrule::exact {
namespace {

RasterState state_of() {
  RasterState state;
  state.viewport = {.x = 0, .y = 0, .width = 64, .height = 64, .minDepth = 0, .maxDepth = 1};
  return state;
}

ClipPosition at(double x, double y, double z = 0.5, double w = 1) {
  return {static_cast<float>((x / 32 - 1) * w), static_cast<float>((y / 32 - 1) * w), static_cast<float>(z * w),
          static_cast<float>(w)};
}

Line line(const ClipPosition& a, const ClipPosition& b, float width = 1, const RasterState& state = state_of()) {
  return Line(Segment({a, b}, {}, state), width);
}

Coverage coverage(const Line& line, double x, double y, uint32_t bits = 8) {
  return line.classify(x, y, latitude_of(state_of().viewport, bits)).coverage;
}

TEST(Line, TheSidesMoveByASubpixelEachWay) {
  for (const uint32_t bits : {4U, 8U}) {
    const double step = std::ldexp(1.0, -static_cast<int>(bits));
    // Horizontal, 3 wide; its upper side is `inside` above the sample (20.5, 20.5).
    const auto with_side_at = [](double inside) {
      return line(at(2, 20.5 + 1.5 - inside), at(60, 20.5 + 1.5 - inside), 3);
    };
    EXPECT_EQ(coverage(with_side_at(1.1 * step), 20.5, 20.5, bits), Coverage::kMust);
    EXPECT_EQ(coverage(with_side_at(0.9 * step), 20.5, 20.5, bits), Coverage::kMay);
    EXPECT_EQ(coverage(with_side_at(-0.9 * step), 20.5, 20.5, bits), Coverage::kMay);
    EXPECT_EQ(coverage(with_side_at(-1.1 * step), 20.5, 20.5, bits), Coverage::kMustNot);
  }
}

TEST(Line, TheEndsAreCutAtRightAngles) {
  const Line diagonal = line(at(10, 10), at(30, 30), 8);
  EXPECT_EQ(coverage(diagonal, 20.5, 20.5), Coverage::kMust);
  EXPECT_EQ(coverage(diagonal, 11.5, 10.5), Coverage::kMust);
  EXPECT_EQ(coverage(diagonal, 9.5, 9.5), Coverage::kMustNot);
  EXPECT_EQ(coverage(diagonal, 12.5, 8.5), Coverage::kMust);      // beside the end, beyond it in y alone
  EXPECT_EQ(coverage(diagonal, 12.5, 7.0), Coverage::kMustNot);   // projects before the end
  EXPECT_EQ(coverage(diagonal, 22.5, 17.5), Coverage::kMust);     // 3.5 away
  EXPECT_EQ(coverage(diagonal, 23.5, 17.5), Coverage::kMustNot);  // 4.2 away
}

TEST(Line, AShortLineMayBeTurnedByRoundingItsEnds) {
  // 0.05 long and 8 wide: rounding turns it by up to 1/12, which moves its corners by 0.3.
  const Line shortest = line(at(20.475, 20), at(20.525, 20), 8);
  EXPECT_EQ(coverage(shortest, 20.75, 17), Coverage::kMay);
  EXPECT_EQ(coverage(shortest, 21.5, 17), Coverage::kMustNot);
  const Line longer = line(at(19.5, 20), at(20.5, 20), 8);
  EXPECT_EQ(coverage(longer, 20.75, 17), Coverage::kMustNot);
  EXPECT_EQ(coverage(longer, 20.25, 17), Coverage::kMust);
}

TEST(Line, WithoutLengthItMayCoverWhatIsNear) {
  const Line point = line(at(20.5, 20.5), at(20.5, 20.5), 2);
  EXPECT_EQ(coverage(point, 20.5, 20.5), Coverage::kMay);
  EXPECT_EQ(coverage(point, 22.5, 20.5), Coverage::kMustNot);
}

TEST(Line, ACutThroughTheWindowsBorderLeavesTheCapOpen) {
  // Cut at x = 64, where the clipped centre line ends at right angles and the rectangle goes on to the border.
  const Line crossing = line(at(40, 40), at(80, 60), 10);
  EXPECT_EQ(coverage(crossing, 50.5, 45.5), Coverage::kMust);
  EXPECT_EQ(coverage(crossing, 63.5, 55.5), Coverage::kMay);  // inside of the border, behind the cap at (64, 52)
  EXPECT_EQ(coverage(crossing, 64.5, 48.5), Coverage::kMay);  // outside of the border, before the cap
  EXPECT_EQ(coverage(crossing, 66.5, 53.5), Coverage::kMustNot);
}

TEST(Line, BesideTheWindowItMayReachIn) {
  const Line outside = line(at(10, -1), at(50, -1), 4);
  EXPECT_EQ(coverage(outside, 20.5, 0.5), Coverage::kMay);
  EXPECT_EQ(coverage(outside, 20.5, -0.5), Coverage::kMustNot);
  EXPECT_EQ(coverage(outside, 20.5, 1.5), Coverage::kMustNot);
}

TEST(Line, InsideTheWindowItMayReachOut) {
  const Line inside = line(at(10, 1), at(50, 1), 4);
  EXPECT_EQ(coverage(inside, 20.5, 0.5), Coverage::kMust);
  EXPECT_EQ(coverage(inside, 20.5, -0.5), Coverage::kMay);
}

TEST(Line, NearAndFarPlanesEndIt) {
  const Line through = line(at(0, 20.5, -1), at(48, 20.5, 2));
  EXPECT_EQ(coverage(through, 15.5, 20.5), Coverage::kMustNot);
  EXPECT_EQ(coverage(through, 16.5, 20.5), Coverage::kMust);
  EXPECT_EQ(coverage(through, 31.5, 20.5), Coverage::kMust);
  EXPECT_EQ(coverage(through, 32.5, 20.5), Coverage::kMustNot);
  RasterState unclipped = state_of();
  unclipped.depth_clip = false;
  EXPECT_EQ(coverage(line(at(0, 20.5, -1), at(48, 20.5, 2), 1, unclipped), 15.5, 20.5), Coverage::kMust);
  EXPECT_EQ(coverage(line(at(0, 20.5, -1), at(48, 20.5, -2)), 15.5, 20.5), Coverage::kMustNot);
  RasterState symmetric = state_of();
  symmetric.negative_one_to_one = true;
  EXPECT_EQ(coverage(line(at(0, 20.5, -1), at(48, 20.5, 1), 1, symmetric), 0.5, 20.5), Coverage::kMust);
}

TEST(Line, UserClipDistancesEndIt) {
  const std::array<float, 1> in{3};
  const std::array<float, 1> out{-1};
  const Segment segment({at(8, 20.5), at(40, 20.5)}, {std::span<const float>(in), std::span<const float>(out)},
                        state_of());
  const Line half(segment, 1);  // to x = 32
  EXPECT_EQ(coverage(half, 31.5, 20.5), Coverage::kMust);
  EXPECT_EQ(coverage(half, 32.5, 20.5), Coverage::kMustNot);
}

TEST(Line, AnEndBehindTheEyeLiesBeyondTheHorizon) {
  // From (32, 20.5) towards w = -1: what is visible runs to (64, 14.75), where x = w.
  const Line through = line({0, -0.359375F, 0, 1}, {2, 0, 0, -1});
  EXPECT_FALSE(through.undefined());
  EXPECT_FALSE(through.inside_volume());
  EXPECT_EQ(coverage(through, 48.5, 17.5), Coverage::kMust);
  EXPECT_EQ(coverage(through, 48.5, 23.5), Coverage::kMustNot);
  EXPECT_EQ(coverage(through, 30.5, 20.5), Coverage::kMustNot);
}

TEST(Line, WhatVulkanLeavesUndefinedMayBeAnywhereInTheWindow) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const ClipPosition& bad : {ClipPosition{kNan, 0, 0, 1}, {FLT_MAX, 0, 0, 1}, {0, 0, 0, 0}, {0, 0, 0, 1e-40F}}) {
    EXPECT_TRUE(line(bad, at(8, 8)).undefined());
    EXPECT_EQ(coverage(line(bad, at(8, 8)), 40.5, 30.5), Coverage::kMay);
    EXPECT_EQ(coverage(line(bad, at(8, 8)), 65.5, 30.5), Coverage::kMustNot);
  }
  EXPECT_EQ(coverage(line(at(8, 8), at(50, 8), kNan), 20.5, 8.5), Coverage::kMay);
}

TEST(Line, ABlockWithoutItIsToldAtOnce) {
  const Line diagonal = line(at(10, 10), at(50, 50), 2);
  const Latitude latitude = latitude_of(state_of().viewport, 8);
  EXPECT_EQ(diagonal.classify_block({.x = 40, .y = 20, .half_width = 4, .half_height = 4}, latitude).coverage,
            Coverage::kMustNot);
  EXPECT_EQ(diagonal.classify_block({.x = 38, .y = 30, .half_width = 4, .half_height = 4}, latitude).coverage,
            Coverage::kMay);
}

}  // namespace
}  // namespace fillrule::exact
