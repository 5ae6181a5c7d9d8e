// The judge is shown right pictures of lines and points with one thing made wrong at a time.
#include <gtest/gtest.h>

#include <functional>

#include "harness/judge/judge.h"
#include "reference/exact/expectation.h"

namespace fillrule::judge {
namespace {

constexpr uint32_t kSize = 32;

ClipPosition at(double x, double y, double z = 0.5) {
  return {static_cast<float>(x / 16 - 1), static_cast<float>(y / 16 - 1), static_cast<float>(z), 1};
}

Case lines(VkPrimitiveTopology topology, std::vector<ClipPosition> positions, bool bresenham, float width = 1) {
  Case result{.target = {.width = kSize, .height = kSize}};
  result.varyings = {{.name = "along", .components = 1, .interpolation = Interpolation::kNoperspective}};
  Draw draw{.topology = topology, .positions = std::move(positions)};
  draw.state.viewport = {.x = 0, .y = 0, .width = kSize, .height = kSize, .minDepth = 0, .maxDepth = 1};
  draw.state.scissor = {.offset = {}, .extent = {.width = kSize, .height = kSize}};
  draw.state.depth_test = true;
  draw.state.depth_compare = VK_COMPARE_OP_ALWAYS;
  draw.state.line_width = width;
  if (bresenham) draw.state.line_mode = VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT;
  for (size_t i = 0; i < draw.positions.size(); ++i) draw.varyings.push_back(static_cast<float>(i));
  result.draws.push_back(draw);
  return result;
}

// Whatever must be covered, and of Bresenham lines what the diamond-exit rule says; exact values.
Planes right_picture(const Case& test_case) {
  const exact::Expectation expectation(test_case, 8);
  Planes planes = Planes::cleared(kSize, kSize, 1, 1, test_case.target.clear_depth);
  std::vector<exact::Entry> entries;
  for (size_t index = 0; index < planes.hits.size(); ++index) {
    const double x = static_cast<double>(index % kSize) + 0.5;
    const size_t row = index / kSize;
    const double y = static_cast<double>(row) + 0.5;
    expectation.collect(index, entries);
    for (const exact::Entry& entry : entries) {
      const exact::Piece& piece = expectation.pieces()[entry.piece];
      const bool bresenham = piece.kind == exact::Piece::Kind::kBresenhamLine;
      if (bresenham ? !piece.shape->owns(x, y) : entry.coverage != exact::Coverage::kMust) continue;
      ++planes.hits[index];
      planes.owner[index] = piece.owner;
      planes.front_facing[index] = 1;
      const auto values = exact::values_of(test_case, piece);
      planes.depth[index] = static_cast<float>(values->depth(x, y).value);
      planes.varyings[0][index] = static_cast<float>(values->exact_varying(0, x, y));
    }
  }
  return planes;
}

size_t index_of(uint32_t x, uint32_t y) {
  return size_t{y} * kSize + x;
}

void erase(Planes& planes, uint32_t x, uint32_t y) {
  const size_t index = index_of(x, y);
  planes.hits[index] = 0;
  planes.owner[index] = kNoOwner;
  planes.front_facing[index] = 0;
  planes.depth[index] = 1;
  planes.varyings[0][index] = 0;
}

// As `from`, but for what its place decides.
void copy(Planes& planes, uint32_t from_x, uint32_t from_y, uint32_t x, uint32_t y) {
  const size_t from = index_of(from_x, from_y);
  const size_t to = index_of(x, y);
  planes.hits[to] = planes.hits[from];
  planes.owner[to] = planes.owner[from];
  planes.front_facing[to] = planes.front_facing[from];
  planes.depth[to] = planes.depth[from];
  planes.varyings[0][to] = planes.varyings[0][from];
}

uint64_t faults(const Case& test_case, const Planes& planes, const std::string& plane, Profile profile = {}) {
  const CaseVerdict verdict = judge(test_case, {.planes = &planes}, nullptr, {.profile = profile});
  for (const PlaneVerdict& one : verdict.planes) {
    if (one.name == plane) return one.candidate_faults();
  }
  ADD_FAILURE() << plane;
  return 0;
}

uint64_t all_faults(const Case& test_case, const Planes& planes, Profile profile = {}) {
  return judge(test_case, {.planes = &planes}, nullptr, {.profile = profile}).candidate_faults();
}

// From (4.5, 10.5) to (16.5, 12.5) and on to (28.5, 10.5).
Case strip(float width = 1) {
  return lines(VK_PRIMITIVE_TOPOLOGY_LINE_STRIP, {at(4.5, 10.5), at(16.5, 12.5), at(28.5, 10.5)}, true, width);
}

TEST(LineJudge, ARightStripHasNoFault) {
  for (const float width : {1.0F, 2.0F, 3.0F}) {
    const Case test_case = strip(width);
    const Planes planes = right_picture(test_case);
    EXPECT_EQ(all_faults(test_case, planes), 0U) << width;
    EXPECT_EQ(all_faults(test_case, planes, {.diamond_exit = true}), 0U) << width;
  }
}

TEST(LineJudge, AFragmentMayDeviateByOnePixelUnlessTheProfileForbids) {
  const Case test_case = strip();
  Planes planes = right_picture(test_case);
  copy(planes, 9, 11, 9, 10);
  erase(planes, 9, 11);
  EXPECT_EQ(faults(test_case, planes, "coverage"), 0U);
  EXPECT_EQ(faults(test_case, planes, "coverage", {.diamond_exit = true}), 2U);
}

TEST(LineJudge, TwoFragmentsInAColumnAreAFault) {
  const Case test_case = strip();
  Planes planes = right_picture(test_case);
  copy(planes, 9, 11, 9, 10);
  EXPECT_EQ(faults(test_case, planes, "coverage"), 1U);
  EXPECT_EQ(faults(test_case, planes, "hits"), 1U);
}

// Where a line breaks a rule, the other party may show the same and be right.
TEST(LineJudge, EqualHitsOfARightLineAndABrokenOneDoNotStandAlike) {
  const Case test_case = strip();
  const Planes right = right_picture(test_case);
  Planes wrong = right;
  copy(wrong, 9, 11, 9, 10);
  const Party right_party{.planes = &right};
  const Party wrong_party{.planes = &wrong};
  EXPECT_EQ(judge(test_case, right_party, &wrong_party, {}).reference_faults(), 2U) << "coverage and hits";
  EXPECT_EQ(judge(test_case, right_party, &wrong_party, {}).candidate_faults(), 0U);
  EXPECT_EQ(judge(test_case, wrong_party, &right_party, {}).candidate_faults(), 2U);
  EXPECT_EQ(judge(test_case, wrong_party, &right_party, {}).reference_faults(), 0U);
}

TEST(LineJudge, OneFragmentMayBeMissingButNotTwo) {
  const Case test_case = strip();
  Planes planes = right_picture(test_case);
  erase(planes, 9, 11);
  EXPECT_EQ(faults(test_case, planes, "coverage"), 0U);
  erase(planes, 11, 11);
  ASSERT_EQ(right_picture(test_case).hits[index_of(11, 11)], 1U);
  EXPECT_EQ(faults(test_case, planes, "coverage"), 1U);
}

TEST(LineJudge, OneFragmentMayBeTooManyButNotTwo) {
  const Case test_case = lines(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {at(8.5, 10.5), at(20.5, 10.5)}, true);
  Planes planes = right_picture(test_case);
  copy(planes, 8, 10, 7, 10);
  EXPECT_EQ(faults(test_case, planes, "coverage"), 0U);
  copy(planes, 8, 10, 20, 10);
  EXPECT_EQ(faults(test_case, planes, "coverage"), 1U);
}

TEST(LineJudge, ASharedEndIsNotDoubled) {
  const Case test_case = strip();
  Planes planes = right_picture(test_case);
  ASSERT_EQ(planes.owner[index_of(15, 12)], 0U);
  ASSERT_EQ(planes.owner[index_of(16, 12)], 1U);
  planes.hits[index_of(16, 12)] = 2;
  EXPECT_EQ(faults(test_case, planes, "hits"), 1U);
}

TEST(LineJudge, ASharedEndIsNotLeftOut) {
  const Case test_case = strip();
  Planes planes = right_picture(test_case);
  erase(planes, 16, 12);
  EXPECT_EQ(faults(test_case, planes, "coverage"), 1U);
}

TEST(LineJudge, AWideLineHasAllItsFragmentsSideBySide) {
  const Case test_case = strip(3);
  Planes planes = right_picture(test_case);
  erase(planes, 9, 10);
  EXPECT_EQ(faults(test_case, planes, "coverage"), 1U);
}

TEST(LineJudge, BeyondOnePixelNothingMayLand) {
  const Case test_case = strip();
  Planes planes = right_picture(test_case);
  copy(planes, 9, 11, 9, 14);
  EXPECT_EQ(faults(test_case, planes, "coverage"), 1U);
}

TEST(LineJudge, ABresenhamLinesValuesAreThoseOfThePlace) {
  const Case test_case = strip();
  Planes planes = right_picture(test_case);
  planes.varyings[0][index_of(9, 11)] += 0.5F;
  EXPECT_EQ(faults(test_case, planes, "along"), 1U);
}

TEST(LineJudge, TheJointsOfARectangularStripAreHitTwice) {
  const Case test_case =
      lines(VK_PRIMITIVE_TOPOLOGY_LINE_STRIP, {at(4.5, 10.5), at(16.5, 10.5), at(16.5, 24.5)}, false, 5);
  const Planes planes = right_picture(test_case);
  EXPECT_EQ(planes.hits[index_of(15, 11)], 2U);
  EXPECT_EQ(all_faults(test_case, planes), 0U);
  Planes wrong = planes;
  wrong.hits[index_of(15, 11)] = 1;
  EXPECT_EQ(faults(test_case, wrong, "hits"), 1U);
  wrong = planes;
  erase(wrong, 8, 10);
  EXPECT_EQ(faults(test_case, wrong, "coverage"), 1U);
  wrong = planes;
  wrong.depth[index_of(8, 10)] = 0.75F;
  EXPECT_EQ(faults(test_case, wrong, "depth"), 1U);
  wrong = planes;
  wrong.front_facing[index_of(8, 10)] = 0;
  EXPECT_EQ(faults(test_case, wrong, "front_facing"), 1U);
}

TEST(LineJudge, ThePartsOfAnOutlineHaveAnyOrder) {
  Case test_case =
      lines(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, {at(4.5, 4.5, 0), at(28.5, 4.5, 0.5), at(4.5, 28.5, 1)}, false, 3);
  test_case.draws[0].state.polygon_mode = VK_POLYGON_MODE_LINE;
  Planes planes = right_picture(test_case);
  for (uint32_t& facing : planes.front_facing) facing = 0;  // clockwise
  EXPECT_EQ(all_faults(test_case, planes), 0U);
  // In the corner at (4.5, 4.5) both edges land; the values may be either's.
  const size_t corner = index_of(5, 5);
  ASSERT_EQ(planes.hits[corner], 2U);
  const exact::Expectation expectation(test_case, 8);
  for (const uint32_t piece : {0U, 2U}) {
    const auto values = exact::values_of(test_case, expectation.pieces()[piece]);
    planes.depth[corner] = static_cast<float>(values->depth(5.5, 5.5).value);
    planes.varyings[0][corner] = static_cast<float>(values->exact_varying(0, 5.5, 5.5));
    EXPECT_EQ(all_faults(test_case, planes), 0U) << piece;
  }
  planes.depth[corner] = 0.25F;
  EXPECT_EQ(faults(test_case, planes, "depth"), 1U);
}

TEST(LineJudge, APointHasOneDepth) {
  Case test_case = lines(VK_PRIMITIVE_TOPOLOGY_POINT_LIST, {at(10, 10, 0.25)}, false);
  test_case.draws[0].point_sizes = {6};
  Planes planes = right_picture(test_case);
  EXPECT_EQ(planes.hits[index_of(12, 7)], 1U);
  EXPECT_EQ(all_faults(test_case, planes), 0U);
  planes.depth[index_of(12, 7)] = 0.2501F;
  EXPECT_EQ(faults(test_case, planes, "depth"), 1U);
}

}  // namespace
}  // namespace fillrule::judge
