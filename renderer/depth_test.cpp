#include "renderer/depth.h"

#include <array>
#include <limits>

#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

TEST(DepthPasses, AllEightOperations) {
  struct Row {
    VkCompareOp op;
    bool less;
    bool equal;
    bool greater;
  };
  constexpr std::array<Row, 8> kTable{{
      {VK_COMPARE_OP_NEVER, false, false, false},
      {VK_COMPARE_OP_LESS, true, false, false},
      {VK_COMPARE_OP_EQUAL, false, true, false},
      {VK_COMPARE_OP_LESS_OR_EQUAL, true, true, false},
      {VK_COMPARE_OP_GREATER, false, false, true},
      {VK_COMPARE_OP_NOT_EQUAL, true, false, true},
      {VK_COMPARE_OP_GREATER_OR_EQUAL, false, true, true},
      {VK_COMPARE_OP_ALWAYS, true, true, true},
  }};
  const float half = 0.5F;
  for (const Row& row : kTable) {
    EXPECT_EQ(depth_passes(row.op, std::nextafter(half, 0.0F), half), row.less) << row.op;
    EXPECT_EQ(depth_passes(row.op, half, half), row.equal) << row.op;
    EXPECT_EQ(depth_passes(row.op, std::nextafter(half, 1.0F), half), row.greater) << row.op;
  }
}

float attachment_depth(const RasterState& state, double depth, VkFormat format = VK_FORMAT_D32_SFLOAT) {
  return DepthStage(state, {.values = {}, .format = format}).attachment_depth(depth);
}

TEST(AttachmentDepth, IsClampedAndNeverNegativeZero) {
  RasterState state;
  state.viewport = {.minDepth = 0.75F, .maxDepth = 0.25F};
  EXPECT_EQ(attachment_depth(state, -0.25), 0.0F);
  EXPECT_FALSE(std::signbit(attachment_depth(state, -0.0)));
  EXPECT_EQ(attachment_depth(state, 1.25), 1.0F);
  EXPECT_EQ(attachment_depth(state, 0.1), 0.1F);
  state.depth_clamp = true;  // to the viewport's range, whichever end is the greater
  EXPECT_EQ(attachment_depth(state, 0.1), 0.25F);
  EXPECT_EQ(attachment_depth(state, 0.9), 0.75F);
  EXPECT_EQ(attachment_depth(state, 0.6), 0.6F);
}

TEST(AttachmentDepth, FixedPointRoundsTheFloat32ProductToEven) {
  const RasterState state;
  const auto code16 = [&](double depth) {
    return std::lround(double{attachment_depth(state, depth, VK_FORMAT_D16_UNORM)} * 65535);
  };
  EXPECT_EQ(code16(0), 0);
  EXPECT_EQ(code16(1), 65535);
  EXPECT_EQ(code16(0.5), 32768);  // 32767.5: a tie
  EXPECT_EQ(code16(0x1.000002p-17), 0);
  EXPECT_EQ(code16(0.6 / 65535), 1);
  EXPECT_EQ(code16(0.3), 19660);  // 19660.5008 exactly; in float32 a tie
  EXPECT_EQ(attachment_depth(state, 0.75, VK_FORMAT_X8_D24_UNORM_PACK32), static_cast<float>(12582911 / 16777215.0));
}

// So that comparing the floats is comparing the codes.
TEST(AttachmentDepth, DifferentCodesOf24BitsHaveDifferentFloats) {
  float previous = -1;
  for (uint32_t code = 0; code < 1U << 24U; ++code) {
    const auto depth = static_cast<float>(code / 16777215.0);
    ASSERT_GT(depth, previous) << code;
    previous = depth;
  }
}

constexpr size_t kQuadPixels = size_t{32} * 32;

TestScene full_quad(double z_ndc) {
  TestScene scene(32, 32);
  scene.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  scene.positions = {scene.at(0, 0, z_ndc), scene.at(32, 0, z_ndc), scene.at(0, 32, z_ndc), scene.at(32, 32, z_ndc)};
  scene.state.depth_test = true;
  return scene;
}

