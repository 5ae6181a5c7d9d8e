#include "cases/model/case.h"

#include <gtest/gtest.h>

namespace fillrule {
namespace {

constexpr uint32_t kRestart = 0xFFFF;

Draw indexed(VkPrimitiveTopology topology, std::vector<uint32_t> indices, bool restart) {
  Draw draw;
  draw.topology = topology;
  draw.indices = std::move(indices);
  draw.index_type = VK_INDEX_TYPE_UINT16;
  draw.primitive_restart = restart;
  return draw;
}

TEST(Case, CountsCompletePrimitives) {
  EXPECT_EQ(primitives_in_run(VK_PRIMITIVE_TOPOLOGY_POINT_LIST, 5), 5U);
  EXPECT_EQ(primitives_in_run(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, 5), 2U);
  EXPECT_EQ(primitives_in_run(VK_PRIMITIVE_TOPOLOGY_LINE_STRIP, 5), 4U);
  EXPECT_EQ(primitives_in_run(VK_PRIMITIVE_TOPOLOGY_LINE_STRIP, 1), 0U);
  EXPECT_EQ(primitives_in_run(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, 5), 1U);
  EXPECT_EQ(primitives_in_run(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, 5), 3U);
  EXPECT_EQ(primitives_in_run(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN, 2), 0U);
}

TEST(Case, RestartsSplitAStrip) {
  const Draw draw =
      indexed(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, {0, 1, 2, 3, kRestart, kRestart, 4, 5, kRestart, 6, 7, 8}, true);
  const std::vector<ElementRun> expected{
      {.first = 0, .count = 4}, {.first = 6, .count = 2}, {.first = 9, .count = 3}};
  EXPECT_EQ(element_runs(draw), expected);
  EXPECT_EQ(primitive_count(draw), 3U);
}

TEST(Case, WithoutRestartTheIndexIsOneLikeOthers) {
  const Draw draw = indexed(VK_PRIMITIVE_TOPOLOGY_LINE_STRIP, {0, kRestart, 1}, false);
  EXPECT_EQ(primitive_count(draw), 2U);
}

TEST(Case, VerticesCarryNoBuiltIns) {
  const std::vector<Varying> varyings{
      {.name = "a", .components = 3},
      {.name = "place", .components = 4, .source = VaryingSource::kFragCoord},
  };
  EXPECT_EQ(component_count(varyings), 7U);
  EXPECT_EQ(vertex_component_count(varyings), 3U);
}

}  // namespace
}  // namespace fillrule
