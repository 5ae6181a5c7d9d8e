#include "renderer/primitive_assembly.h"

#include <gmock/gmock.h>

namespace fillrule::renderer {
namespace {

using ::testing::ElementsAre;

TEST(TriangleCount, CompleteTrianglesOnly) {
  constexpr auto kList = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  EXPECT_EQ(triangle_count(kList, 0), 0U);
  EXPECT_EQ(triangle_count(kList, 5), 1U);
  EXPECT_EQ(triangle_count(kList, 6), 2U);
  for (const auto topology : {VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN}) {
    EXPECT_EQ(triangle_count(topology, 0), 0U);
    EXPECT_EQ(triangle_count(topology, 2), 0U);
    EXPECT_EQ(triangle_count(topology, 3), 1U);
    EXPECT_EQ(triangle_count(topology, 5), 3U);
  }
}

TEST(TriangleElements, ProvokingVertexFirstInVulkansOrder) {
  constexpr auto kList = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  constexpr auto kStrip = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  constexpr auto kFan = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN;
  EXPECT_THAT(triangle_elements(kList, 2), ElementsAre(6U, 7U, 8U));
  EXPECT_THAT(triangle_elements(kStrip, 0), ElementsAre(0U, 1U, 2U));
  EXPECT_THAT(triangle_elements(kStrip, 1), ElementsAre(1U, 3U, 2U));
  EXPECT_THAT(triangle_elements(kStrip, 2), ElementsAre(2U, 3U, 4U));
  EXPECT_THAT(triangle_elements(kFan, 0), ElementsAre(1U, 2U, 0U));
  EXPECT_THAT(triangle_elements(kFan, 3), ElementsAre(4U, 5U, 0U));
}

TEST(TriangleVertices, GoThroughTheIndices) {
  const std::array<uint32_t, 4> indices = {7, 5, 3, 1};
  const Indices span = std::span<const uint32_t>(indices);
  EXPECT_THAT(triangle_vertices(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, span, 1), ElementsAre(5U, 1U, 3U));
  EXPECT_THAT(triangle_vertices(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, std::nullopt, 1), ElementsAre(1U, 3U, 2U));
}

}  // namespace
}  // namespace fillrule::renderer