TEST(DepthTest, AConstantDepthIsExactAtEveryPixel) {
  for (const float z : {0.0F, 0.1F, 0.3F, 1.0F / 3.0F, 0.7F, 1.0F}) {
    TestScene scene = full_quad(z);
    scene.state.depth_compare = VK_COMPARE_OP_ALWAYS;
    EXPECT_EQ(render(scene).depth, std::vector<float>(kQuadPixels, z));
  }
}

TEST(DepthTest, FailingFragmentsLeaveNoTrace) {
  TestScene scene = full_quad(0.5);
  scene.clear_depth = 0.5F;
  scene.state.depth_compare = VK_COMPARE_OP_LESS;
  const TestPlanes planes = render(scene);
  EXPECT_EQ(count_of(planes.hits, 0), kQuadPixels);
  EXPECT_EQ(planes.depth, std::vector<float>(kQuadPixels, 0.5F));
  scene.state.depth_compare = VK_COMPARE_OP_EQUAL;
  EXPECT_EQ(count_of(render(scene).hits, 1), kQuadPixels);
}

TEST(DepthTest, WriteOffAndTestOffLeaveTheDepthAsItWas) {
  TestScene scene = full_quad(0.25);
  scene.state.depth_write = false;
  TestPlanes planes = render(scene);
  EXPECT_EQ(count_of(planes.hits, 1), kQuadPixels);
  EXPECT_EQ(planes.depth, std::vector<float>(kQuadPixels, 1.0F));
  scene.state.depth_write = true;
  scene.state.depth_test = false;
  scene.state.depth_compare = VK_COMPARE_OP_NEVER;
  planes = render(scene);
  EXPECT_EQ(count_of(planes.hits, 1), kQuadPixels);
  EXPECT_EQ(planes.depth, std::vector<float>(kQuadPixels, 1.0F));
}

TEST(DepthTest, PassesWithoutADepthBuffer) {
  TestScene scene = full_quad(0.25);
  scene.state.depth_compare = VK_COMPARE_OP_NEVER;
  TestPlanes planes = cleared_planes(scene);
  planes.depth.clear();
  ASSERT_TRUE(render_into(scene, planes));
  EXPECT_EQ(count_of(planes.hits, 1), kQuadPixels);
}

TEST(DepthTest, DepthRangeOfTheViewport) {
  TestScene scene(4, 4);
  scene.state.depth_test = true;
  scene.state.depth_compare = VK_COMPARE_OP_ALWAYS;
  scene.positions = {scene.at(0, 0, 0), scene.at(8, 0, 1), scene.at(0, 8, 0)};  // z = x / 8
  scene.state.viewport.minDepth = 0.25F;
  scene.state.viewport.maxDepth = 0.75F;
  EXPECT_EQ(render(scene).depth[0], 0.25F + 0.5F / 16);
  EXPECT_EQ(render(scene).depth[3], 0.25F + 0.5F * 7 / 16);
  scene.state.viewport.minDepth = 1;  // reversed
  scene.state.viewport.maxDepth = 0;
  EXPECT_EQ(render(scene).depth[0], 1 - 1.0F / 16);
  EXPECT_EQ(render(scene).depth[3], 1 - 7.0F / 16);
  scene.positions = {scene.at(0, 0, 0), scene.at(8, 0, 0), scene.at(0, 8, 1)};  // z = y / 8
  EXPECT_EQ(render(scene).depth[12], 1 - 7.0F / 16);
}

