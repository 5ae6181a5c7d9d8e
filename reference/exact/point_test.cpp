#include "reference/exact/point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/exact/point_values.h"

namespace fillrule::exact {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

RasterState state_of() {
  RasterState state;
  state.viewport = {.x = 0, .y = 0, .width = 64, .height = 64, .minDepth = 0, .maxDepth = 1};
  return state;
}

ClipPosition at(double x, double y, double z = 0.5, double w = 1) {
  return {static_cast<float>((x / 32 - 1) * w), static_cast<float>((y / 32 - 1) * w), static_cast<float>(z * w),
          static_cast<float>(w)};
}

Point point(const ClipPosition& vertex, float size, std::span<const float> distances = {}) {
  return {vertex, point_size_range(size), distances, state_of()};
}

Coverage coverage(const Point& point, double x, double y, uint32_t bits = 8) {
  return point.classify(x, y, latitude_of(state_of().viewport, bits)).coverage;
}

TEST(Point, IsASquareOfItsSize) {
  for (const uint32_t bits : {4U, 8U}) {
    const double half_step = std::ldexp(0.5, -static_cast<int>(bits));
    for (const auto& [size, latitude] : {std::pair{4.0F, 1.0}, {3.3F, 1.5}}) {
      // The left side is `inside` to the left of the sample (20.5, 20.5).
      const auto with_side_at = [size = size](double inside) {
        return point(at(20.5 - inside + double{size} / 2, 20.5), size);
      };
      EXPECT_EQ(coverage(with_side_at((latitude + 0.1) * half_step), 20.5, 20.5, bits), Coverage::kMust);
      EXPECT_EQ(coverage(with_side_at((latitude - 0.1) * half_step), 20.5, 20.5, bits), Coverage::kMay);
      EXPECT_EQ(coverage(with_side_at((0.1 - latitude) * half_step), 20.5, 20.5, bits), Coverage::kMay);
      EXPECT_EQ(coverage(with_side_at((-latitude - 0.1) * half_step), 20.5, 20.5, bits), Coverage::kMustNot);
    }
  }
}

TEST(Point, OutsideOfTheRequiredSizesItMayBeClamped) {
  EXPECT_EQ(coverage(point(at(20, 20), 0.25F), 20.4, 20.4), Coverage::kMay);
  EXPECT_EQ(coverage(point(at(20, 20), 0.25F), 20.1, 20.1), Coverage::kMust);
  EXPECT_EQ(coverage(point(at(20, 20), 80), 54.5, 20.5), Coverage::kMay);
  EXPECT_EQ(coverage(point(at(20, 20), 80), 50.5, 20.5), Coverage::kMust);
  EXPECT_EQ(coverage(point(at(20, 20), 0), 60.5, 60.5), Coverage::kMay);
  EXPECT_EQ(coverage(point(at(20, 20), kNan), 20.5, 20.5), Coverage::kMay);
}

TEST(Point, MayBeCutAtTheViewport) {
  EXPECT_EQ(coverage(point(at(1, 20), 8), 0.5, 20.5), Coverage::kMust);
  EXPECT_EQ(coverage(point(at(1, 20), 8), -0.5, 20.5), Coverage::kMay);
}

TEST(Point, VanishesWithItsVertex) {
  EXPECT_EQ(coverage(point(at(64, 20), 8), 63.5, 20.5), Coverage::kMust);
  EXPECT_EQ(coverage(point(at(64.01, 20), 8), 63.5, 20.5), Coverage::kMustNot);
  EXPECT_EQ(coverage(point(at(20, 20, -0.01), 8), 20.5, 20.5), Coverage::kMustNot);
  EXPECT_EQ(coverage(point(at(20, 20, 1.01), 8), 20.5, 20.5), Coverage::kMustNot);
  EXPECT_EQ(coverage(point(at(20, 20, 1), 8), 20.5, 20.5), Coverage::kMust);
  EXPECT_EQ(coverage(point(at(20, 20, 0.5, -1), 8), 20.5, 20.5), Coverage::kMustNot);
  const std::array<float, 2> distances{1, -0.5F};
  EXPECT_EQ(coverage(point(at(20, 20), 8, distances), 20.5, 20.5), Coverage::kMustNot);
}

TEST(Point, OfAnUndefinedVertexMayBeAnywhereInTheWindow) {
  EXPECT_EQ(coverage(point({kNan, 0, 0, 1}, 1), 5.5, 60.5), Coverage::kMay);
  EXPECT_EQ(coverage(point({kNan, 0, 0, 1}, 1), 5.5, 65.5), Coverage::kMustNot);
}

TEST(PointValues, AreTheVertexs) {
  const Point square = point(at(20.25, 30, 0.3, 3), 8);
  PointValues values(square, latitude_of(state_of().viewport, 8), false);
  values.add_component(7.5F);
  EXPECT_NEAR(values.depth(18.5, 30.5).value, 0.3, 1e-7);
  EXPECT_LT(values.depth(18.5, 30.5).tolerance, 4e-7);
  EXPECT_EQ(values.varying_for(0, 0, 18.5, 30.5).value, 7.5);
  EXPECT_LT(values.varying_for(0, 0, 18.5, 30.5).tolerance, 2e-6);
  EXPECT_NEAR(PointValues(square, {}, true).depth(18.5, 30.5).value, 0.65, 1e-7);
}

TEST(PointValues, PointCoordRunsFromZeroToOne) {
  const Point square = point(at(20.25, 30), 8);
  const PointValues values(square, latitude_of(state_of().viewport, 8), false);
  EXPECT_NEAR(values.point_coord_for(0, 0, 16.5, 30.5).value, 0.5 - 3.75 / 8, 1e-12);
  EXPECT_NEAR(values.point_coord_for(1, 0, 16.5, 30.5).value, 0.5 + 0.5 / 8, 1e-12);
  EXPECT_LT(values.point_coord_for(0, 0, 16.5, 30.5).tolerance, 3e-6);
}

}  // namespace
}  // namespace fillrule::exact
