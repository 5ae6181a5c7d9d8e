#include "renderer/line_clip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

// The sides, near and far of the volume -w <= x, y <= w, 0 <= z <= w.
std::vector<EndDistances> volume(const ClipPosition& from, const ClipPosition& to) {
  const auto plane = [&](double x, double y, double z, double w) {
    const auto distance = [&](const ClipPosition& p) {
      return DoubleDouble(x) * p[0] + DoubleDouble(y) * p[1] + DoubleDouble(z) * p[2] + DoubleDouble(w) * p[3];
    };
    return EndDistances{distance(from), distance(to)};
  };
  return {plane(1, 0, 0, 1),  plane(-1, 0, 0, 1), plane(0, 1, 0, 1),
          plane(0, -1, 0, 1), plane(0, 0, 1, 0),  plane(0, 0, -1, 1)};
}

std::optional<VisibleSegment> clip_to_volume(const ClipPosition& from, const ClipPosition& to) {
  return clip_segment(from, to, volume(from, to));
}

void expect_at(const SegmentEnd& end, double x, double y, double z) {
  EXPECT_NEAR(end.position.x / end.position.w, x, 1e-15);
  EXPECT_NEAR(end.position.y / end.position.w, y, 1e-15);
  EXPECT_NEAR(end.position.z / end.position.w, z, 1e-15);
}

TEST(ClipSegment, OneInsideStaysAsItIs) {
  const auto visible = clip_to_volume({-0.5F, 0.25F, 0.5F, 1}, {1, -1, 1, 2});
  ASSERT_TRUE(visible);
  EXPECT_TRUE(visible->from.is_vertex && visible->to.is_vertex);
  expect_at(visible->from, -0.5, 0.25, 0.5);
  expect_at(visible->to, 0.5, -0.5, 0.5);
}

TEST(ClipSegment, IsCutAtEachPlane) {
  const auto cut = [](const ClipPosition& outside, double x, double y, double z) {
    const ClipPosition inside{0, 0, 0.5F, 1};
    const auto entering = clip_to_volume(outside, inside);
    const auto leaving = clip_to_volume(inside, outside);
    ASSERT_TRUE(entering && leaving);
    EXPECT_TRUE(!entering->from.is_vertex && entering->to.is_vertex);
    EXPECT_TRUE(leaving->from.is_vertex && !leaving->to.is_vertex);
    expect_at(entering->from, x, y, z);
    expect_at(leaving->to, x, y, z);
  };
  cut({-4, 0, 0.5F, 1}, -1, 0, 0.5);
  cut({4, 0, 0.5F, 1}, 1, 0, 0.5);
  cut({0, -2, 0.5F, 1}, 0, -1, 0.5);
  cut({0, 2, 0.5F, 1}, 0, 1, 0.5);
  cut({0, 0.5F, -0.5F, 1}, 0, 0.25, 0);
  cut({0, 0.5F, 1.5F, 1}, 0, 0.25, 1);
}

TEST(ClipSegment, NothingIsLeftOfOneOutside) {
  EXPECT_FALSE(clip_to_volume({-2, 0, 0.5F, 1}, {-3, 0, 0.5F, 1}));
  // Past a corner: each end is outside of another plane.
  EXPECT_FALSE(clip_to_volume({-3, 0, 0.5F, 1}, {0, 3, 0.5F, 1}));
  // Through an edge of the volume: one point.
  EXPECT_FALSE(clip_to_volume({-2, 0, 0.5F, 1}, {0, 2, 0.5F, 1}));
  EXPECT_FALSE(clip_to_volume({0, 0, 0, 0}, {0, 0, 0, 0}));
}

TEST(ClipSegment, ThroughTheEyeOnlyThePartInFrontIsSeen) {
  const auto visible = clip_to_volume({0, 0, 0.5F, 1}, {4, 0, 0.5F, -1});
  ASSERT_TRUE(visible);
  // x = 4t, w = 1 - 2t: equal at t = 1/6, in front of the eye.
  expect_at(visible->to, 1, 0, 0.75);
}

// All that is left is inside, and all of the segment that is inside is left.
TEST(ClipSegment, IsThePartInsideOfAllPlanes) {
  SeededRandom random;
  for (int i = 0; i < 20000; ++i) {
    const auto position = [&] {
      const auto coordinate = [&](double extent) { return static_cast<float>(random.uniform(-extent, extent)); };
      return ClipPosition{coordinate(3), coordinate(3), coordinate(3), coordinate(2)};
    };
    const ClipPosition from = position();
    const ClipPosition to = position();
    const std::vector<EndDistances> planes = volume(from, to);
    double first = 0;
    double last = 1;
    for (const auto& [a, b] : planes) {
      const double t = a.high / (a.high - b.high);
      if (a.high < 0) first = std::max(first, b.high < 0 ? 2 : t);
      if (b.high < 0) last = std::min(last, a.high < 0 ? -1 : t);
    }
    const auto visible = clip_segment(from, to, planes);
    ASSERT_EQ(visible.has_value(), first < last);
    if (!visible) {
      continue;
    }
    const auto expect_near = [&](const SegmentEnd& end, double t) {
      const double w = (1 - t) * double{from[3]} + t * double{to[3]};
      const double x = (1 - t) * double{from[0]} + t * double{to[0]};
      ASSERT_NEAR(end.position.x / end.position.w, x / w, 1e-9 / w);
    };
    expect_near(visible->from, first);
    expect_near(visible->to, last);
  }
}

// What is left of a segment between 1e20 and -1e20 is decided by the last bits of more than a double.
TEST(ClipSegment, HugeSegmentsAreCutExactly) {
  const auto visible = clip_to_volume({-1e20F, -1e20F, 0.5F, 1}, {1e20F, 1e20F, 0.5F, 1});
  ASSERT_TRUE(visible);
  expect_at(visible->from, -1, -1, 0.5);
  expect_at(visible->to, 1, 1, 0.5);
}

}  // namespace
}  // namespace fillrule::renderer
