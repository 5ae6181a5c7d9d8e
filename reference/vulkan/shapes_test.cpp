// The pixels of points, lines and outlines, on each driver, and the built-ins of the fragment stage.
#include <gmock/gmock.h>

#include <set>

#include "reference/vulkan/test_support.h"

namespace fillrule::vulkan {
namespace {

class Shapes : public OnEachDriver {};
INSTANTIATE_TEST_SUITE_P(Drivers, Shapes, testing::ValuesIn(kDrivers));

using Pixels = std::set<std::pair<uint32_t, uint32_t>>;

Pixels hit_pixels(const Planes& planes) {
  Pixels hit;
  for (uint32_t y = 0; y < planes.height; ++y) {
    for (uint32_t x = 0; x < planes.width; ++x) {
      if (planes.hits[pixel(planes, x, y)] > 0) hit.emplace(x, y);
    }
  }
  return hit;
}

// Pixels x0 <= x < x1, y0 <= y < y1.
Pixels block(uint32_t x0, uint32_t x1, uint32_t y0, uint32_t y1) {
  Pixels pixels;
  for (uint32_t y = y0; y < y1; ++y) {
    for (uint32_t x = x0; x < x1; ++x) pixels.emplace(x, y);
  }
  return pixels;
}

Case case_of(VkPrimitiveTopology topology, std::vector<ClipPosition> positions) {
  Case drawn = empty_case(16);
  drawn.draws = {draw_of(drawn, std::move(positions))};
  drawn.draws[0].topology = topology;
  return drawn;
}

TEST_P(Shapes, PointsHaveTheSizeOfTheirVertex) {
  Case drawn = case_of(VK_PRIMITIVE_TOPOLOGY_POINT_LIST, {at(16, 4.5F, 4.5F), at(16, 12, 10)});
  drawn.draws[0].point_sizes = {3, 4};
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  Pixels expected = block(3, 6, 3, 6);
  expected.merge(block(10, 14, 8, 12));
  EXPECT_EQ(hit_pixels(*planes), expected);
  EXPECT_EQ(planes->owner[pixel(*planes, 3, 3)], 0U);
  EXPECT_EQ(planes->owner[pixel(*planes, 13, 11)], 1U);
}

TEST_P(Shapes, RecordsPointCoord) {
  Case drawn = case_of(VK_PRIMITIVE_TOPOLOGY_POINT_LIST, {at(16, 6, 8)});
  const Varying coord{.name = "coord", .components = 2, .source = VaryingSource::kPointCoord};
  drawn.varyings = {coord, {.name = "v"}, coord};
  drawn.draws[0].varyings = {7};
  drawn.draws[0].point_sizes = {4};
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  ASSERT_EQ(planes->varyings.size(), 5U);
  for (uint32_t i = 0; i < 4; ++i) {
    const float expected = (static_cast<float>(i) + 0.5F) / 4;
    for (const size_t component : {0U, 3U}) {
      EXPECT_NEAR(planes->varyings[component][pixel(*planes, 4 + i, 7)], expected, 1e-6) << i;
      EXPECT_NEAR(planes->varyings[component + 1][pixel(*planes, 5, 6 + i)], expected, 1e-6) << i;
    }
  }
  EXPECT_EQ(planes->varyings[2][pixel(*planes, 5, 7)], 7.0F);
}

TEST_P(Shapes, RecordsFragCoord) {
  Case drawn = case_of(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, {at(16, 0, 0), at(16, 32, 0), at(16, 0, 32)});
  for (ClipPosition& position : drawn.draws[0].positions) {
    for (float& coordinate : position) coordinate *= 4;
  }
  drawn.varyings = {{.name = "v"}, {.name = "at", .components = 4, .source = VaryingSource::kFragCoord}};
  drawn.draws[0].varyings = {1, 1, 1};
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  const size_t i = pixel(*planes, 9, 3);
  EXPECT_EQ(planes->varyings[1][i], 9.5F);
  EXPECT_EQ(planes->varyings[2][i], 3.5F);
  EXPECT_NEAR(planes->varyings[3][i], 0.5F, 1e-6);
  EXPECT_NEAR(planes->varyings[4][i], 0.25F, 1e-6);
}

TEST_P(Shapes, LinesAreRectangles) {
  // 1 and 3 pixels wide, along the axes.
  Case drawn = case_of(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {at(16, 2, 4.5F), at(16, 7, 4.5F)});
  const auto thin = draw(drawn);
  if (!thin) GTEST_SKIP() << thin.error().what;
  EXPECT_EQ(hit_pixels(*thin), block(2, 7, 4, 5));

  drawn.draws[0].state.line_width = 3;
  const auto wide = draw(drawn);
  if (!wide) GTEST_SKIP() << wide.error().what;
  EXPECT_EQ(hit_pixels(*wide), block(2, 7, 3, 6));
}

TEST_P(Shapes, BresenhamLinesLeaveOutTheLastPixel) {
  // A slope of 3/4: the rectangle of the same line has pixels (4, 3) and (8, 6), too.
  Case drawn = case_of(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {at(16, 2.5F, 2.5625F), at(16, 10.5F, 8.5625F)});
  drawn.draws[0].state.line_mode = VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT;
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  EXPECT_EQ(hit_pixels(*planes), (Pixels{{2, 2}, {3, 3}, {4, 4}, {5, 4}, {6, 5}, {7, 6}, {8, 7}, {9, 7}}));
}

// Two triangles of a strip, with the primitive before them to count.
Case two_outlines(VkPolygonMode mode) {
  Case drawn = case_of(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
                       {at(16, 2.5F, 2.5F), at(16, 2.5F, 12.5F), at(16, 12.5F, 2.5F), at(16, 12.5F, 12.5F)});
  drawn.draws[0].state.polygon_mode = mode;
  drawn.draws.insert(drawn.draws.begin(), drawn.draws[0]);
  drawn.draws[0].state.cull_mode = VK_CULL_MODE_FRONT_AND_BACK;
  return drawn;
}

TEST_P(Shapes, PolygonsCanBeOutlines) {
  const auto planes = draw(two_outlines(VK_POLYGON_MODE_LINE));
  if (!planes) GTEST_SKIP() << planes.error().what;
  const auto owner = [&](uint32_t x, uint32_t y) { return planes->owner[pixel(*planes, x, y)]; };
  EXPECT_EQ(owner(2, 7), 2U);   // left
  EXPECT_EQ(owner(7, 2), 2U);   // top
  EXPECT_EQ(owner(12, 7), 3U);  // right
  EXPECT_EQ(owner(7, 12), 3U);  // bottom
  EXPECT_EQ(owner(9, 5), 3U);   // the shared diagonal, drawn last by the second
  EXPECT_GE(planes->hits[pixel(*planes, 9, 5)], 2U);
  EXPECT_EQ(owner(5, 5), kNoOwner);
  EXPECT_EQ(owner(10, 10), kNoOwner);
  EXPECT_EQ(planes->front_facing[pixel(*planes, 2, 7)], 1U);
}

TEST_P(Shapes, PolygonsCanBeCorners) {
  Case drawn = two_outlines(VK_POLYGON_MODE_POINT);
  for (Draw& draw : drawn.draws) draw.point_sizes = {1, 3, 1, 1};
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  Pixels expected = block(1, 4, 11, 14);
  expected.insert({{2, 2}, {12, 2}, {12, 12}});
  EXPECT_EQ(hit_pixels(*planes), expected);
  EXPECT_EQ(planes->owner[pixel(*planes, 2, 2)], 2U);
  EXPECT_EQ(planes->hits[pixel(*planes, 2, 2)], 1U);
  EXPECT_EQ(planes->owner[pixel(*planes, 2, 12)], 3U);
  EXPECT_EQ(planes->hits[pixel(*planes, 2, 12)], 2U);
  EXPECT_EQ(planes->owner[pixel(*planes, 12, 12)], 3U);
  EXPECT_EQ(planes->front_facing[pixel(*planes, 2, 2)], 1U);
}

}  // namespace
}  // namespace fillrule::vulkan
