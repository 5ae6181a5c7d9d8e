#include "reference/exact/assembly.h"

#include <gtest/gtest.h>

namespace fillrule::exact {
namespace {

using Vertices = std::array<uint32_t, 3>;

std::vector<Vertices> vertices_of(VkPrimitiveTopology topology, size_t count,
                                  std::optional<std::vector<uint32_t>> indices = std::nullopt) {
  Draw draw{.topology = topology, .positions = std::vector<ClipPosition>(count), .indices = std::move(indices)};
  std::vector<Vertices> result;
  for (const AssembledTriangle& triangle : assemble(draw)) {
    EXPECT_EQ(triangle.provoking, 0U);
    result.push_back(triangle.vertices);
  }
  return result;
}

TEST(Assembly, ListTakesThreeVerticesEachAndDropsTheRest) {
  EXPECT_EQ(vertices_of(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, 8), (std::vector<Vertices>{{0, 1, 2}, {3, 4, 5}}));
}

TEST(Assembly, StripKeepsTheWindingAndTheProvokingVertex) {
  EXPECT_EQ(vertices_of(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, 5),
            (std::vector<Vertices>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
}

TEST(Assembly, FanIsProvokedByItsSecondVertex) {
  EXPECT_EQ(vertices_of(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN, 5),
            (std::vector<Vertices>{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}));
}

TEST(Assembly, IndicesChooseTheVertices) {
  EXPECT_EQ(vertices_of(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, 9, std::vector<uint32_t>{8, 1, 7, 2}),
            (std::vector<Vertices>{{8, 1, 7}, {1, 2, 7}}));
}

TEST(Assembly, TooFewVerticesMakeNothing) {
  EXPECT_TRUE(vertices_of(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, 2).empty());
  EXPECT_TRUE(vertices_of(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN, 0).empty());
}

}  // namespace
}  // namespace fillrule::exact
