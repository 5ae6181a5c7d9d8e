#include "renderer/primitive_assembly.h"

#include <gmock/gmock.h>

namespace fillrule::renderer {
namespace {

using ::testing::ElementsAre;

constexpr auto kList = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
constexpr auto kStrip = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
constexpr auto kFan = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN;
constexpr auto kFirst = VK_PROVOKING_VERTEX_MODE_FIRST_VERTEX_EXT;
constexpr auto kLast = VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;

uint32_t count(VkPrimitiveTopology topology, uint32_t vertices) {
  return PrimitiveAssembly({.topology = topology, .vertex_count = vertices}, kFirst).count();
}

TEST(PrimitiveAssembly, CompleteTrianglesOnly) {
  EXPECT_EQ(count(kList, 0), 0U);
  EXPECT_EQ(count(kList, 5), 1U);
  EXPECT_EQ(count(kList, 6), 2U);
  for (const auto topology : {kStrip, kFan}) {
    EXPECT_EQ(count(topology, 0), 0U);
    EXPECT_EQ(count(topology, 2), 0U);
    EXPECT_EQ(count(topology, 3), 1U);
    EXPECT_EQ(count(topology, 5), 3U);
  }
}

TEST(TriangleElements, TheFirstVertexProvoking) {
  EXPECT_THAT(triangle_elements(kList, kFirst, 2), ElementsAre(6U, 7U, 8U));
  EXPECT_THAT(triangle_elements(kStrip, kFirst, 0), ElementsAre(0U, 1U, 2U));
  EXPECT_THAT(triangle_elements(kStrip, kFirst, 1), ElementsAre(1U, 3U, 2U));
  EXPECT_THAT(triangle_elements(kStrip, kFirst, 2), ElementsAre(2U, 3U, 4U));
  EXPECT_THAT(triangle_elements(kFan, kFirst, 0), ElementsAre(1U, 2U, 0U));
  EXPECT_THAT(triangle_elements(kFan, kFirst, 3), ElementsAre(4U, 5U, 0U));
}

// Vulkan's orders (i, i + 1, i + 2), odd (i + 1, i, i + 2), and (0, i + 1, i + 2), begun at the last vertex.
TEST(TriangleElements, TheLastVertexProvoking) {
  EXPECT_THAT(triangle_elements(kList, kLast, 2), ElementsAre(8U, 6U, 7U));
  EXPECT_THAT(triangle_elements(kStrip, kLast, 0), ElementsAre(2U, 0U, 1U));
  EXPECT_THAT(triangle_elements(kStrip, kLast, 1), ElementsAre(3U, 2U, 1U));
  EXPECT_THAT(triangle_elements(kStrip, kLast, 2), ElementsAre(4U, 2U, 3U));
  EXPECT_THAT(triangle_elements(kFan, kLast, 0), ElementsAre(2U, 0U, 1U));
  EXPECT_THAT(triangle_elements(kFan, kLast, 3), ElementsAre(5U, 0U, 4U));
}

TEST(PrimitiveElements, OfLinesAndPoints) {
  constexpr auto kLines = VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
  constexpr auto kLineStrip = VK_PRIMITIVE_TOPOLOGY_LINE_STRIP;
  constexpr auto kPoints = VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
  EXPECT_THAT(primitive_elements(kLines, kFirst, 3), ElementsAre(6U, 7U, 7U));
  EXPECT_THAT(primitive_elements(kLines, kLast, 3), ElementsAre(7U, 6U, 6U));
  EXPECT_THAT(primitive_elements(kLineStrip, kFirst, 3), ElementsAre(3U, 4U, 4U));
  EXPECT_THAT(primitive_elements(kLineStrip, kLast, 3), ElementsAre(4U, 3U, 3U));
  EXPECT_THAT(primitive_elements(kPoints, kLast, 3), ElementsAre(3U, 3U, 3U));
  // Whichever provokes, the line goes the same way.
  for (const auto provoking : {kFirst, kLast}) {
    const auto elements = primitive_elements(kLines, provoking, 3);
    EXPECT_EQ(elements[line_ends(provoking).from], 6U);
    EXPECT_EQ(elements[line_ends(provoking).to], 7U);
  }
  EXPECT_EQ(count(kLines, 5), 2U);
  EXPECT_EQ(count(kLineStrip, 5), 4U);
  EXPECT_EQ(count(kPoints, 5), 5U);
}

TEST(Shape, IsThatOfTheTopologyOrOfThePolygonMode) {
  EXPECT_EQ(shape_of(kStrip, VK_POLYGON_MODE_FILL), Shape::kPolygon);
  EXPECT_EQ(shape_of(kFan, VK_POLYGON_MODE_LINE), Shape::kLine);
  EXPECT_EQ(shape_of(kList, VK_POLYGON_MODE_POINT), Shape::kPoint);
  EXPECT_EQ(shape_of(VK_PRIMITIVE_TOPOLOGY_LINE_STRIP, VK_POLYGON_MODE_POINT), Shape::kLine);
  EXPECT_EQ(shape_of(VK_PRIMITIVE_TOPOLOGY_POINT_LIST, VK_POLYGON_MODE_FILL), Shape::kPoint);
}

TEST(PrimitiveAssembly, GoesThroughTheIndicesAndTheOffset) {
  const std::array<uint32_t, 4> indices = {7, 5, 3, 1};
  const Indices span = std::span<const uint32_t>(indices);
  const auto second = [&](const Indices& chosen, int32_t offset) {
    return PrimitiveAssembly({.topology = kStrip, .vertex_count = 4, .indices = chosen, .vertex_offset = offset},
                             kFirst)
        .vertices(1);
  };
  EXPECT_THAT(second(span, 0), ElementsAre(5U, 1U, 3U));
  EXPECT_THAT(second(span, 10), ElementsAre(15U, 11U, 13U));
  EXPECT_THAT(second(span, -1), ElementsAre(4U, 0U, 2U));
  EXPECT_THAT(second(std::nullopt, 0), ElementsAre(1U, 3U, 2U));
}

TEST(PrimitiveAssembly, EachRunBeginsAnewButNumbersRunOn) {
  const std::array<uint32_t, 11> indices = {0, 1, 2, 3, 99, 4, 5, 99, 6, 7, 8};
  const std::array<ElementRun, 3> runs{{{0, 4}, {5, 2}, {8, 3}}};
  const VertexStream stream{
      .topology = kStrip, .vertex_count = 9, .indices = std::span<const uint32_t>(indices), .runs = runs};
  EXPECT_TRUE(check_indices(stream));
  const PrimitiveAssembly assembly(stream, kFirst);
  ASSERT_EQ(assembly.count(), 3U);
  EXPECT_THAT(assembly.vertices(0), ElementsAre(0U, 1U, 2U));
  EXPECT_THAT(assembly.vertices(1), ElementsAre(1U, 3U, 2U));
  EXPECT_THAT(assembly.vertices(2), ElementsAre(6U, 7U, 8U));
  VertexStream none = stream;
  none.runs = std::span<const ElementRun>();
  EXPECT_EQ(PrimitiveAssembly(none, kFirst).count(), 0U);
}

TEST(PrimitiveAssembly, SeveralAtOnceAreThoseOneByOne) {
  const std::array<uint32_t, 14> indices = {9, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 3, 2, 1};
  const std::array<ElementRun, 1> one_run{{{1, 12}}};
  const std::array<ElementRun, 2> two_runs{{{0, 6}, {7, 6}}};
  for (const std::span<const ElementRun> runs :
       {std::span<const ElementRun>(one_run), std::span<const ElementRun>(two_runs)}) {
    for (const VkPrimitiveTopology topology : {VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, kStrip}) {
      for (const VkProvokingVertexModeEXT provoking : {kFirst, VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT}) {
        for (const bool is_indexed : {true, false}) {
          VertexStream stream{.topology = topology, .vertex_count = 14, .vertex_offset = 2, .runs = runs};
          if (is_indexed) stream.indices = std::span<const uint32_t>(indices);
          const PrimitiveAssembly assembly(stream, provoking);
          std::vector<std::array<uint32_t, 3>> several(assembly.count() - 1);
          assembly.vertices(1, several);
          for (uint32_t i = 1; i < assembly.count(); ++i) {
            EXPECT_EQ(several[i - 1], assembly.vertices(i)) << i << ", topology " << topology;
          }
        }
      }
    }
  }
}

TEST(CheckIndices, WithTheOffsetTheyMustBeVertices) {
  const std::array<uint32_t, 3> indices = {0, 1, 3};
  const auto is_drawn = [&](uint32_t vertices, int32_t offset) {
    return check_indices(
               {.vertex_count = vertices, .indices = std::span<const uint32_t>(indices), .vertex_offset = offset})
        .has_value();
  };
  EXPECT_TRUE(is_drawn(4, 0));
  EXPECT_FALSE(is_drawn(3, 0));
  EXPECT_TRUE(is_drawn(6, 2));
  EXPECT_FALSE(is_drawn(6, 3));
  EXPECT_FALSE(is_drawn(6, -1));
}

TEST(CheckIndices, TheFirstThatIsNoVertexIsNamed) {
  const std::array<uint32_t, 5> indices = {2, 0, 7, 9, 1};
  const auto checked = check_indices({.vertex_count = 7, .indices = std::span<const uint32_t>(indices)});
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().what, "index 7 in a draw of 7 vertices");
}

}  // namespace
}  // namespace fillrule::renderer
