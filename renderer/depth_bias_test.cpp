#include "renderer/depth_bias.h"

#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

constexpr WindowPlane kSlope{.at_anchor = 0.25, .step_x = -0.125, .step_y = 0.0625};

TEST(DepthBias, ConstantCountsStepsOfTheFormat) {
  const DepthBias bias{.constant_factor = 3};
  EXPECT_EQ(depth_bias(bias, kSlope, max_depth_code(VK_FORMAT_D16_UNORM), 0.5), 3 * 0x1p-15);
  EXPECT_EQ(depth_bias(bias, kSlope, max_depth_code(VK_FORMAT_X8_D24_UNORM_PACK32), 0.5), 3 * 0x1p-23);
  EXPECT_EQ(depth_bias(bias, kSlope, 0, 1.0), 3 * 0x1p-23);
  EXPECT_EQ(depth_bias(bias, kSlope, 0, 0.75), 3 * 0x1p-24);
  EXPECT_EQ(depth_bias(bias, kSlope, 0, 0.25), 3 * 0x1p-25);
  EXPECT_EQ(depth_bias(bias, kSlope, 0, 0), 3 * 0x1p-149);
}

TEST(DepthBias, SlopeCountsTheSteeperDirection) {
  EXPECT_EQ(depth_bias({.slope_factor = 2}, kSlope, 0, 0.5), 0.25);
  EXPECT_EQ(depth_bias({.slope_factor = -2}, kSlope, 0, 0.5), -0.25);
  EXPECT_EQ(depth_bias({.slope_factor = 2}, {.step_x = 0.0625, .step_y = -0.5}, 0, 0.5), 1);
  EXPECT_EQ(depth_bias({.constant_factor = 1, .slope_factor = 2}, kSlope, 65535, 0.5), 0.25 + 0x1p-15);
}

TEST(DepthBias, ClampLimitsOneSide) {
  EXPECT_EQ(depth_bias({.slope_factor = 2, .clamp = 0.125F}, kSlope, 0, 0.5), 0.125);
  EXPECT_EQ(depth_bias({.slope_factor = -2, .clamp = 0.125F}, kSlope, 0, 0.5), -0.25);
  EXPECT_EQ(depth_bias({.slope_factor = -2, .clamp = -0.125F}, kSlope, 0, 0.5), -0.125);
  EXPECT_EQ(depth_bias({.slope_factor = 2, .clamp = -0.125F}, kSlope, 0, 0.5), 0.25);
}

TestScene biased(std::initializer_list<ClipPosition> positions, const DepthBias& bias) {
  TestScene scene(8, 8);
  scene.state.depth_test = true;
  scene.state.depth_bias = bias;
  scene.positions = positions;
  return scene;
}

TEST(DepthBias, IsAddedToTheDepthOfEveryPixel) {
  // z = x / 32.
  const TestScene ruler(8, 8);
  const TestScene scene = biased({ruler.at(0, 0, 0), ruler.at(16, 0, 0.5), ruler.at(0, 16, 0)},
                                 {.constant_factor = 0x1p20F, .slope_factor = 2});
  const TestPlanes planes = render(scene);
  // The greatest depth is 0.5, its exponent -1.
  for (uint32_t x = 0; x < 8; ++x) {
    EXPECT_EQ(planes.depth[x], (static_cast<float>(x) + 0.5F) / 32 + 2.0F / 32 + 0x1p-4F);
  }
}

// The float32 format's resolution is that of the part of the polygon inside of the clip volume.
TEST(DepthBias, GreatestDepthOfAPolygonBeyondTheClipVolume) {
  const TestScene ruler(8, 8);
  const DepthBias bias{.constant_factor = 0x1p19F};
  const auto bias_at_origin = [&](std::initializer_list<ClipPosition> positions, double depth) {
    const TestPlanes planes = render(biased(positions, bias));
    EXPECT_EQ(planes.hits[0], 1U);
    return double{planes.depth[0]} - depth;
  };
  // To z = 4, of which z = 1 is seen.
  EXPECT_NEAR(bias_at_origin({ruler.at(0, 0, 0), ruler.at(64, 0, 4), ruler.at(0, 64, 0)}, 0.5 / 16), 0x1p-4, 1e-7);
  // Behind the eye: z = w / 4 where it is seen.
  EXPECT_NEAR(bias_at_origin({{-1, -1, 0.25F, 1}, {3, -1, 0.25F, 1}, {-1, 3, -0.25F, -1}}, 0.25), 0x1p-6, 1e-7);
}

}  // namespace
}  // namespace fillrule::renderer
