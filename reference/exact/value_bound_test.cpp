#include "reference/exact/value_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <random>

#include "reference/exact/random_triangle.h"
#include "reference/exact/rational_triangle.h"

namespace fillrule::exact {
namespace {

constexpr VkViewport kViewport{.x = 0, .y = 0, .width = 64, .height = 64, .minDepth = 0, .maxDepth = 1};

ClipPosition at(double x, double y, double z, double w) {
  return {static_cast<float>((x / 32 - 1) * w), static_cast<float>((y / 32 - 1) * w), static_cast<float>(z * w),
          static_cast<float>(w)};
}

const Triangle& slanted() {
  static const Triangle triangle({at(0, 0, 0.1, 1), at(64, 0, 0.9, 4), at(0, 64, 0.5, 2)}, kViewport);
  return triangle;
}

TEST(TriangleValues, AreTheVerticesValuesAtTheVertices) {
  const TriangleValues values(slanted(), latitude_of(kViewport, 8));
  const std::array<float, 3> q{1, 2, 3};
  const auto smooth = values.component(Interpolation::kSmooth, q, 0);
  const auto linear = values.component(Interpolation::kNoperspective, q, 0);
  EXPECT_NEAR(values.depth(64, 0).value, 0.9, 1e-6);
  EXPECT_NEAR(values.varying(smooth, 64, 0).value, 2, 1e-12);
  EXPECT_NEAR(values.varying(linear, 0, 64).value, 3, 1e-12);
}

TEST(TriangleValues, SmoothIsPerspectiveCorrectAndNoperspectiveIsNot) {
  const TriangleValues values(slanted(), latitude_of(kViewport, 8));
  const std::array<float, 3> q{0, 1, 0};
  // Half way along the edge from w = 1 to w = 4 the perspective-correct parameter is (1/4) / (1/1 + 1/4).
  EXPECT_NEAR(values.varying(values.component(Interpolation::kSmooth, q, 0), 32, 0).value, 0.2, 1e-12);
  EXPECT_NEAR(values.varying(values.component(Interpolation::kNoperspective, q, 0), 32, 0).value, 0.5, 1e-12);
}

TEST(TriangleValues, FlatIsTheProvokingVertexWithoutTolerance) {
  const TriangleValues values(slanted(), latitude_of(kViewport, 8));
  const auto flat = values.component(Interpolation::kFlat, {5, 6, 7}, 6);
  EXPECT_EQ(values.varying(flat, 20, 20).value, 6);
  EXPECT_EQ(values.varying(flat, 20, 20).tolerance, 0);
}

TEST(TriangleValues, AConstantVaryingHasATightBound) {
  const Triangle triangle({at(0, 0, 0.5, 1), at(64, 0, 0.5, 1), at(0, 64, 0.5, 1)}, kViewport);
  const TriangleValues values(triangle, latitude_of(kViewport, 8));
  const auto constant = values.component(Interpolation::kSmooth, {1, 1, 1}, 0);
  const Expected expected = values.varying(constant, 20.5, 20.5);
  EXPECT_EQ(expected.value, 1);
  EXPECT_GT(expected.tolerance, 0x1p-24);
  EXPECT_LT(expected.tolerance, 0x1p-19);
}

TEST(TriangleValues, AnErrorAsOfAffineInterpolationIsFarBeyondTheBound) {
  const TriangleValues values(slanted(), latitude_of(kViewport, 8));
  const auto smooth = values.component(Interpolation::kSmooth, {0, 1, 0}, 0);
  const auto affine = values.component(Interpolation::kNoperspective, {0, 1, 0}, 0);
  const Expected expected = values.varying(smooth, 20.5, 20.5);
  const double error = std::abs(values.varying(affine, 20.5, 20.5).value - expected.value);
  EXPECT_GT(error, 10 * kImpreciseFactor * expected.tolerance);
}

TEST(TriangleValues, NanInAVaryingIsNotJudgedAndLeavesDepthJudged) {
  const TriangleValues values(slanted(), latitude_of(kViewport, 8));
  const auto nan = values.component(Interpolation::kSmooth, {0, std::numeric_limits<float>::quiet_NaN(), 0}, 0);
  EXPECT_EQ(values.varying(nan, 20.5, 20.5).tolerance, std::numeric_limits<double>::infinity());
  EXPECT_LT(values.depth(20.5, 20.5).tolerance, 1e-3);
}

// The tolerance that rows of samples are held against, at one sample.
double least_in_row(const TriangleValues& values, const TriangleValues::Component& component, double x, double y) {
  double w = 0;
  double expected = 0;
  double least = 0;
  values.w_row(x, y, {&w, 1});
  values.varying_row(component, x, y, {&w, 1}, {&expected, 1}, {&least, 1});
  return least;
}

// The doubles that the judge works with are within a millionth of the bound of the exact values.
TEST(TriangleValues, DoublesAreAccurateComparedToTheBound) {
  constexpr uint64_t kSeed = 4711;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  int compared = 0;
  int narrow = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto family = static_cast<Family>(i % static_cast<int>(kFamilies));
    const RandomTriangle picked = random_triangle(family, random);
    const Triangle triangle(picked.vertices, picked.viewport);
    if (triangle.undefined() || triangle.orientation() == 0) continue;
    const Latitude latitude = latitude_of(picked.viewport, 8);
    TriangleValues values(triangle, latitude);
    const std::array<float, 3> q{-1, 3, 0.5F};
    const auto smooth = values.component(Interpolation::kSmooth, q, 0);
    const auto linear = values.component(Interpolation::kNoperspective, q, 0);
    values.add_component(smooth);
    values.add_component(linear);
    for (int sample = 0; sample < 20; ++sample) {
      const double x = static_cast<double>(random() % 64) + 0.5;
      const double y = static_cast<double>(random() % 64) + 0.5;
      if (triangle.classify(x, y, latitude).coverage != Coverage::kMust) continue;
      const auto expect_accurate = [&](const Expected& expected, double exact, const char* what) {
        if (!std::isfinite(expected.tolerance)) return;
        EXPECT_LE(std::abs(expected.value - exact), 1e-6 * expected.tolerance) << what << " of triangle " << i;
        ++compared;
      };
      expect_accurate(values.depth(x, y), exact_depth(triangle, x, y), "depth");
      expect_accurate(values.varying(smooth, x, y), exact_smooth(triangle, q, x, y), "smooth");
      expect_accurate(values.varying(linear, x, y), exact_noperspective(triangle, q, x, y), "noperspective");
      EXPECT_LE(least_in_row(values, smooth, x, y), values.varying(smooth, x, y).tolerance) << i;
      EXPECT_LE(least_in_row(values, linear, x, y), values.varying(linear, x, y).tolerance) << i;
      const Expected inside = values.depth_inside(x, y);
      EXPECT_EQ(inside.value, values.depth(x, y).value) << i;
      EXPECT_GE(inside.tolerance, values.depth(x, y).tolerance) << i;
      narrow += inside.tolerance <= 16 * values.depth(x, y).tolerance ? 1 : 0;
      std::array<Expected, 2> all;
      std::array<Expected, 2> least;
      constexpr std::array<uint32_t, 2> kBoth{0, 1};
      values.varyings(x, y, kBoth, all);
      values.least_varyings(x, y, kBoth, least);
      for (size_t c = 0; c < all.size(); ++c) {
        EXPECT_LE(least[c].tolerance, all[c].tolerance) << i;
        EXPECT_LE(std::abs(least[c].value - all[c].value), 0x1p-50 * std::abs(all[c].value)) << i;
      }
    }
  }
  EXPECT_GT(compared, 1000);
  EXPECT_GT(narrow, 100);
}

TEST(TriangleValues, DoublesAreNoFurtherFromTheExactValuesThanTheySay) {
  constexpr int kTriangles = 3000;
  std::mt19937_64 random(71);
  int asked = 0;
  int close = 0;
  // Returns whether the bound is small enough to be of use.
  const auto check = [](double value, double exact, double error) {
    EXPECT_LE(std::abs(value - exact), error);
    return error < 1e-9 * (1 + std::abs(exact));
  };
  for (int i = 0; i < kTriangles; ++i) {
    const RandomTriangle picked = random_triangle(static_cast<Family>(i % static_cast<int>(kFamilies)), random);
    const Triangle triangle(picked.vertices, picked.viewport);
    if (triangle.undefined() || triangle.orientation() == 0) continue;
    const TriangleValues values(triangle, latitude_of(picked.viewport, 8));
    const std::array<float, 3> q{1.25F, -3.5F, 1e3F};
    const auto smooth = values.component(Interpolation::kSmooth, q, 0);
    const auto linear = values.component(Interpolation::kNoperspective, q, 0);
    const double x = static_cast<double>(random() % 64) + 0.5;
    const double y = static_cast<double>(random() % 64) + 0.5;
    SCOPED_TRACE(testing::Message() << "triangle " << i << " at " << x << ", " << y);
    const bool depth_is_close =
        check(values.depth(x, y).value, exact_depth(triangle, x, y), values.depth_error(x, y));
    const bool smooth_is_close = check(values.varying(smooth, x, y).value, exact_smooth(triangle, q, x, y),
                                       values.varying_error(smooth, x, y));
    const bool linear_is_close = check(values.varying(linear, x, y).value, exact_noperspective(triangle, q, x, y),
                                       values.varying_error(linear, x, y));
    close += depth_is_close && smooth_is_close && linear_is_close ? 1 : 0;
    ++asked;
  }
  EXPECT_GT(close, asked * 3 / 5);
}

// Lavapipe, clip space scaled by 2^100: 1/w is near FLT_MIN, and so are the steps of a/w from pixel to pixel.
TEST(TriangleValues, WhatIsFlushedToZeroIsNobodysFault) {
  const auto tolerance_at_scale = [](float scale) {
    std::array<ClipPosition, 3> vertices = slanted().vertices();
    for (ClipPosition& vertex : vertices) {
      for (float& coordinate : vertex) coordinate *= scale;
    }
    const Triangle triangle(vertices, kViewport);
    const TriangleValues values(triangle, latitude_of(kViewport, 8));
    const auto smooth = values.component(Interpolation::kSmooth, {0.25F, 0.5F, 0.75F}, 0);
    return values.varying(smooth, 20.5, 20.5).tolerance;
  };
  const double ordinary = tolerance_at_scale(1);
  EXPECT_NEAR(tolerance_at_scale(0x1p60F), ordinary, 1e-9 * ordinary);
  EXPECT_GT(tolerance_at_scale(0x1p110F), ordinary + double{FLT_MIN} * 0x1p110 * 20);
}

}  // namespace
}  // namespace fillrule::exact
