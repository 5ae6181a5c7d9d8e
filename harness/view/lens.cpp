#include "harness/view/lens.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "harness/scene/matrices.h"

namespace fillrule::view {
namespace {

struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  [[nodiscard]] Ball ball() const {
    // A radius that can be divided by, of a single point too.
    return {.centre = (low + high) / 2.0, .radius = std::max(glm::length(high - low) / 2, 1e-6)};
  }
};

Result<void> grow(Box& box, const Case& scene_case, size_t number, scene::Assets& assets) {
  const SceneObject& object = scene_case.scene->objects[number];
  const auto mesh = assets.mesh(scene_case.file, object);
  if (!mesh) return tl::unexpected(mesh.error());
  const glm::dmat4 model = scene::transform_matrix(object.transform);
  for (const mesh::Vertex& vertex : (*mesh)->vertices) {
    const glm::dvec3 world(model * glm::dvec4(glm::dvec3(vertex.position), 1));
    box.low = glm::min(box.low, world);
    box.high = glm::max(box.high, world);
  }
  return {};
}

}  // namespace

glm::dvec2 Lens::project(const glm::dvec3& world) const {
  const glm::dvec4 clip = to_clip * glm::dvec4(world, 1);
  return {viewport.x + (clip.x / clip.w + 1) / 2 * double{viewport.width},
          viewport.y + (clip.y / clip.w + 1) / 2 * double{viewport.height}};
}

glm::dvec3 Lens::step_of(const glm::dvec3& world, const glm::dvec2& pixels) const {
  // Parallel to the picture w stays the same, so that pixels are linear in the step.
  const glm::dvec2 from = project(world);
  const glm::dvec2 of_right = project(world + right) - from;
  const glm::dvec2 of_up = project(world + up) - from;
  const glm::dvec2 steps = glm::inverse(glm::dmat2(of_right, of_up)) * pixels;
  return right * steps.x + up * steps.y;
}

Lens lens_of(const Scene& scene) {
  const glm::dmat4 view = scene::view_matrix(scene.camera);
  const bool left_handed = scene.camera.handedness == Handedness::kLeft;
  // The rows of the view are the eye's axes in the world.
  const glm::dmat4 axes = glm::transpose(view);
  const double towards_viewer = left_handed ? -1 : 1;
  return {.to_clip = scene::projection_matrix(scene) * view,
          .viewport = scene.state.viewport,
          .right = glm::normalize(glm::dvec3(axes[0])),
          .up = glm::normalize(glm::dvec3(axes[1])),
          .back = towards_viewer * glm::normalize(glm::dvec3(axes[2])),
          .left_handed = left_handed};
}

Result<Ball> ball_around(const Case& scene_case, size_t object, scene::Assets& assets) {
  Box box;
  if (auto grown = grow(box, scene_case, object, assets); !grown) return tl::unexpected(grown.error());
  return box.ball();
}

Result<Ball> ball_around(const Case& scene_case, scene::Assets& assets) {
  Box box;
  for (size_t object = 0; object < scene_case.scene->objects.size(); ++object) {
    if (auto grown = grow(box, scene_case, object, assets); !grown) return tl::unexpected(grown.error());
  }
  return box.ball();
}

}  // namespace fillrule::view
