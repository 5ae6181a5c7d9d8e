// How a scene's camera shows the world: from points to pixels, and the directions of the picture in the world.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cases/model/case.h"
#include "cases/model/scene.h"
#include "harness/scene/assets.h"

namespace fillrule::view {

struct Lens {
  glm::dmat4 to_clip{1};  // from the world
  VkViewport viewport{};
  // The picture's axes in the world, of length 1: to the right, upwards, and out of it towards the viewer.
  glm::dvec3 right{1, 0, 0};
  glm::dvec3 up{0, 1, 0};
  glm::dvec3 back{0, 0, 1};
  bool left_handed = false;

  // Framebuffer coordinates of a point of the world that is not in the plane of the eye.
  [[nodiscard]] glm::dvec2 project(const glm::dvec3& world) const;

  // The step in the world, parallel to the picture, that moves this point by so many pixels on it, y downwards.
  [[nodiscard]] glm::dvec3 step_of(const glm::dvec3& world, const glm::dvec2& pixels) const;
};
Lens lens_of(const Scene& scene);

// A ball around models, in the world.
struct Ball {
  glm::dvec3 centre{0};
  double radius = 1;
};

// Around the box of one model as it is placed, or of all of them.
Result<Ball> ball_around(const Case& scene_case, size_t object, scene::Assets& assets);
Result<Ball> ball_around(const Case& scene_case, scene::Assets& assets);

}  // namespace fillrule::view
