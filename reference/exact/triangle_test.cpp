#include "reference/exact/triangle.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <limits>

#include "reference/exact/rational_triangle.h"

namespace fillrule::exact {
namespace {

constexpr VkViewport kViewport{.x = 0, .y = 0, .width = 64, .height = 64, .minDepth = 0, .maxDepth = 1};
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

ClipPosition at(double x, double y, double z = 0.5, double w = 1) {
  return {static_cast<float>((x / 32 - 1) * w), static_cast<float>((y / 32 - 1) * w), static_cast<float>(z * w),
          static_cast<float>(w)};
}

Coverage coverage(const Triangle& triangle, double x, double y, uint32_t bits = 8) {
  return triangle.classify(x, y, latitude_of(kViewport, bits)).coverage;
}

TEST(Triangle, TheLatitudeIsHalfASubpixelOnEachSideOfAnEdge) {
  for (const uint32_t bits : {4U, 8U}) {
    const double half_step = std::ldexp(0.5, -static_cast<int>(bits));
    // A vertical edge at distance d to the left of the sample (20.5, 20.5).
    const auto with_edge_at = [](double d) {
      return Triangle({at(20.5 - d, 0), at(60, 32), at(20.5 - d, 64)}, kViewport);
    };
    EXPECT_EQ(coverage(with_edge_at(1.1 * half_step), 20.5, 20.5, bits), Coverage::kMust);
    EXPECT_EQ(coverage(with_edge_at(0.9 * half_step), 20.5, 20.5, bits), Coverage::kMay);
    EXPECT_EQ(coverage(with_edge_at(0), 20.5, 20.5, bits), Coverage::kMay);
    EXPECT_EQ(coverage(with_edge_at(-0.9 * half_step), 20.5, 20.5, bits), Coverage::kMay);
    EXPECT_EQ(coverage(with_edge_at(-1.1 * half_step), 20.5, 20.5, bits), Coverage::kMustNot);
  }
}

TEST(Triangle, TheTipOfASliverEndsAtItsBoundingBox) {
  const Triangle sliver({at(10, 20.5), at(30, 20.5), at(30, 20.5 + 1.0 / 256)}, kViewport);
  EXPECT_EQ(coverage(sliver, 10.5, 20.5), Coverage::kMay);
  EXPECT_EQ(coverage(sliver, 9.5, 20.5), Coverage::kMustNot);
  EXPECT_EQ(coverage(sliver, 30.5, 20.5), Coverage::kMustNot);
}

// The last vertex is the sum of the others, homogeneously; the coordinates are too long for exact doubles.
TEST(Triangle, AreaIsNoneWhereRoundingMakesSome) {
  for (int i = 1; i <= 100; ++i) {
    const auto fraction = [i](int factor) { return static_cast<float>(i * factor % 0x7FFFFF) * 0x1p-24F; };
    const ClipPosition a{fraction(51287), fraction(73421), 0.5F, 1};
    const ClipPosition b{fraction(90017), fraction(31337), 0.5F, 1};
    const ClipPosition sum{a[0] + b[0], a[1] + b[1], 1, 2};
    EXPECT_EQ(Triangle({a, b, sum}, {.width = 100, .height = 60, .maxDepth = 1}).orientation(), 0) << i;
  }
}

TEST(Triangle, WithoutAreaOnlySamplesOnTheSegmentMayBeCovered) {
  const Triangle segment({at(10.5, 10.5), at(20.5, 20.5), at(30.5, 30.5)}, kViewport);
  EXPECT_EQ(segment.orientation(), 0);
  EXPECT_EQ(coverage(segment, 15.5, 15.5), Coverage::kMay);
  EXPECT_EQ(coverage(segment, 15.5, 16.5), Coverage::kMustNot);
  EXPECT_EQ(coverage(segment, 31.5, 31.5), Coverage::kMustNot);
}

TEST(Triangle, VerticesBehindTheEyeNeedNoClipping) {
  // The third vertex is behind the eye, its image at (16, 32). What is visible lies beyond the edge from (32, 60.8)
  // to (3.2, 3.2), away from that image.
  const Triangle triangle(
      {ClipPosition{0, 0.9F, 0.5F, 1}, ClipPosition{-0.9F, -0.9F, 0.5F, 1}, ClipPosition{0.5F, 0, -0.5F, -1}},
      kViewport);
  EXPECT_FALSE(triangle.in_front());
  EXPECT_EQ(coverage(triangle, 40.5, 32.5), Coverage::kMust);
  EXPECT_EQ(coverage(triangle, 16.5, 31.5), Coverage::kMustNot);  // where a rasterizer that ignores w's sign draws
}

TEST(Triangle, NearAndFarPlanesCutWhereDepthCrossesThem) {
  // z runs from -1 at x = 0 to 2 at x = 48: inside from x = 16 to x = 32.
  const Triangle triangle({at(0, 0, -1), at(48, 32, 2), at(0, 64, -1)}, kViewport);
  EXPECT_EQ(coverage(triangle, 15.5, 32.5), Coverage::kMustNot);
  EXPECT_EQ(coverage(triangle, 16.5, 32.5), Coverage::kMust);
  EXPECT_EQ(coverage(triangle, 31.5, 32.5), Coverage::kMust);
  EXPECT_EQ(coverage(triangle, 32.5, 32.5), Coverage::kMustNot);
}

TEST(Triangle, FlatOnThePlanesIsInside) {
  for (const double z : {0.0, 1.0}) {
    const Triangle triangle({at(0, 0, z), at(64, 0, z), at(0, 64, z)}, kViewport);
    EXPECT_EQ(coverage(triangle, 10.5, 10.5), Coverage::kMust) << z;
  }
  const Triangle behind({at(0, 0, -0.25), at(64, 0, -0.25), at(0, 64, -0.25)}, kViewport);
  EXPECT_EQ(coverage(behind, 10.5, 10.5), Coverage::kMustNot);
}

TEST(Triangle, OutsideTheViewportNothingIsCovered) {
  const Triangle huge({at(-1e6, -1e6), at(3e6, -1e6), at(-1e6, 3e6)}, kViewport);
  EXPECT_EQ(coverage(huge, 63.5, 0.5), Coverage::kMust);
  EXPECT_EQ(coverage(huge, 64.5, 0.5), Coverage::kMustNot);
  EXPECT_EQ(coverage(huge, -0.5, 0.5), Coverage::kMustNot);
}

// Doubles decide about both directions where they can, rationals about the rest: borders through samples, the
// latitude from them and a little less or more, upside down too.
TEST(Triangle, TheViewportsBordersAreThoseOfRationals) {
  constexpr std::array<double, 7> kPlaces{9.5, 10.5, 11.5, 18.5, 25.5, 26.5, 27.5};
  constexpr float kSize = 16;
  std::array<int, 3> answers{};
  for (const double latitudes : {0.0, 0.5, 0.999, 1.001, 100.0, -0.999, -1.001, -100.0}) {
    for (const float up : {1.0F, -1.0F}) {
      const VkViewport at_samples{.x = 10.5F,
                                  .y = up > 0 ? 10.5F : 26.5F,
                                  .width = kSize,
                                  .height = kSize * up,
                                  .minDepth = 0,
                                  .maxDepth = 1};
      const auto shift = static_cast<float>(latitudes * latitude_of(at_samples, 8).x);
      VkViewport viewport = at_samples;
      viewport.x += shift;
      viewport.y += shift;
      const Triangle huge({ClipPosition{-1e6F, -1e6F, 0.5F, 1}, ClipPosition{3e6F, -1e6F, 0.5F, 1},
                           ClipPosition{-1e6F, 3e6F, 0.5F, 1}},
                          viewport);
      const Latitude latitude = latitude_of(viewport, 8);
      for (const double x : kPlaces) {
        for (const double y : kPlaces) {
          const Coverage expected = exact_viewport_classification(viewport, x, y, latitude);
          EXPECT_EQ(huge.classify(x, y, latitude).coverage, expected)
              << latitudes << ' ' << up << ' ' << x << ' ' << y;
          ++answers[static_cast<size_t>(expected)];
        }
      }
    }
  }
  for (const int count : answers) EXPECT_GT(count, 50);
}

TEST(Triangle, WhatVulkanLeavesUndefinedIsSaidToBe) {
  const auto with = [](float x, float w) {
    return Triangle({ClipPosition{x, 0, 0, w}, at(60, 10), at(10, 60)}, kViewport).undefined();
  };
  EXPECT_TRUE(with(kNan, 1));
  EXPECT_TRUE(with(INFINITY, 1));
  EXPECT_TRUE(with(0, kNan));
  EXPECT_TRUE(with(FLT_MAX / 8, 1));
  EXPECT_TRUE(with(1e30F, 1e-20F));  // x / w leaves float32
  EXPECT_TRUE(with(0, 1e-40F));      // 1 / w does
  EXPECT_TRUE(with(0, 0));           // 0 / 0
  EXPECT_FALSE(with(1e30F, 1));
  EXPECT_FALSE(with(1, 0));
  EXPECT_FALSE(with(-1, -1));
  EXPECT_FALSE(with(1e-40F, 1));
}

TEST(Triangle, OneOfTwoTrianglesOwnsASampleOnTheirEdge) {
  const Triangle left({at(8.5, 8.5), at(24.5, 24.5), at(8.5, 24.5)}, kViewport);
  const Triangle right({at(8.5, 8.5), at(24.5, 8.5), at(24.5, 24.5)}, kViewport);
  for (int i = 9; i < 24; ++i) EXPECT_NE(left.owns(i + 0.5, i + 0.5), right.owns(i + 0.5, i + 0.5)) << i;
  EXPECT_TRUE(right.owns(16.5, 8.5));    // on its top edge
  EXPECT_FALSE(right.owns(24.5, 16.5));  // on its right edge
  EXPECT_TRUE(left.owns(8.5, 16.5));     // on its left edge
  EXPECT_FALSE(left.owns(16.5, 24.5));   // on its bottom edge
}

TEST(Triangle, FacingIsInDoubtOnlyBelowTheSnapError) {
  const Latitude latitude = latitude_of(kViewport, 8);
  const Triangle wide({at(10, 10), at(30, 10), at(10, 10.1)}, kViewport);
  EXPECT_FALSE(wide.orientation_in_doubt(latitude));
  const Triangle narrow({at(10, 10), at(30, 10), at(10, 10.003)}, kViewport);
  EXPECT_TRUE(narrow.orientation_in_doubt(latitude));
  EXPECT_EQ(wide.orientation(), narrow.orientation());
}

TEST(Triangle, TwoEqualVerticesLeaveNoDoubtAboutFacing) {
  const Latitude latitude = latitude_of(kViewport, 8);
  const Triangle equal({at(10.3, 10.2), at(40.1, 30.7), at(40.1, 30.7)}, kViewport);
  EXPECT_EQ(equal.orientation(), 0);
  EXPECT_FALSE(equal.orientation_in_doubt(latitude));
  // Rounding may give these an area, and so may clipping.
  const Triangle on_a_line({at(10, 10), at(20, 20), at(40, 40)}, kViewport);
  EXPECT_TRUE(on_a_line.orientation_in_doubt(latitude));
  const Triangle clipped({at(10.3, 10.2), at(80.1, 30.7), at(80.1, 30.7)}, kViewport);
  EXPECT_TRUE(clipped.orientation_in_doubt(latitude));
}

TEST(Triangle, KnowsTheSubpixelGrid) {
  const auto expect_on_grid = [](const Triangle& triangle, uint32_t bits, bool expected) {
    EXPECT_EQ(triangle.on_grid(bits), expected);
    EXPECT_EQ(exactly_on_grid(triangle, bits), expected);
  };
  const Triangle in_steps_of_256({at(1.5, 2), at(3, 4.25), at(9, 1.0 / 256)}, kViewport);
  expect_on_grid(in_steps_of_256, 8, true);
  expect_on_grid(in_steps_of_256, 4, false);
  expect_on_grid(Triangle({at(1.5, 2), at(3, 4.25), at(9, 1.0 / 512)}, kViewport), 8, false);
  expect_on_grid(Triangle({at(1.5, 2, 0.5, 2), at(3, 4.25, 0.5, 3), at(9, 1, 0.5, 8)}, kViewport), 8, true);
  expect_on_grid(Triangle({at(1.5, 2), at(3.1, 4.25), at(9, 1)}, kViewport), 8, false);
}

}  // namespace
}  // namespace fillrule::exact
