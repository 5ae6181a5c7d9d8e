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

TEST(DepthD32, IsClampedAndNeverNegativeZero) {
  EXPECT_EQ(depth_d32(-0.25), 0.0F);
  EXPECT_FALSE(std::signbit(depth_d32(-0.0)));
  EXPECT_EQ(depth_d32(1.25), 1.0F);
  EXPECT_EQ(depth_d32(0.1), 0.1F);
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

}  // namespace
}  // namespace fillrule::renderer
