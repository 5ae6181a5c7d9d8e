#include "harness/report/outlines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fillrule::report {
namespace {

Case one_draw(VkPrimitiveTopology topology, std::vector<ClipPosition> positions) {
  Case result{.target = {.width = 8, .height = 8}};
  Draw draw{.topology = topology, .positions = std::move(positions)};
  draw.state.viewport = {.x = 0, .y = 0, .width = 8, .height = 8, .minDepth = 0, .maxDepth = 1};
  result.draws.push_back(draw);
  return result;
}

std::vector<std::string> makers(const Outline& outline) {
  std::vector<std::string> names;
  for (const OutlineCorner& corner : outline.corners) names.push_back(corner.made_by);
  return names;
}

TEST(Outlines, ATriangleInsideHasItsOwnVertices) {
  const auto outlines = outlines_of(
      one_draw(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, {{-1, -1, 0, 1}, {1, -1, 0, 1}, {-0.5F, 0.5F, 0, 1}}), 10);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_THAT(makers(outlines[0]), testing::ElementsAre("v0", "v1", "v2"));
  EXPECT_EQ(outlines[0].corners[2].x, 2);
  EXPECT_EQ(outlines[0].corners[2].y, 6);
}

TEST(Outlines, NamesThePlaneThatMadeAVertex) {
  const auto outlines = outlines_of(
      one_draw(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, {{0, -0.5F, -1, 1}, {0.5F, 0.5F, 1, 1}, {-0.5F, 0.5F, 1, 1}}),
      10);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_THAT(makers(outlines[0]), testing::ElementsAre("near plane", "v1", "v2", "near plane"));
  EXPECT_EQ(outlines[0].corners[0].y, 4);
}

TEST(Outlines, AUserPlaneCutsALineOnce) {
  Case test_case = one_draw(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {{-1, 0, 0, 1}, {1, 0, 0, 1}});
  test_case.draws[0].clip_distance_count = 1;
  test_case.draws[0].clip_distances = {-1, 1};
  const auto outlines = outlines_of(test_case, 10);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_EQ(outlines[0].kind, Outline::Kind::kLine);
  EXPECT_THAT(makers(outlines[0]), testing::ElementsAre("clip distance 0", "v1"));
}

TEST(Outlines, NumbersRunOverAllDrawsAndSkipWhatIsOutside) {
  Case test_case = one_draw(VK_PRIMITIVE_TOPOLOGY_POINT_LIST, {{9, 0, 0, 1}, {0, 0, 0, 1}});
  test_case.draws.push_back(test_case.draws[0]);
  const auto outlines = outlines_of(test_case, 10);
  ASSERT_EQ(outlines.size(), 2U);
  EXPECT_EQ(outlines[0].primitive, 1U);
  EXPECT_EQ(outlines[1].primitive, 3U);
  EXPECT_EQ(outlines[1].draw, 1U);
  EXPECT_EQ(outlines_of(test_case, 1).size(), 1U);
}

}  // namespace
}  // namespace fillrule::report
