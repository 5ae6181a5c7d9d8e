#include "renderer/clip.h"

#include <gmock/gmock.h>

#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

using Triangle = std::array<ClipPosition, 3>;
using ::testing::ElementsAre;

// 200 x 200 px around (100, 100), 8 subpixel bits.
WindowTransform test_transform() {
  return WindowTransform({.width = 200, .height = 200, .maxDepth = 1}, 8);
}

std::vector<FixedPosition> clipped(const Triangle& triangle) {
  const WindowTransform transform = test_transform();
  const FixedPolygon polygon =
      clip_triangle(transform, triangle,
                    {transform.window_vertex(triangle[0]), transform.window_vertex(triangle[1]),
                     transform.window_vertex(triangle[2])});
  return {polygon.span().begin(), polygon.span().end()};
}

FixedPosition at_pixel(int32_t x, int32_t y) {
  return {x * 256, y * 256};
}

TEST(ClipTriangle, LeavesAVisibleOneAsItIs) {
  EXPECT_THAT(clipped({{{0, 0, 0, 1}, {1, 0, 1, 1}, {0, 1, 0.5F, 1}}}),
              ElementsAre(at_pixel(100, 100), at_pixel(200, 100), at_pixel(100, 200)));
}

TEST(ClipTriangle, NearPlaneCutsOffOneVertex) {
  EXPECT_THAT(clipped({{{0, 0, -1, 1}, {1, 0, 1, 1}, {0, 1, 1, 1}}}),
              ElementsAre(at_pixel(150, 100), at_pixel(200, 100), at_pixel(100, 200), at_pixel(100, 150)));
}

TEST(ClipTriangle, FarPlaneCutsOffTwoVertices) {
  EXPECT_THAT(clipped({{{0, 0, 0, 1}, {1, 0, 2, 1}, {0, 1, 2, 1}}}),
              ElementsAre(at_pixel(100, 100), at_pixel(150, 100), at_pixel(100, 150)));
}

TEST(ClipTriangle, VertexBehindTheEye) {
  // z = w/2: the near plane is w = 0, and what comes near it leaves the guard band.
  const std::vector<FixedPosition> polygon = clipped({{{0, 0, 0.5F, 1}, {1, 0, -0.5F, -1}, {0, 0.5F, 0.5F, 1}}});
  ASSERT_EQ(polygon.size(), 4U);
  EXPECT_EQ(polygon[0], at_pixel(100, 100));
  // The edges go on to the right, away from the projection of (1, 0), as far as the guard band: there the upper one
  // still has y = 0, the lower one y = x / 2 + 1/2.
  EXPECT_GT(polygon[1].x_fixed, (1 << 29) - 256);
  EXPECT_EQ(polygon[1].y_fixed, 100 * 256);
  EXPECT_EQ(polygon[2].x_fixed, polygon[1].x_fixed);
  EXPECT_NEAR(polygon[2].y_fixed, 0.5 * polygon[2].x_fixed + 100 * 256, 1);
  EXPECT_EQ(polygon[3], at_pixel(100, 150));
}

TEST(ClipTriangle, NothingIsLeft) {
  EXPECT_THAT(clipped({{{0, 0, -1, 1}, {1, 0, -1, 1}, {0, 1, -0.5F, 1}}}), ElementsAre());
  EXPECT_THAT(clipped({{{0, 0, 0, -1}, {1, 0, 0, -1}, {0, 1, 0, -1}}}), ElementsAre());
  EXPECT_THAT(clipped({{{0, 0, 0, 0}, {1, 0, 0.5F, 1}, {0, 1, 0.5F, 1}}}), ElementsAre());
}

TEST(ClipTriangle, NeverLeavesTheGuardBand) {
  SeededRandom random;
  for (int i = 0; i < 20000; ++i) {
    Triangle triangle;
    for (ClipPosition& position : triangle) {
      for (float& component : position) {
        component = static_cast<float>(random.uniform(-1, 1) * std::exp2(random.uniform(-140, 127)));
      }
    }
    for (const FixedPosition& vertex : clipped(triangle)) {
      ASSERT_LE(std::abs(vertex.x_fixed), 1 << 29);
      ASSERT_LE(std::abs(vertex.y_fixed), 1 << 29);
    }
  }
}

// What is left of a shared edge is the same from both of its sides, to the bit.
TEST(ClipTriangle, BothSidesOfAnEdgeGetTheSamePoints) {
  SeededRandom random;
  const auto random_position = [&] {
    const double scale = std::exp2(random.uniform(-3, 25));
    return ClipPosition{static_cast<float>(random.uniform(-scale, scale)),
                        static_cast<float>(random.uniform(-scale, scale)), static_cast<float>(random.uniform(-1, 2)),
                        static_cast<float>(random.uniform(-1, 2))};
  };
  size_t edges_left = 0;
  for (int i = 0; i < 20000; ++i) {
    const ClipPosition a = random_position();
    const ClipPosition b = random_position();
    // The edge a-b with itself as a third vertex is a polygon of the edge's points alone, there and back.
    const std::vector<FixedPosition> there = clipped({{a, b, b}});
    const std::vector<FixedPosition> back = clipped({{b, a, a}});
    for (const FixedPosition& vertex : there) {
      ASSERT_THAT(back, ::testing::Contains(vertex));
    }
    // A triangle on the edge has them too.
    const std::vector<FixedPosition> triangle = clipped({{a, b, random_position()}});
    if (!triangle.empty()) {
      edges_left += there.size() / 3;
      for (const FixedPosition& vertex : there) {
        ASSERT_THAT(triangle, ::testing::Contains(vertex));
      }
    }
  }
  EXPECT_GT(edges_left, 1000U);
}

}  // namespace
}  // namespace fillrule::renderer
