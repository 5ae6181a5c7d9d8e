// Lines, points, outlined polygons, clip planes and samples, and the sentence for each kind of fault in them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/explain/internal.h"
#include "harness/explain/test_support.h"

namespace fillrule::explain {
namespace {

using exact::Coverage;
using exact::Piece;

Case shape_case(VkPrimitiveTopology topology, std::vector<ClipPosition> positions) {
  Case one = triangle_case("shape", std::move(positions));
  one.draws[0].topology = topology;
  one.draws[0].state.depth_test = false;
  return one;
}

Case line_case() {
  return shape_case(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {at(2, 5.5, 0.5), at(14, 5.5, 0.5)});
}

// In columns 4 to 10.
Case bresenham_case() {
  Case one = shape_case(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {at(4.25, 5.5, 0.5), at(11.25, 5.5, 0.5)});
  one.draws[0].state.line_mode = VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT;
  return one;
}

Case point_case() {
  Case one = shape_case(VK_PRIMITIVE_TOPOLOGY_POINT_LIST, {at(8, 8, 0.5)});
  one.draws[0].point_sizes = {4};
  return one;
}

const Boundary& boundary_named(const PrimitiveFacts& primitive, const std::string& name) {
  const auto found = std::ranges::find(primitive.boundaries, name, &Boundary::name);
  if (found == primitive.boundaries.end()) {
    ADD_FAILURE() << "no boundary " << name;
    static const Boundary none;
    return none;
  }
  return *found;
}

TEST(ExplainShapes, ALineHasTwoSidesAndTwoEnds) {
  const Explanation explanation = explanation_of(line_case(), {.x = 4, .y = 5});
  ASSERT_EQ(explanation.views[0].primitives.size(), 1U);
  const PrimitiveFacts& line = explanation.views[0].primitives[0];
  EXPECT_EQ(line.kind, Piece::Kind::kLine);
  EXPECT_EQ(line.vertices, (std::vector<uint32_t>{0, 1}));
  EXPECT_EQ(line.answer, Coverage::kMust);
  EXPECT_EQ(boundary_named(line, "the right side").distance, 128);
  EXPECT_EQ(boundary_named(line, "the left side").distance, 128);
  EXPECT_EQ(boundary_named(line, "the end at v0").distance, 640);
  EXPECT_EQ(boundary_named(line, "the end at v1").distance, 2432);
  // Both ends and the half width are rounded: 2 m.
  EXPECT_NEAR(boundary_named(line, "the right side").latitude, 1, 0.01);
  // The right is below where a line runs to the right.
  const Explanation below = explanation_of(line_case(), {.x = 4, .y = 6});
  EXPECT_EQ(boundary_named(below.views[0].primitives[0], "the right side").distance, -128);
  EXPECT_EQ(boundary_named(below.views[0].primitives[0], "the right side").form, (std::array<double, 3>{0, -1, -2}));
  EXPECT_EQ(below.views[0].primitives[0].answer, Coverage::kMustNot);
}

TEST(ExplainShapes, ALinesEndMayBeMadeByClipping) {
  const Case one = shape_case(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {at(2, 5.5, 0.5), at(14, 5.5, 1.5)});
  const Explanation explanation = explanation_of(one, {.x = 7, .y = 5});
  const PrimitiveFacts& line = explanation.views[0].primitives[0];
  EXPECT_TRUE(line.clipped);
  EXPECT_EQ(boundary_named(line, "the clipped end near v1").distance, 128);
  EXPECT_EQ(boundary_named(line, "the end at v0").distance, 1408);
}

TEST(ExplainShapes, ReasonsOfLines) {
  const Case one = line_case();
  EXPECT_EQ(explanation_of(one, {.x = 4, .y = 6}, lands(0, true)).reason,
            "The candidate covers a sample 128 subpixels outside the right side of line 0: candidate fault.");
  EXPECT_EQ(explanation_of(one, {.x = 4, .y = 5}, is_lost).reason,
            "The candidate leaves out a sample 128 subpixels inside the right side of line 0: candidate fault.");
  EXPECT_EQ(
      explanation_of(one, {.x = 4, .y = 5}, [](Planes& planes, size_t i) { planes.front_facing[i] = 0; }).reason,
      "The candidate takes primitive 0 for back-facing, as lines and points never are: candidate fault.");
  const Change wrong = [](Planes& planes, size_t i) { planes.varyings[0][i] = 0.75F; };
  const std::string value = explanation_of(one, {.x = 4, .y = 5}, nullptr, wrong).reason;
  EXPECT_TRUE(value.starts_with("The reference's u is 0.75, ")) << value;
  EXPECT_TRUE(value.ends_with(" tolerances from the exact 0.208333333: reference fault.")) << value;
}

TEST(ExplainShapes, ABresenhamLineHasColumnsAndARule) {
  const Explanation explanation = explanation_of(bresenham_case(), {.x = 6, .y = 5});
  const PrimitiveFacts& line = explanation.views[0].primitives[0];
  ASSERT_TRUE(line.bresenham);
  EXPECT_TRUE(line.bresenham->x_major);
  EXPECT_EQ(line.bresenham->distance, 0);
  ASSERT_TRUE(line.bresenham->columns);
  EXPECT_EQ(line.bresenham->columns->least, 7);
  EXPECT_EQ(line.bresenham->columns->most, 7);
  EXPECT_EQ(line.bresenham->diamond_exit, true);
  EXPECT_EQ(line.answer, Coverage::kMay);
  const Explanation beside = explanation_of(bresenham_case(), {.x = 6, .y = 6});
  EXPECT_EQ(beside.views[0].primitives[0].bresenham->diamond_exit, false);
  EXPECT_EQ(std::abs(beside.views[0].primitives[0].bresenham->distance), 1);
  EXPECT_EQ(beside.reason,
            "The sample is within a pixel of the fragments of line 0: the rules for Bresenham lines leave open which "
            "pixels beside them are covered.");
}

TEST(ExplainShapes, ReasonsOfBresenhamLines) {
  // Two fragments in one column, one too few, and one two pixels away.
  EXPECT_EQ(explanation_of(bresenham_case(), {.x = 6, .y = 6}, lands(0, true)).reason,
            "The candidate makes a fragment of line 0, where the diamond-exit rule makes none: candidate fault.");
  EXPECT_EQ(
      explanation_of(bresenham_case(), {.x = 6, .y = 7}, lands(0, true)).reason,
      "The candidate covers a sample 128 subpixels outside the pixels beside its fragments of line 0: candidate "
      "fault.");
  const Change two_lost = [](Planes& planes, size_t index) {
    for (const size_t i : {index, index + 1, index + 2}) is_lost(planes, i);
  };
  EXPECT_EQ(explanation_of(bresenham_case(), {.x = 6, .y = 5}, two_lost).reason,
            "The candidate leaves out a pixel of line 0, where the diamond-exit rule makes a fragment: candidate "
            "fault.");
}

TEST(ExplainShapes, APointHasFourSides) {
  const Explanation explanation = explanation_of(point_case(), {.x = 6, .y = 7});
  const PrimitiveFacts& point = explanation.views[0].primitives[0];
  EXPECT_EQ(point.kind, Piece::Kind::kPoint);
  EXPECT_EQ(point.vertices, std::vector<uint32_t>{0});
  EXPECT_EQ(boundary_named(point, "the left side").distance, 128);
  EXPECT_EQ(boundary_named(point, "the right side").distance, 896);
  EXPECT_EQ(boundary_named(point, "the top").distance, 384);
  EXPECT_EQ(boundary_named(point, "the bottom").distance, 640);
  EXPECT_NEAR(boundary_named(point, "the top").latitude, 0.5, 0.01);
  EXPECT_EQ(explanation_of(point_case(), {.x = 5, .y = 7}, lands(0)).reason,
            "The candidate covers a sample 128 subpixels outside the left side of point 0: candidate fault.");
}

TEST(ExplainShapes, APointOutsideOfTheVolumeIsNotDrawn) {
  Case one = point_case();
  one.draws[0].positions[0] = at(-1, 8, 0.5);
  EXPECT_EQ(explanation_of(one, {.x = 0, .y = 8}, lands(0)).reason,
            "The candidate draws point 0, whose vertex is outside of the clip volume: candidate fault.");
}

TEST(ExplainShapes, PolygonsDrawnAsLinesAndPointsAreTheirParts) {
  Case one = upright("outlined");
  one.draws[0].state.polygon_mode = VK_POLYGON_MODE_LINE;
  const Explanation edges = explanation_of(one, {.x = 7, .y = 1}, lands(0));
  const PrimitiveFacts* const edge = find_primitive(edges.views[0], 0);
  ASSERT_NE(edge, nullptr);
  EXPECT_EQ(edge->polygon, (std::vector<uint32_t>{0, 1, 2}));
  EXPECT_EQ(edge->vertices, (std::vector<uint32_t>{0, 1}));
  EXPECT_EQ(edges.reason,
            "The sample lies exactly on the left side of the line v0-v1 of primitive 0, which rounding "
            "may move by 1 subpixel: both answers are permitted.");
  one.draws[0].state.polygon_mode = VK_POLYGON_MODE_POINT;
  one.draws[0].point_sizes = {3, 3, 3};
  const Explanation corners = explanation_of(one, {.x = 14, .y = 3}, is_lost);
  ASSERT_EQ(corners.views[0].primitives.size(), 1U);
  EXPECT_EQ(name_of(corners.views[0].primitives[0]), "the corner v1 of primitive 0");
}

TEST(ExplainShapes, ClipDistancesAndPlanesOfTheVolumeAreBoundaries) {
  Case one = upright("planes");
  one.draws[0].clip_distance_count = 2;
  one.draws[0].clip_distances = {1, 1, 1, -1, 1, 1};
  const Explanation explanation = explanation_of(one, {.x = 5, .y = 2});
  const PrimitiveFacts& primitive = explanation.views[0].primitives[0];
  const Boundary& plane = boundary_named(primitive, "clip distance 1");
  EXPECT_EQ(plane.kind, Boundary::Kind::kClipDistance);
  // 1, -1 and 1 at the vertices: 0 at x = 8, which is 2.5 px from the sample.
  EXPECT_NEAR(plane.distance, 2.5 * 256, 1e-9);
  EXPECT_EQ(explanation_of(one, {.x = 9, .y = 2}, lands(0)).reason,
            "The candidate covers a sample 384 subpixels outside clip distance 1 of primitive 0: candidate fault.");
  Case signed_depth = triangle_case("signed", {at(2, 2, -0.5), at(14, 2, 0.5), at(2, 14, 0.5)});
  signed_depth.draws[0].state.negative_one_to_one = true;
  const Explanation inside = explanation_of(signed_depth, {.x = 4, .y = 4});
  EXPECT_TRUE(std::ranges::none_of(inside.views[0].primitives[0].boundaries, [](const Boundary& boundary) {
    return boundary.kind == Boundary::Kind::kNear || boundary.kind == Boundary::Kind::kFar;
  }));
}

TEST(ExplainShapes, WhatExcludesAPrimitiveIsTold) {
  const auto reason = [](const Case& one, uint32_t x) {
    return explanation_of(one, {.x = x, .y = 5}, lands(0)).reason;
  };
  Case dropped = upright("dropped");
  dropped.draws[0].cull_distance_count = 1;
  dropped.draws[0].cull_distances = {-1, -2, -3};
  EXPECT_EQ(reason(dropped, 4), "The candidate draws primitive 0, which its cull distances drop: candidate fault.");
  Case culled = upright("culled");
  culled.draws[0].state.cull_mode = VK_CULL_MODE_BACK_BIT;
  EXPECT_EQ(reason(culled, 4), "The candidate draws primitive 0, which is culled: candidate fault.");
  Case scissored = upright("scissored");
  scissored.draws[0].state.scissor = {.offset = {.x = 6, .y = 0}, .extent = {.width = 10, .height = 16}};
  EXPECT_EQ(reason(scissored, 4), "The candidate draws primitive 0 outside of the scissor: candidate fault.");
  const Explanation inside = explanation_of(scissored, {.x = 6, .y = 5});
  EXPECT_EQ(boundary_named(inside.views[0].primitives[0], "the scissor's left side").distance, 128);
  Case masked = upright("masked");
  masked.draws[0].state.sample_mask = 0;
  EXPECT_EQ(reason(masked, 4),
            "The candidate draws primitive 0 at a sample that the sample mask takes away: candidate fault.");
}

// Two triangles that share the diagonal, and one in front of the first.
TEST(ExplainShapes, SharedEdgesAndOrderAreNamed) {
  Case square = triangle_case(
      "square", {at(2, 2, 0.5), at(14, 2, 0.5), at(2, 14, 0.5), at(14, 2, 0.5), at(14, 14, 0.5), at(2, 14, 0.5)});
  EXPECT_EQ(explanation_of(square, {.x = 7, .y = 8}, [](Planes& planes, size_t i) { planes.hits[i] = 2; }).reason,
            "The candidate hits the sample 2 times where once is right, exactly on edge v1-v2 of primitive 0, beside "
            "primitive 1: candidate fault.");
  EXPECT_EQ(
      explanation_of(square, {.x = 7, .y = 8}, is_lost).reason,
      "The candidate leaves out a sample exactly on edge v1-v2 of primitive 0, within what rounding may do, but a "
      "shared edge or the profile leaves no choice: candidate fault.");
  Case layers = triangle_case(
      "layers", {at(2, 2, 0.5), at(14, 2, 0.5), at(2, 14, 0.5), at(2, 2, 0.25), at(14, 2, 0.25), at(2, 14, 0.25)});
  const Change first = [](Planes& planes, size_t i) { planes.owner[i] = 0; };
  const Change second = [](Planes& planes, size_t i) { planes.owner[i] = 1; };
  EXPECT_EQ(explanation_of(layers, {.x = 4, .y = 5}, first).reason,
            "The candidate shows primitive 0 where primitive 1 is right, which is drawn over it: candidate fault.");
  layers.draws[0].state.depth_compare = VK_COMPARE_OP_GREATER;
  layers.target.clear_depth = 0;
  EXPECT_EQ(
      explanation_of(layers, {.x = 4, .y = 5}, second).reason,
      "The candidate shows primitive 1 where primitive 0 is right, which the depth test keeps in front: candidate "
      "fault.");
}

TEST(ExplainShapes, BothAtFaultNamesBoth) {
  EXPECT_EQ(
      explanation_of(upright("both"), {.x = 1, .y = 5}, lands(0), lands(0)).reason,
      "The candidate covers a sample 128 subpixels outside edge v0-v2 of primitive 0, and the reference is wrong "
      "too: both at fault.");
}

}  // namespace
}  // namespace fillrule::explain
