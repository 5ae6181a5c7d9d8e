#include "reference/exact/outline.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fillrule::exact {
namespace {

constexpr uint32_t kSize = 32;

ClipPosition at(double x, double y, double z = 0.5) {
  return {static_cast<float>(x / 16 - 1), static_cast<float>(y / 16 - 1), static_cast<float>(z), 1};
}

Case case_of(VkPrimitiveTopology topology, std::vector<ClipPosition> positions) {
  Case result{.target = {.width = kSize, .height = kSize}};
  Draw draw{.topology = topology, .positions = std::move(positions)};
  draw.state.viewport = {.x = 0, .y = 0, .width = kSize, .height = kSize, .minDepth = 0, .maxDepth = 1};
  draw.state.scissor = {.offset = {}, .extent = {.width = kSize, .height = kSize}};
  result.draws.push_back(draw);
  return result;
}

// The owners that must and those that may cover the pixel.
struct At {
  std::vector<uint32_t> must;
  std::vector<uint32_t> may;
};

At at_pixel(const Expectation& expectation, uint32_t x, uint32_t y) {
  std::vector<Entry> entries;
  expectation.collect(size_t{y} * kSize + x, entries);
  At result;
  for (const Entry& entry : entries) {
    auto& list = entry.coverage == Coverage::kMust ? result.must : result.may;
    list.push_back(expectation.pieces()[entry.piece].owner);
  }
  return result;
}

using Owners = std::vector<uint32_t>;

TEST(Outline, StripsAndListsOfLinesAreNumberedAcrossRestarts) {
  Case strip =
      case_of(VK_PRIMITIVE_TOPOLOGY_LINE_STRIP, {at(2, 4.5), at(12, 4.5), at(22, 4.5), at(2, 9.5), at(22, 9.5)});
  strip.draws[0].primitive_restart = true;
  strip.draws[0].indices = std::vector<uint32_t>{0, 1, 2, 0xFFFFFFFF, 3, 4};
  const Expectation expectation(strip, 8);
  EXPECT_EQ(expectation.pieces().size(), 3U);
  EXPECT_EQ(at_pixel(expectation, 6, 4).must, Owners{0});
  EXPECT_EQ(at_pixel(expectation, 16, 4).must, Owners{1});
  EXPECT_EQ(at_pixel(expectation, 16, 9).must, Owners{2});
  EXPECT_EQ(at_pixel(expectation, 16, 6).must, Owners{});
  EXPECT_TRUE(expectation.pieces()[2].front_facing);
  EXPECT_EQ(expectation.pieces()[1].provoking, 1U);

  Case list = case_of(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {at(2, 4.5), at(12, 4.5), at(2, 9.5), at(22, 9.5), at(1, 1)});
  list.draws[0].state.provoking_vertex = VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
  const Expectation of_list(list, 8);
  EXPECT_EQ(of_list.pieces().size(), 2U);
  EXPECT_EQ(of_list.pieces()[1].provoking, 3U);
}

TEST(Outline, PointsHaveTheirOwnSizes) {
  Case points = case_of(VK_PRIMITIVE_TOPOLOGY_POINT_LIST, {at(8, 8), at(24, 24)});
  points.draws[0].point_sizes = {2, 8};
  const Expectation expectation(points, 8);
  EXPECT_EQ(at_pixel(expectation, 8, 8).must, Owners{0});
  EXPECT_EQ(at_pixel(expectation, 9, 8).must, Owners{});
  EXPECT_EQ(at_pixel(expectation, 27, 20).must, Owners{1});
}

TEST(Outline, CullDistancesDropWhatIsOutsideOfOneAtAllVertices) {
  Case lines = case_of(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {at(2, 4.5), at(22, 4.5), at(2, 9.5), at(22, 9.5)});
  lines.draws[0].cull_distance_count = 1;
  lines.draws[0].cull_distances = {-1, 1, -1, -2};
  const Expectation expectation(lines, 8);
  EXPECT_EQ(at_pixel(expectation, 6, 4).must, Owners{0});
  EXPECT_EQ(at_pixel(expectation, 6, 9).must, Owners{});
  EXPECT_EQ(at_pixel(expectation, 6, 9).may, Owners{});
}

Case outlined(VkPolygonMode mode, std::vector<ClipPosition> positions) {
  Case result = case_of(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, std::move(positions));
  result.draws[0].state.polygon_mode = mode;
  return result;
}

TEST(Outline, APolygonInLineModeIsItsThreeEdges) {
  const Expectation expectation(outlined(VK_POLYGON_MODE_LINE, {at(4.5, 4.5), at(28.5, 4.5), at(4.5, 28.5)}), 8);
  EXPECT_EQ(expectation.pieces().size(), 3U);
  EXPECT_EQ(at_pixel(expectation, 12, 4).must, Owners{0});
  EXPECT_EQ(at_pixel(expectation, 4, 12).must, Owners{0});
  EXPECT_EQ(at_pixel(expectation, 16, 16).must, Owners{0});
  EXPECT_EQ(at_pixel(expectation, 9, 9).must, Owners{});
  EXPECT_EQ(at_pixel(expectation, 9, 9).may, Owners{});
}

TEST(Outline, APolygonInPointModeIsItsCornersOfTheVerticesSizeOrOfSizeOne) {
  Case corners = outlined(VK_POLYGON_MODE_POINT, {at(4.5, 4.5), at(28.5, 4.5), at(4.5, 28.5)});
  corners.draws[0].point_sizes = {1, 5, 1};
  const Expectation expectation(corners, 8);
  EXPECT_EQ(at_pixel(expectation, 4, 4).must, Owners{0});
  EXPECT_EQ(at_pixel(expectation, 28, 4).must, Owners{0});
  EXPECT_EQ(at_pixel(expectation, 29, 4).must, Owners{});
  EXPECT_EQ(at_pixel(expectation, 29, 4).may, Owners{0});
  EXPECT_EQ(at_pixel(expectation, 12, 4).may, Owners{});
}

TEST(Outline, WhatIsCulledHasNoOutline) {
  for (const VkCullModeFlags cull : {VK_CULL_MODE_FRONT_BIT, VK_CULL_MODE_BACK_BIT}) {
    Case culled = outlined(VK_POLYGON_MODE_LINE, {at(4.5, 4.5), at(28.5, 4.5), at(4.5, 28.5)});
    culled.draws[0].state.cull_mode = cull;
    // Clockwise on the framebuffer, so back-facing by default.
    const bool drawn = cull == VK_CULL_MODE_FRONT_BIT;
    EXPECT_EQ(at_pixel(Expectation(culled, 8), 12, 4).must, drawn ? Owners{0} : Owners{});
    EXPECT_EQ(at_pixel(Expectation(culled, 8), 12, 4).may, Owners{});
  }
}

TEST(Outline, WithoutAreaAnOutlineMayBeDropped) {
  const Expectation expectation(outlined(VK_POLYGON_MODE_LINE, {at(4.5, 4.5), at(28.5, 4.5), at(16.5, 4.5)}), 8);
  EXPECT_EQ(at_pixel(expectation, 8, 4).must, Owners{});
  EXPECT_EQ(at_pixel(expectation, 8, 4).may, (Owners{0, 0}));
  // Nor with one vertex behind the eye, on the same line.
  const ClipPosition beyond = at(40.5, 4.5);
  const Expectation behind(
      outlined(VK_POLYGON_MODE_LINE, {at(4.5, 4.5), at(28.5, 4.5), {-beyond[0], -beyond[1], -beyond[2], -1}}), 8);
  EXPECT_EQ(at_pixel(behind, 8, 4).must, Owners{});
}

TEST(Outline, ClippingMayAddEdgesAndCorners) {
  // Cut off at x = 32, from y = 12.25 to 20.75.
  for (const VkPolygonMode mode : {VK_POLYGON_MODE_LINE, VK_POLYGON_MODE_POINT}) {
    const Expectation expectation(outlined(mode, {at(4.5, 4.5), at(44.5, 16.5), at(4.5, 28.5)}), 8);
    EXPECT_EQ(at_pixel(expectation, 31, 16).must, Owners{});
    // An edge, or two corners.
    EXPECT_EQ(at_pixel(expectation, 31, 16).may, mode == VK_POLYGON_MODE_LINE ? Owners{0} : (Owners{0, 0}));
    EXPECT_EQ(at_pixel(expectation, 31, 8).may, Owners{});
    EXPECT_EQ(at_pixel(expectation, 29, 16).may, Owners{});
    EXPECT_EQ(at_pixel(expectation, 28, 11).may, Owners{});  // on an edge, away from the border
  }
  // z runs from -0.5 at the left edge: the near plane's trace is at x = 16.5.
  const Expectation near(
      outlined(VK_POLYGON_MODE_LINE, {at(4.5, 4.5, -0.5), at(28.5, 16.5, 0.5), at(4.5, 28.5, -0.5)}), 8);
  EXPECT_EQ(at_pixel(near, 16, 16).may, Owners{0});
  EXPECT_EQ(at_pixel(near, 18, 16).may, Owners{});
  EXPECT_EQ(at_pixel(near, 4, 16).may, Owners{});
  EXPECT_EQ(at_pixel(near, 4, 16).must, Owners{});
}

}  // namespace
}  // namespace fillrule::exact
