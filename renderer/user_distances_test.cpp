// The user's clip and cull distances.
#include <gmock/gmock.h>

#include <limits>

#include "renderer/clip.h"
#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

// Two triangles over the target; its right side may be farther away.
TestScene quad(double w_right = 1) {
  TestScene scene(32, 32);
  scene.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  scene.positions = {scene.at(0, 0), scene.at(32, 0, 0.5, w_right), scene.at(0, 32), scene.at(32, 32, 0.5, w_right)};
  return scene;
}

TEST(ClipDistances, KeepWhereAllAreNotNegative) {
  TestScene scene = quad();
  // x >= 10 and y <= 20, in pixels.
  scene.clip_distances = {-10, 20, 22, 20, -10, -12, 22, -12};
  const TestPlanes planes = render(scene);
  for (uint32_t y = 0; y < 32; ++y) {
    for (uint32_t x = 0; x < 32; ++x) {
      ASSERT_EQ(planes.hits[planes.pixel(x, y)], x >= 10 && y < 20 ? 1U : 0U) << x << ", " << y;
    }
  }
}

// Linear in clip space: with w from 1 to 3 the distance -1 to 1 is zero where 1/w-weighted halves meet, at 3/4.
TEST(ClipDistances, ArePerspectiveCorrect) {
  TestScene scene = quad(3);
  scene.clip_distances = {-1, 1, -1, 1};
  const TestPlanes planes = render(scene);
  for (uint32_t x = 0; x < 32; ++x) {
    ASSERT_EQ(planes.hits[planes.pixel(x, 7)], x >= 24 ? 1U : 0U) << x;
  }
}

TEST(ClipDistances, ValuesAreThoseOfTheWholeTriangle) {
  TestScene scene = quad(3);
  scene.values = {0, 5, 1, 7};
  const TestPlanes whole = render(scene);
  scene.clip_distances = {-1, 2, 1, 0.5F};
  const TestPlanes part = render(scene);
  size_t kept = 0;
  for (size_t pixel = 0; pixel < part.hits.size(); ++pixel) {
    if (part.hits[pixel] != 0) {
      ++kept;
      ASSERT_NEAR(part.smooth[pixel], whole.smooth[pixel], 1e-6);
      ASSERT_NEAR(part.noperspective[pixel], whole.noperspective[pixel], 1e-6);
    }
  }
  EXPECT_GT(kept, 100U);
  EXPECT_LT(kept, 900U);
}

// A fan around the middle, everything cut eight times: the half-space and its complement share no sample and miss
// none; nor do neighbours.
TEST(ClipDistances, AreWatertight) {
  SeededRandom random;
  for (int repeat = 0; repeat < 200; ++repeat) {
    TestScene scene(64, 64);
    scene.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN;
    scene.positions.push_back(scene.at(random.uniform(10, 50), random.uniform(10, 50), 0.5, random.uniform(0.5, 4)));
    for (const auto& [x, y] : {std::pair{-9, -9}, {80, -9}, {80, 80}, {-9, 80}, {-9, -9}}) {
      scene.positions.push_back(scene.at(x, y, 0.5, 2));
    }
    std::vector<float> distances;
    for (size_t i = 0; i < 5; ++i) {
      distances.push_back(static_cast<float>(random.uniform(-1, 1)));
    }
    distances.push_back(distances[1]);  // the same vertex
    std::vector<uint32_t> sum(size_t{64} * 64);
    for (const float sign : {1.0F, -1.0F}) {
      scene.clip_distances.clear();
      for (const float distance : distances) {
        scene.clip_distances.push_back(sign * distance);
      }
      const TestPlanes planes = render(scene);
      for (size_t pixel = 0; pixel < sum.size(); ++pixel) {
        sum[pixel] += planes.hits[pixel];
      }
    }
    ASSERT_EQ(sum, std::vector<uint32_t>(sum.size(), 1));
  }
}

