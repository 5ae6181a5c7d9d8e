#include "reference/exact/triangle_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "reference/exact/random_triangle.h"

namespace fillrule::exact {
namespace {

constexpr uint64_t kSeed = 20261130;

struct Answers {
  size_t must = 0;  // of samples within a row's must
  size_t may = 0;   // of samples that are left to be asked
  size_t none = 0;
};

// So that one of the row's samples is as far from an edge as rounding moves that, as nearly as doubles can have it.
double begin_of_row(const Triangle& triangle, const Latitude& latitude, double y, uint32_t count,
                    std::mt19937_64& random) {
  const LinearForm& edge = triangle.edge(random() % 3);
  const double reach = edge.reach(latitude.x, latitude.y) * (random() % 2 == 0 ? 1 : -1);
  const double dx = (reach - edge.b * (y - triangle.centre_y()) - edge.c) / edge.a;
  const double place = std::abs(dx) < 1000 ? dx + triangle.centre_x() : triangle.centre_x();
  return place - static_cast<double>(random() % count);
}

// Rows of samples across the picked triangle's viewport, at sixteenths of a pixel or where it is closest.
void expect_rows_like_samples(const RandomTriangle& picked, uint32_t subpixel_bits, std::mt19937_64& random,
                              Answers& answers) {
  const Triangle triangle(picked.vertices, picked.viewport);
  if (triangle.undefined() || triangle.orientation() == 0) return;
  const Latitude latitude = latitude_of(picked.viewport, subpixel_bits);
  const uint32_t count = 1 + static_cast<uint32_t>(random() % 64);
  const double y = std::floor(picked.viewport.y) + static_cast<double>(random() % 64) +
                   0.0625 * static_cast<double>(random() % 16);
  const double x = random() % 2 == 0 ? std::floor(picked.viewport.x) + 0.0625 * static_cast<double>(random() % 256)
                                     : begin_of_row(triangle, latitude, y, count, random);
  const Block samples{.x = x + (count - 1) / 2.0, .y = y, .half_width = (count - 1) / 2.0, .half_height = 0};
  // All boundaries, or those that are left when the block was asked.
  DoubtBits undecided = TriangleRows::kBoundaries;
  if (random() % 2 == 0) {
    const BlockClassification block = triangle.classify_block(samples, latitude, undecided);
    undecided = block.coverage == Coverage::kMay ? block.undecided : undecided;
  }
  const RowCoverage row = TriangleRows(triangle, latitude, samples, undecided).at(x, y, count);
  ASSERT_LE(row.may_begin, row.may_end);
  ASSERT_LE(row.may_end, count);
  ASSERT_LE(row.must_begin, row.must_end);
  for (uint32_t i = 0; i < count; ++i) {
    const Coverage coverage = triangle.classify(x + i, y, latitude, undecided).coverage;
    if (i >= row.must_begin && i < row.must_end) {
      ASSERT_EQ(coverage, Coverage::kMust) << "at " << x + i << ", " << y;
      ++answers.must;
    } else if (i < row.may_begin || i >= row.may_end) {
      ASSERT_EQ(coverage, Coverage::kMustNot) << "at " << x + i << ", " << y;
      ++answers.none;
    } else {
      ++answers.may;
    }
  }
}

class Rows : public testing::TestWithParam<size_t> {};

TEST_P(Rows, AreWhatTheirSamplesAre) {
  SCOPED_TRACE("seed " + std::to_string(kSeed) + ", family " + std::to_string(GetParam()));
  std::mt19937_64 random(kSeed + GetParam());
  Answers answers;
  for (int i = 0; i < 4000 && !HasFatalFailure(); ++i) {
    expect_rows_like_samples(random_triangle(static_cast<Family>(GetParam()), random), i % 2 == 0 ? 8 : 4, random,
                             answers);
  }
  EXPECT_GT(answers.none, 0U);
}

INSTANTIATE_TEST_SUITE_P(Families, Rows, testing::Range<size_t>(0, kFamilies));

// A triangle whose left edge is upright, at x = 4.5, and whose lower one is level, at y = 20.5.
Triangle right_angled() {
  const VkViewport viewport{.width = 32, .height = 32, .maxDepth = 1};
  const auto at = [](double x, double y) {
    return ClipPosition{static_cast<float>(x / 16 - 1), static_cast<float>(y / 16 - 1), 0.5F, 1};
  };
  return {{at(4.5, 4.5), at(4.5, 20.5), at(20.5, 20.5)}, viewport};
}

RowCoverage row_of(const Triangle& triangle, double y) {
  const Latitude latitude = latitude_of(triangle.viewport(), 8);
  const Block samples{.x = 16, .y = 16, .half_width = 15.5, .half_height = 15.5};
  return TriangleRows(triangle, latitude, samples, TriangleRows::kBoundaries).at(0.5, y, 32);
}

TEST(Rows, TellWhatMustBeCoveredFromWhatMay) {
  const Triangle triangle = right_angled();
  // The upright edge is on the samples of column 4, the slanted one on those of the diagonal.
  const RowCoverage row = row_of(triangle, 10.5);
  EXPECT_EQ(row.may_begin, 4U);
  EXPECT_EQ(row.must_begin, 5U);
  EXPECT_EQ(row.must_end, 10U);
  EXPECT_EQ(row.may_end, 11U);
}

TEST(Rows, AlongALevelEdgeAreInDoubt) {
  const Triangle triangle = right_angled();
  const RowCoverage along = row_of(triangle, 20.5);
  EXPECT_EQ(along.must_begin, along.must_end);
  EXPECT_EQ(along.may_begin, 4U);
  EXPECT_EQ(along.may_end, 21U);
  const RowCoverage beyond = row_of(triangle, 21.5);
  EXPECT_EQ(beyond.may_begin, beyond.may_end);
}

TEST(Rows, EndAtTheViewport) {
  // Larger than the viewport on all sides.
  const VkViewport viewport{.x = 8, .width = 16, .height = 32, .maxDepth = 1};
  const Triangle triangle({{{-9, -9, 0.5F, 1}, {30, -9, 0.5F, 1}, {-9, 30, 0.5F, 1}}}, viewport);
  const RowCoverage row = row_of(triangle, 10.5);
  EXPECT_EQ(row.may_begin, 8U);
  EXPECT_EQ(row.must_begin, 8U);
  EXPECT_EQ(row.must_end, 24U);
  EXPECT_EQ(row.may_end, 24U);
}

}  // namespace
}  // namespace fillrule::exact
