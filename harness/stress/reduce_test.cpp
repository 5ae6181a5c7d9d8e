#include "harness/stress/reduce.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fillrule::stress {
namespace {

// Vertex i is at x = i, with the varying i.
Draw numbered(VkPrimitiveTopology topology, uint32_t vertices) {
  Draw draw{.topology = topology};
  for (uint32_t i = 0; i < vertices; ++i) {
    const auto x = static_cast<float>(i);
    draw.positions.push_back({x, 0, 0, 1});
    draw.varyings.push_back(x);
  }
  return draw;
}

bool has_vertex(const Case& one, float x) {
  return std::ranges::any_of(one.draws, [x](const Draw& draw) {
    return std::ranges::any_of(draw.positions, [x](const ClipPosition& p) { return p[0] == x; });
  });
}

TEST(Reduce, LeavesTheOneTriangleThatFails) {
  Case one;
  one.draws = {numbered(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, 3), numbered(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, 9)};
  const Case least = reduce(one, [](const Case& smaller) { return has_vertex(smaller, 4); });
  ASSERT_EQ(least.draws.size(), 1U);
  EXPECT_EQ(least.draws[0].varyings, (std::vector<float>{3, 4, 5}));
  EXPECT_EQ(least.draws[0].positions.size(), 3U);
}

TEST(Reduce, MakesAListOfAStrip) {
  Case one;
  one.draws = {numbered(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, 5)};
  const Case least = reduce(one, [](const Case& smaller) { return has_vertex(smaller, 4); });
  EXPECT_EQ(least.draws[0].topology, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST);
  EXPECT_EQ(least.draws[0].varyings, (std::vector<float>{2, 3, 4}));
}

TEST(Reduce, KeepsAFanThatFailsOnlyAsAFan) {
  Case one;
  one.draws = {numbered(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN, 5)};
  const Case least = reduce(
      one, [](const Case& smaller) { return smaller.draws[0].topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN; });
  EXPECT_EQ(least.draws[0].positions.size(), 5U);
}

TEST(Reduce, KeepsTrianglesThatFailTogether) {
  Case one;
  one.draws = {numbered(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, 9)};
  const Case least =
      reduce(one, [](const Case& smaller) { return has_vertex(smaller, 0) && has_vertex(smaller, 8); });
  EXPECT_EQ(least.draws[0].varyings, (std::vector<float>{0, 1, 2, 6, 7, 8}));
}

}  // namespace
}  // namespace fillrule::stress
