#include "reference/exact/depth_bias.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/exact/expectation.h"

namespace fillrule::exact {
namespace {

constexpr float kSize = 32;

// Two vertices, 16 pixels apart in x, of depths 0.25 and 0.5.
Case biased_case(VkPrimitiveTopology topology, const DepthBias& bias) {
  Case result{.target = {.width = 32, .height = 32}};
  Draw draw{.topology = topology, .positions = {{-0.5F, 0, 0.25F, 1}, {0.5F, 0, 0.5F, 1}}};
  draw.state.viewport = {.x = 0, .y = 0, .width = kSize, .height = kSize, .minDepth = 0, .maxDepth = 1};
  draw.state.scissor = {.offset = {}, .extent = {.width = 32, .height = 32}};
  draw.state.depth_bias = bias;
  result.draws.push_back(std::move(draw));
  return result;
}

// What the depth at the first vertex may be.
struct Range {
  double low = 0;
  double high = 0;
};
Range depths_at_first_vertex(VkPrimitiveTopology topology, const DepthBias& bias) {
  const Case one = biased_case(topology, bias);
  const Expectation expectation(one, 8);
  const Expected depth = values_of(one, expectation.pieces()[0])->depth(8, 16);
  return {.low = depth.value - depth.spread, .high = depth.value + depth.spread};
}

TEST(DepthBias, OfALineOrAPointMayBeLeftOutOrNot) {
  // 2^20 steps: 2^(-2 - 23) where the point, and 2^(-1 - 23) where the line is deepest.
  const DepthBias bias{.constant_factor = 0x1p20F};
  const Range point = depths_at_first_vertex(VK_PRIMITIVE_TOPOLOGY_POINT_LIST, bias);
  EXPECT_NEAR(point.low, 0.25, 1e-6);
  EXPECT_NEAR(point.high, 0.25 + 0x1p-5, 1e-6);
  const Range line = depths_at_first_vertex(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, bias);
  EXPECT_NEAR(line.low, 0.25, 1e-6);
  EXPECT_NEAR(line.high, 0.25 + 0x1p-4, 1e-6);
}

TEST(DepthBias, OfALineMayCountItsSlopeInAnyWay) {
  // 1/64 a pixel.
  const double steepest = std::sqrt(2.0) / 64;
  const Range line = depths_at_first_vertex(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {.slope_factor = 4});
  EXPECT_NEAR(line.low, 0.25, 1e-6);
  EXPECT_NEAR(line.high, 0.25 + 4 * steepest, 1e-6);
  const Range towards = depths_at_first_vertex(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {.slope_factor = -4});
  EXPECT_NEAR(towards.low, 0.25 - 4 * steepest, 1e-6);
  EXPECT_NEAR(towards.high, 0.25, 1e-6);
  // Without the slope, and with all of it.
  const Range both =
      depths_at_first_vertex(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {.constant_factor = 0x1p20F, .slope_factor = -4});
  EXPECT_NEAR(both.low, 0.25 - 4 * steepest, 1e-6);
  EXPECT_NEAR(both.high, 0.25 + 0x1p-4, 1e-6);
  const Range point = depths_at_first_vertex(VK_PRIMITIVE_TOPOLOGY_POINT_LIST, {.slope_factor = 4});
  EXPECT_NEAR(point.high, 0.25, 1e-6);
}

TEST(DepthBias, OfALineIsClamped) {
  const Range line = depths_at_first_vertex(VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {.slope_factor = 4, .clamp = 0x1p-6F});
  EXPECT_NEAR(line.low, 0.25, 1e-6);
  EXPECT_NEAR(line.high, 0.25 + 0x1p-6, 1e-6);
}

}  // namespace
}  // namespace fillrule::exact