TEST(ClipDistances, EightOfThemAndTheClipVolumeKeepToTheirPolygon) {
  SeededRandom random;
  const WindowTransform transform({.width = 200, .height = 200, .maxDepth = 1}, 8);
  uint32_t most = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<ClipPosition, 3> positions;
    std::array<WindowVertex, 3> vertices;
    std::array<std::array<float, 8>, 3> distances;
    for (size_t k = 0; k < 3; ++k) {
      const double scale = std::exp2(random.uniform(0, 25));
      positions[k] = {static_cast<float>(random.uniform(-scale, scale)),
                      static_cast<float>(random.uniform(-scale, scale)), static_cast<float>(random.uniform(-0.5, 2)),
                      static_cast<float>(random.uniform(-0.5, 2))};
      for (float& distance : distances[k]) {
        distance = static_cast<float>(random.uniform(-0.3, 1));
      }
      vertices[k] = transform.window_vertex(positions[k]);
      add_user_distances(distances[k], {}, vertices[k]);
    }
    const FixedPolygon polygon =
        clip_triangle(transform, positions, vertices, {distances[0], distances[1], distances[2]});
    most = std::max(most, polygon.count);
    for (const FixedPosition& vertex : polygon.span()) {
      ASSERT_LE(std::abs(vertex.x_fixed), 1 << 29);
      ASSERT_LE(std::abs(vertex.y_fixed), 1 << 29);
    }
  }
  EXPECT_GT(most, 6U);
}

// A regular polygon of 14 sides out of a triangle: no piece of the outline is lost.
TEST(ClipDistances, APolygonOfManySidesIsCoveredWhole) {
  TestScene scene(64, 64);
  const std::array<std::array<double, 2>, 3> corners{{{-100, -60}, {164, -60}, {32, 200}}};
  for (const auto& [x, y] : corners) {
    scene.positions.push_back(scene.at(x, y));
    for (int side = 0; side < 8; ++side) {
      const double angle = side * 0.7853981633974483 + 0.1;
      const double distance = 20 - (std::cos(angle) * (x - 32) + std::sin(angle) * (y - 32));
      scene.clip_distances.push_back(static_cast<float>(distance));
    }
  }
  const TestPlanes planes = render(scene);
  for (uint32_t y = 0; y < 64; ++y) {
    for (uint32_t x = 0; x < 64; ++x) {
      double least = 1000;
      for (int side = 0; side < 8; ++side) {
        const double angle = side * 0.7853981633974483 + 0.1;
        least = std::min(least, 20 - (std::cos(angle) * (x + 0.5 - 32) + std::sin(angle) * (y + 0.5 - 32)));
      }
      if (std::abs(least) > 0.01) {
        ASSERT_EQ(planes.hits[planes.pixel(x, y)], least > 0 ? 1U : 0U) << x << ", " << y;
      }
    }
  }
}

TEST(ClipDistances, OneThatIsNotFiniteDropsItsTriangleAlone) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    TestScene scene = quad();
    scene.clip_distances = {bad, 1, 1, 1};
    const TestPlanes planes = render(scene);
    EXPECT_EQ(count_of(planes.owner, 0), 0U);
    EXPECT_GT(count_of(planes.owner, 1), 400U);
  }
}

TEST(CullDistances, DropATriangleIfOneIsNegativeAtAllVertices) {
  TestScene scene = quad();
  const auto owners = [&](std::vector<float> distances) {
    scene.cull_distances = std::move(distances);
    const TestPlanes planes = render(scene);
    return std::pair(count_of(planes.owner, 0) > 0, count_of(planes.owner, 1) > 0);
  };
  EXPECT_EQ(owners({-1, -1, -1, 1}), std::pair(false, true));
  EXPECT_EQ(owners({1, -1, -1, -1}), std::pair(true, false));
  EXPECT_EQ(owners({-1, 0, -1, -1}), std::pair(true, true));
  // No distance is negative at all three vertices, though each vertex has a negative one.
  EXPECT_EQ(owners({-1, 1, -1, 1, 1, -1, 1, -1}), std::pair(true, true));
  EXPECT_EQ(owners({1, -1, 1, -1, 1, -1, 1, 1}), std::pair(false, true));
}

TEST(UserDistances, AreRefusedIfTooManyOrTooFew) {
  const auto error_of = [](const TestScene& scene) {
    TestPlanes planes = cleared_planes(scene);
    const Result<void> drawn = render_into(scene, planes);
    return drawn ? std::string() : drawn.error().what;
  };
  TestScene scene = quad();
  scene.clip_distances.assign(size_t{4} * 5, 1);
  scene.cull_distances.assign(size_t{4} * 4, 1);
  EXPECT_THAT(error_of(scene), ::testing::HasSubstr("9 clip and cull distances"));
  scene.cull_distances.assign(6, 1);
  EXPECT_THAT(error_of(scene), ::testing::HasSubstr("6 values of 1 distances for 4 vertices"));
}

}  // namespace
}  // namespace fillrule::renderer
