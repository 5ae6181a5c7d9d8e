#include <bit>
#include <limits>

#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kMax = std::numeric_limits<float>::max();

TEST(Robustness, NotFinitePositionsLeaveTheNeighboursUntouched) {
  TestScene clean(32, 32);
  clean.positions = {clean.at(1, 1),  clean.at(30, 2),  clean.at(3, 30),
                     clean.at(30, 2), clean.at(30, 30), clean.at(3, 30)};
  const TestPlanes expected = render(clean);
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (size_t component = 0; component < 4; ++component) {
      TestScene scene = clean;
      ClipPosition position = scene.at(10, 10);
      position[component] = bad;
      const std::vector<ClipPosition> triangle = {position, scene.at(30, 2), scene.at(3, 30)};
      scene.positions.insert(scene.positions.begin() + 3, triangle.begin(), triangle.end());
      const TestPlanes planes = render(scene);
      EXPECT_EQ(planes.hits, expected.hits) << bad << " in " << component;
      EXPECT_EQ(count_of(planes.owner, 1), 0U);
      EXPECT_EQ(count_of(planes.owner, 2), count_of(expected.owner, 1));
    }
  }
}

TEST(Robustness, TheLargestFloats) {
  // x - y > 0 and far beyond everything: half of the target, exactly along its diagonal.
  TestScene scene(32, 32);
  scene.positions = {{-kMax, -kMax, 0.5F, 1}, {kMax, -kMax, 0.5F, 1}, {kMax, kMax, 0.5F, 1}};
  scene.values = {kMax, kMax, kMax};
  scene.state.depth_test = true;
  const TestPlanes planes = render(scene);
  for (uint32_t y = 0; y < 32; ++y) {
    for (uint32_t x = 0; x < 32; ++x) {
      ASSERT_EQ(planes.hits[planes.pixel(x, y)], x >= y ? 1U : 0U) << x << ", " << y;
      if (x >= y) {
        ASSERT_EQ(planes.smooth[planes.pixel(x, y)], kMax);
        ASSERT_EQ(planes.depth[planes.pixel(x, y)], 0.5F);
      }
    }
  }
}

TEST(Robustness, ScalingClipSpaceToDenormalsOrToTheLargestFloatsChangesNothing) {
  TestScene scene(64, 64);
  scene.positions = {{-0.5F, -0.75F, 0.25F, 1}, {1, -0.5F, 1, 2}, {-1, 1, 1, 4}};
  scene.values = {1, 2, 3};
  scene.state.depth_test = true;
  const TestPlanes expected = render(scene);
  for (const int exponent : {-145, -126, -100, 100, 125}) {
    TestScene scaled = scene;
    for (ClipPosition& position : scaled.positions) {
      for (float& component : position) {
        component = std::ldexp(component, exponent);
      }
    }
    const TestPlanes planes = render(scaled);
    EXPECT_EQ(planes.hits, expected.hits) << exponent;
    EXPECT_TRUE(same_bytes(planes.smooth, expected.smooth)) << exponent;
    EXPECT_TRUE(same_bytes(planes.depth, expected.depth)) << exponent;
  }
}

TEST(Robustness, FiniteInputNeverGivesNanOrInfinity) {
  SeededRandom random;
  size_t landed = 0;
  for (int i = 0; i < 4000; ++i) {
    TestScene scene(32, 32);
    scene.state.depth_test = true;
    scene.state.depth_compare = VK_COMPARE_OP_ALWAYS;
    const double spread = random.uniform(0, 120);
    for (int k = 0; k < 6; ++k) {
      ClipPosition position{};
      const double common = random.uniform(-spread, spread);
      for (float& component : position) {
        component = static_cast<float>(random.uniform(-1, 1) * std::exp2(common + random.uniform(-3, 3)));
      }
      if (random.bits() % 2 == 0) {
        position[2] = position[3] / 2;
      }
      scene.positions.push_back(position);
      scene.values.push_back(random.bits() % 2 == 0 ? kMax : static_cast<float>(random.uniform(-1, 1)));
    }
    const TestPlanes planes = render(scene);
    for (size_t pixel = 0; pixel < planes.hits.size(); ++pixel) {
      landed += planes.hits[pixel];
      ASSERT_TRUE(std::isfinite(planes.smooth[pixel]));
      ASSERT_TRUE(std::isfinite(planes.noperspective[pixel]));
      ASSERT_TRUE(planes.depth[pixel] >= 0 && planes.depth[pixel] <= 1);
    }
  }
  EXPECT_GT(landed, 10000U);
}

// Any 32 bits at all as a float, on a few viewports: neither a crash nor an overflow (the sanitizers look on).
TEST(Robustness, AnyBitsAreDrawnOrRefused) {
  SeededRandom random;
  for (int i = 0; i < 4000; ++i) {
    TestScene scene(40, 24);
    scene.state.viewport.x = static_cast<float>(random.uniform(-20000, 10000));
    scene.state.viewport.width = static_cast<float>(std::exp2(random.uniform(-140, 14)));
    scene.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
    for (int k = 0; k < 8; ++k) {
      ClipPosition position{};
      for (float& component : position) {
        component = std::bit_cast<float>(random.bits());
      }
      scene.positions.push_back(position);
    }
    const TestPlanes planes = render(scene);
    for (const uint32_t hits : planes.hits) {
      ASSERT_LE(hits, 6U);
    }
  }
}

TEST(Robustness, AnInfiniteOrNanVaryingLeavesTheOthersExact) {
  TestScene scene(32, 32);
  scene.positions = {scene.at(1, 1, 0.1), scene.at(30, 2, 0.5), scene.at(3, 30, 0.9)};
  scene.state.depth_test = true;
  scene.values = {1, 2, 3};
  const TestPlanes expected = render(scene);
  scene.values = {1, kNan, kInfinity};
  const TestPlanes planes = render(scene);
  EXPECT_EQ(planes.hits, expected.hits);
  EXPECT_TRUE(same_bytes(planes.depth, expected.depth));
  EXPECT_TRUE(same_bytes(planes.flat, expected.flat));
}

}  // namespace
}  // namespace fillrule::renderer
