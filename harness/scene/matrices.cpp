#include "harness/scene/matrices.h"

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace fillrule::scene {
namespace {

struct Sides {
  double left, right, bottom, top;
};

glm::dmat4 step_matrix(const TransformStep& step) {
  const glm::dmat4 identity(1);
  if (const auto* const translate = std::get_if<Translate>(&step)) {
    return glm::translate(identity, vector_of(translate->by));
  }
  if (const auto* const scale = std::get_if<Scale>(&step)) return glm::scale(identity, vector_of(scale->by));
  const auto& rotate = std::get<Rotate>(step);
  return glm::rotate(identity, glm::radians(rotate.degrees), vector_of(rotate.axis));
}

double aspect_of(const PerspectiveProjection& perspective, const VkViewport& viewport) {
  return perspective.aspect.value_or(double{viewport.width} / std::abs(double{viewport.height}));
}

// GLM 0.9.9's left-handed one moves a frustum that is not symmetric to the wrong side, so z is turned over instead.
glm::dmat4 frustum(const Sides& s, double near, double far, bool left_handed, bool negative_one_to_one) {
  const glm::dmat4 right_handed = negative_one_to_one
                                      ? glm::frustumRH_NO(s.left, s.right, s.bottom, s.top, near, far)
                                      : glm::frustumRH_ZO(s.left, s.right, s.bottom, s.top, near, far);
  return left_handed ? glm::scale(right_handed, {1, 1, -1}) : right_handed;
}

glm::dmat4 orthographic(const Sides& s, double near, double far, bool left_handed, bool negative_one_to_one) {
  if (left_handed) {
    return negative_one_to_one ? glm::orthoLH_NO(s.left, s.right, s.bottom, s.top, near, far)
                               : glm::orthoLH_ZO(s.left, s.right, s.bottom, s.top, near, far);
  }
  return negative_one_to_one ? glm::orthoRH_NO(s.left, s.right, s.bottom, s.top, near, far)
                             : glm::orthoRH_ZO(s.left, s.right, s.bottom, s.top, near, far);
}

}  // namespace

glm::dvec3 vector_of(const Vector3& vector) {
  return {vector[0], vector[1], vector[2]};
}

glm::dmat4 transform_matrix(const Transform& transform) {
  glm::dmat4 matrix(1);
  for (const TransformStep& step : transform) matrix = step_matrix(step) * matrix;
  return matrix;
}

glm::dmat4 view_matrix(const Camera& camera) {
  if (const auto* const transform = std::get_if<Transform>(&camera.placement)) {
    return glm::inverse(transform_matrix(*transform));
  }
  const auto& look = std::get<LookAt>(camera.placement);
  const glm::dvec3 eye = vector_of(look.eye);
  const glm::dvec3 target = vector_of(look.target);
  const glm::dvec3 up = vector_of(look.up);
  return camera.handedness == Handedness::kLeft ? glm::lookAtLH(eye, target, up) : glm::lookAtRH(eye, target, up);
}

glm::dmat4 projection_matrix(const Scene& scene) {
  const auto& [shape, near, far] = scene.projection;
  const bool left_handed = scene.camera.handedness == Handedness::kLeft;
  const bool negative_one_to_one = scene.state.negative_one_to_one;
  glm::dmat4 matrix;
  if (const auto* const perspective = std::get_if<PerspectiveProjection>(&shape)) {
    const double top = near * std::tan(glm::radians(perspective->fov_y) / 2);
    const double right = top * aspect_of(*perspective, scene.state.viewport);
    matrix = frustum({-right, right, -top, top}, near, far, left_handed, negative_one_to_one);
  } else if (const auto* const sides = std::get_if<FrustumProjection>(&shape)) {
    matrix =
        frustum({sides->left, sides->right, sides->bottom, sides->top}, near, far, left_handed, negative_one_to_one);
  } else {
    const auto& box = std::get<OrthographicProjection>(shape);
    matrix = orthographic({box.left, box.right, box.bottom, box.top}, near, far, left_handed, negative_one_to_one);
  }
  const double y = scene.state.viewport.height < 0 ? 1 : -1;
  return glm::scale(glm::dmat4(1), {1, y, 1}) * matrix;
}

glm::dvec4 eye_of(const Scene& scene) {
  const glm::dmat4 to_world = glm::inverse(view_matrix(scene.camera));
  if (!std::holds_alternative<OrthographicProjection>(scene.projection.shape)) return to_world[3];
  const double towards = scene.camera.handedness == Handedness::kLeft ? -1 : 1;
  return {glm::normalize(glm::dvec3(to_world[2])) * towards, 0};
}

}  // namespace fillrule::scene