// z from -1 to 2 (of -1 to 1: from -2 to 2) over 12 pixels.
TEST(DepthVolume, ClippedClampedOrNeither) {
  TestScene scene(12, 4);
  scene.state.depth_test = true;
  scene.state.depth_compare = VK_COMPARE_OP_ALWAYS;
  scene.clear_depth = 0.125F;
  scene.state.viewport.minDepth = 0.75F;  // reversed
  scene.state.viewport.maxDepth = 0.5F;
  scene.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  for (const bool negative_one_to_one : {false, true}) {
    const double low = negative_one_to_one ? -2 : -1;
    scene.positions = {scene.at(0, 0, low), scene.at(12, 0, 2), scene.at(0, 4, low), scene.at(12, 4, 2)};
    scene.state.negative_one_to_one = negative_one_to_one;
    for (const bool clip : {false, true}) {
      for (const bool clamp : {false, true}) {
        scene.state.depth_clip = clip;
        scene.state.depth_clamp = clamp;
        const TestPlanes planes = render(scene);
        for (uint32_t x = 0; x < 12; ++x) {
          const double z_ndc = low + (2 - low) * (x + 0.5) / 12;
          const double of_range = negative_one_to_one ? (z_ndc + 1) / 2 : z_ndc;
          double depth = 0.75 - 0.25 * of_range;
          if (clamp) {
            depth = std::clamp(depth, 0.5, 0.75);
          }
          const bool is_clipped = clip && (of_range < 0 || of_range > 1);
          ASSERT_EQ(planes.hits[planes.pixel(x, 1)], is_clipped ? 0U : 1U) << x;
          ASSERT_NEAR(planes.depth[planes.pixel(x, 1)], is_clipped ? 0.125 : depth, 1e-7) << x;
        }
      }
    }
  }
}

// Beyond [0, 1], without clamping to the viewport's range.
TEST(DepthVolume, WithoutClipAndClampDepthsAreStoredWithinZeroToOne) {
  TestScene scene = full_quad(-3);
  scene.state.depth_clip = false;
  EXPECT_EQ(render(scene).depth, std::vector<float>(kQuadPixels, 0.0F));
  scene.positions = full_quad(3).positions;
  scene.state.depth_compare = VK_COMPARE_OP_ALWAYS;
  EXPECT_EQ(render(scene).depth, std::vector<float>(kQuadPixels, 1.0F));
}

TEST(DepthTest, TheNearestOfManyWins) {
  TestScene scene(16, 16);
  scene.state.depth_test = true;
  scene.state.depth_compare = VK_COMPARE_OP_LESS;
  for (const double z : {0.9, 0.4, 0.6, 0.4, 0.8}) {
    for (const auto& [x, y] : {std::pair{0, 0}, {40, 0}, {0, 40}}) {
      scene.positions.push_back(scene.at(x, y, z));
    }
  }
  const TestPlanes planes = render(scene);
  EXPECT_EQ(planes.owner, std::vector<uint32_t>(256, 1));
  EXPECT_EQ(planes.hits, std::vector<uint32_t>(256, 2));
  EXPECT_EQ(planes.depth, std::vector<float>(256, 0.4F));
}

// Two depths that are one code: the second is equal, not less.
TEST(DepthTest, ComparesAfterQuantizing) {
  TestScene scene = full_quad(0.5000001);
  scene.depth_format = VK_FORMAT_D16_UNORM;
  TestPlanes planes = render(scene);
  for (ClipPosition& position : scene.positions) {
    position[2] = 0.5F;
  }
  scene.state.depth_compare = VK_COMPARE_OP_LESS;
  ASSERT_TRUE(render_into(scene, planes));
  EXPECT_EQ(count_of(planes.hits, 1), kQuadPixels);
  scene.state.depth_compare = VK_COMPARE_OP_EQUAL;
  ASSERT_TRUE(render_into(scene, planes));
  EXPECT_EQ(count_of(planes.hits, 2), kQuadPixels);
}

TEST(DepthBoundsTest, IsAboutTheStoredDepthEndsIncluded) {
  for (const bool depth_test : {false, true}) {
    TestScene scene = full_quad(0.25);
    scene.state.depth_test = depth_test;
    scene.clear_depth = 0.5F;
    const auto lands = [&](float min, float max) {
      scene.state.depth_bounds = DepthBounds{min, max};
      return count_of(render(scene).hits, 1) == kQuadPixels;
    };
    EXPECT_TRUE(lands(0.5F, 0.75F));
    EXPECT_TRUE(lands(0.375F, 0.5F));
    EXPECT_FALSE(lands(0.125F, 0.375F));
    EXPECT_FALSE(lands(0.625F, 0.75F));
    TestPlanes planes = cleared_planes(scene);
    planes.depth.clear();
    ASSERT_TRUE(render_into(scene, planes));
    EXPECT_EQ(count_of(planes.hits, 1), kQuadPixels) << "without a depth buffer the test passes";
  }
}

}  // namespace
}  // namespace fillrule::renderer
