#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

// Counter-clockwise as Vulkan has it: a = -1/2 * sum of (x_i * y_i+1 - x_i+1 * y_i) > 0, y down.
TestScene triangle(bool is_counter_clockwise) {
  TestScene scene(16, 16);
  scene.positions = {scene.at(2, 2), scene.at(2, 12), scene.at(12, 2)};
  if (!is_counter_clockwise) {
    std::swap(scene.positions[1], scene.positions[2]);
  }
  return scene;
}

TEST(Culling, TableOfWindingFrontFaceAndMode) {
  for (const bool is_counter_clockwise : {false, true}) {
    for (const VkFrontFace front_face : {VK_FRONT_FACE_COUNTER_CLOCKWISE, VK_FRONT_FACE_CLOCKWISE}) {
      const bool is_front = is_counter_clockwise == (front_face == VK_FRONT_FACE_COUNTER_CLOCKWISE);
      for (const VkCullModeFlags mode :
           {VkCullModeFlags{VK_CULL_MODE_NONE}, VkCullModeFlags{VK_CULL_MODE_FRONT_BIT},
            VkCullModeFlags{VK_CULL_MODE_BACK_BIT}, VkCullModeFlags{VK_CULL_MODE_FRONT_AND_BACK}}) {
        TestScene scene = triangle(is_counter_clockwise);
        scene.state.front_face = front_face;
        scene.state.cull_mode = mode;
        const bool is_culled = (mode & (is_front ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_BACK_BIT)) != 0;
        const TestPlanes planes = render(scene);
        EXPECT_EQ(planes.hits[planes.pixel(4, 4)], is_culled ? 0U : 1U) << mode;
        EXPECT_EQ(planes.front_facing[planes.pixel(4, 4)], !is_culled && is_front ? 1U : 0U) << mode;
      }
    }
  }
}

TEST(Culling, NegativeViewportHeightTurnsTheFacingRound) {
  TestScene scene = triangle(true);
  scene.state.viewport.y = 16;
  scene.state.viewport.height = -16;
  const TestPlanes planes = render(scene);
  EXPECT_EQ(planes.hits[planes.pixel(4, 11)], 1U);
  EXPECT_EQ(planes.front_facing[planes.pixel(4, 11)], 0U);
}

TEST(Culling, ATriangleWithoutAreaCoversNothing) {
  TestScene scene(16, 16);
  scene.positions = {scene.at(0.5, 0.5), scene.at(4.5, 4.5), scene.at(8.5, 8.5), scene.at(3.5, 3.5),
                     scene.at(3.5, 3.5), scene.at(9, 3),
                     // Above half a subpixel from a line, yet on it after the snap.
                     scene.at(2.5, 6.5), scene.at(12.5, 6.5), scene.at(7.5, 6.5 + 1.0 / 1024)};
  EXPECT_EQ(count_of(render(scene).hits, 0), 256U);
}

// Which of the vertices is behind the eye does not change what is seen from which side.
TEST(Culling, FacingOfATriangleWithAVertexBehindTheEye) {
  for (size_t rotation = 0; rotation < 3; ++rotation) {
    for (const bool is_reversed : {false, true}) {
      TestScene scene(32, 32);
      std::vector<ClipPosition> vertices = {{-1, -1, 0.5F, 1}, {1, -1, 0.5F, 1}, {0, 5, -0.5F, -1}};
      std::rotate(vertices.begin(), vertices.begin() + static_cast<ptrdiff_t>(rotation), vertices.end());
      if (is_reversed) {
        std::reverse(vertices.begin(), vertices.end());
      }
      scene.positions = vertices;
      const TestPlanes planes = render(scene);
      // Seen: from (-1, -1) and (1, -1) down without end.
      EXPECT_EQ(planes.hits[planes.pixel(16, 30)], 1U);
      EXPECT_EQ(planes.front_facing[planes.pixel(16, 30)], is_reversed ? 1U : 0U);
    }
  }
}

}  // namespace
}  // namespace fillrule::renderer
