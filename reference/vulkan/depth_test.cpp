// What becomes of depths, on each driver: formats, bias, bounds, clamp and clip.
#include <gmock/gmock.h>

#include <cmath>

#include "reference/vulkan/test_support.h"

namespace fillrule::vulkan {
namespace {

class Depth : public OnEachDriver {};
INSTANTIATE_TEST_SUITE_P(Drivers, Depth, testing::ValuesIn(kDrivers));

// A triangle over the whole target at depth z, without a compare that could fail.
Case covered(float z) {
  Case drawn = empty_case(8);
  drawn.draws = {draw_of(drawn, {at(8, 0, 0, z), at(8, 16, 0, z), at(8, 0, 16, z)})};
  drawn.draws[0].state.depth_test = true;
  drawn.draws[0].state.depth_compare = VK_COMPARE_OP_ALWAYS;
  return drawn;
}

// A triangle over the target's upper left half, with depth 0 at the left border and 1 at the right one.
Case slope() {
  Case drawn = covered(0);
  drawn.draws[0].positions = {at(8, 0, 0, 0), at(8, 8, 0, 1), at(8, 0, 8, 0)};
  return drawn;
}

TEST_P(Depth, IsQuantisedToTheFormat) {
  struct Format {
    VkFormat format;
    double max;
  };
  for (const auto& [format, max] :
       {Format{VK_FORMAT_D16_UNORM, 65535}, Format{VK_FORMAT_X8_D24_UNORM_PACK32, 16777215}}) {
    for (const float z : {0.0F, 0.3F, 0.7001F, 1.0F}) {
      Case drawn = covered(z);
      drawn.target.depth_format = format;
      drawn.target.width = 7;  // rows that are no whole vec4
      const auto planes = draw(drawn);
      if (!planes) GTEST_SKIP() << planes.error().what;
      ASSERT_EQ(planes->depth.size(), 56U);
      const auto expected = static_cast<float>(std::nearbyint(z * static_cast<float>(max)) / max);
      EXPECT_THAT(planes->depth, testing::Each(expected)) << format << ' ' << z;
    }
  }
}

TEST_P(Depth, IsBiased) {
  // The slope is 1/8 a pixel. The constant's unit is 2^(e - 23), where e is the exponent of the largest depth, 1.
  Case drawn = slope();
  const auto at_middle = [&](const DepthBias& bias) {
    drawn.draws[0].state.depth_bias = bias;
    const auto planes = draw(drawn);
    return planes ? planes->depth[pixel(*planes, 3, 2)] : NAN;
  };
  EXPECT_NEAR(at_middle({}), 0.4375, 1e-6);
  EXPECT_NEAR(at_middle({.slope_factor = 2}), 0.6875, 1e-6);
  EXPECT_NEAR(at_middle({.slope_factor = -1}), 0.3125, 1e-6);
  EXPECT_NEAR(at_middle({.slope_factor = 2, .clamp = 0.125F}), 0.5625, 1e-6);
  EXPECT_NEAR(at_middle({.slope_factor = -2, .clamp = -0.125F}), 0.3125, 1e-6);
  EXPECT_NEAR(at_middle({.constant_factor = 1 << 20}), 0.4375 + 0.125, 1e-6);
}

TEST_P(Depth, IsHeldAgainstItsBounds) {
  Case drawn = slope();
  drawn.draws.push_back(covered(0.5F).draws[0]);
  drawn.draws[1].state.depth_bounds = {.min = 0.25F, .max = 0.5F};
  drawn.draws[1].state.depth_write = false;
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  for (uint32_t x = 0; x < 7; ++x) {
    EXPECT_EQ(planes->hits[pixel(*planes, x, 0)], x >= 2 && x < 4 ? 2U : 1U) << x;
  }
}

// The slope from -0.5 at the left to 1.5 at the target's right border: inside [0, 1] for x = 2 to 5.
Case beyond_both_planes() {
  Case drawn = covered(0);
  drawn.draws[0].positions[0][2] = -0.5F;
  drawn.draws[0].positions[1][2] = 3.5F;
  drawn.draws[0].positions[2][2] = -0.5F;
  return drawn;
}

TEST_P(Depth, IsClippedClampedOrBoth) {
  struct Row {
    bool clip;
    bool clamp;
    uint32_t first;  // pixel that is hit
    uint32_t end;
  };
  for (const Row& row :
       {Row{true, false, 2, 6}, Row{true, true, 2, 6}, Row{false, true, 0, 8}, Row{false, false, 0, 8}}) {
    Case drawn = beyond_both_planes();
    RasterState& state = drawn.draws[0].state;
    state.depth_clip = row.clip;
    state.depth_clamp = row.clamp;
    state.viewport.minDepth = 0.25F;
    state.viewport.maxDepth = 0.75F;
    const auto planes = draw(drawn);
    if (!planes) GTEST_SKIP() << planes.error().what;
    for (uint32_t x = 0; x < 8; ++x) {
      const bool hit = x >= row.first && x < row.end;
      EXPECT_EQ(planes->hits[pixel(*planes, x, 1)], hit ? 1U : 0U) << x;
      float expected = 0.25F + 0.5F * (-0.5F + (static_cast<float>(x) + 0.5F) / 4);
      if (row.clamp) expected = std::clamp(expected, 0.25F, 0.75F);
      if (!hit) continue;
      EXPECT_NEAR(planes->depth[pixel(*planes, x, 1)], expected, 1e-6) << x;
    }
  }
}

TEST_P(Depth, ReachesFromMinusOneToOne) {
  // Depths from -1 at the left to 1 at the target's right border.
  Case drawn = covered(-1);
  drawn.draws[0].positions[1][2] = 3;
  drawn.draws[0].state.negative_one_to_one = true;
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  for (uint32_t x = 0; x < 8; ++x) {
    EXPECT_EQ(planes->hits[pixel(*planes, x, 1)], 1U) << x;
    EXPECT_NEAR(planes->depth[pixel(*planes, x, 1)], (static_cast<float>(x) + 0.5F) / 8, 1e-6) << x;
  }
}

}  // namespace
}  // namespace fillrule::vulkan
