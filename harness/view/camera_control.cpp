#include "harness/view/camera_control.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "harness/scene/matrices.h"

namespace fillrule::view {
namespace {

constexpr double kStepOfWheel = 0.9;  // of the distance
constexpr double kRoom = 1.05;        // round a ball that is framed
constexpr double kFieldOfView = 45;   // degrees, of a scene that has none

glm::dmat3 rotation(double radians, const glm::dvec3& axis) {
  const glm::dmat3 matrix(glm::rotate(glm::dmat4(1), radians, axis));
  return matrix;
}

Vector3 array_of(const glm::dvec3& vector) {
  return {vector.x, vector.y, vector.z};
}

bool is_orthographic(const decltype(Projection::shape)& shape) {
  return std::holds_alternative<OrthographicProjection>(shape);
}

}  // namespace

CameraControl::CameraControl(const Scene& scene, const Ball& ball)
    : file_camera_(scene.camera),
      file_projection_(scene.projection),
      ball_(ball),
      handed_(scene.camera.handedness == Handedness::kLeft ? -1 : 1),
      shape_(scene.projection.shape),
      size_(scene.state.viewport.width, std::abs(scene.state.viewport.height)) {
  const Lens lens = lens_of(scene);
  const glm::dvec3 eye(glm::inverse(scene::view_matrix(scene.camera))[3]);
  pose_.back = lens.back;
  pose_.up = lens.up;
  if (const auto* const look = std::get_if<LookAt>(&scene.camera.placement)) {
    pose_.target = scene::vector_of(look->target);
    pose_.distance = glm::distance(eye, pose_.target);
    world_up_ = glm::normalize(scene::vector_of(look->up));
  } else {
    // What is looked at is as far as the models are.
    const double ahead = glm::dot(eye - ball.centre, lens.back);
    pose_.distance = ahead > ball.radius / 10 ? ahead : ball.radius;
    pose_.target = eye - lens.back * pose_.distance;
    world_up_ = lens.up;
  }
  file_pose_ = pose_;
}

glm::dvec3 CameraControl::right() const {
  return handed_ * glm::cross(pose_.up, pose_.back);
}

double CameraControl::aspect() const {
  const auto* const perspective = std::get_if<PerspectiveProjection>(&shape_);
  return perspective != nullptr && perspective->aspect ? *perspective->aspect : size_.x / size_.y;
}

double CameraControl::view_height() const {
  if (const auto* const box = std::get_if<OrthographicProjection>(&shape_)) return box->top - box->bottom;
  if (const auto* const frustum = std::get_if<FrustumProjection>(&shape_)) {
    return (frustum->top - frustum->bottom) / file_projection_.near * pose_.distance;
  }
  const double fov_y = glm::radians(std::get<PerspectiveProjection>(shape_).fov_y);
  return 2 * pose_.distance * std::tan(fov_y / 2);
}

void CameraControl::changed() {
  moved_ = true;
  ++changes_;
}

void CameraControl::grab_begin(Grab grab, const glm::dvec2& mouse) {
  grab_ = grab;
  mouse_ = mouse;
  held_ = {};  // a key may have been let go where nobody was told
}

void CameraControl::grab_end() {
  grab_ = Grab::kNone;
}

// By x about the world's up, by y about the picture's x axis, no further than straight up and down.
void CameraControl::turn(const glm::dvec2& radians) {
  const glm::dmat3 about_up = rotation(-handed_ * radians.x, world_up_);
  pose_.back = about_up * pose_.back;
  pose_.up = about_up * pose_.up;
  const double from_up = std::acos(std::clamp(glm::dot(pose_.back, world_up_), -1.0, 1.0));
  const double y = std::clamp(radians.y, from_up - std::numbers::pi, from_up);
  const glm::dmat3 about_right = rotation(-handed_ * y, right());
  pose_.back = glm::normalize(about_right * pose_.back);
  pose_.up = glm::normalize(about_right * pose_.up);
}

void CameraControl::grab_update(const glm::dvec2& mouse) {
  const glm::dvec2 moved = mouse - mouse_;
  mouse_ = mouse;
  if (grab_ == Grab::kNone || moved == glm::dvec2(0)) return;
  const glm::dvec2 of_height = moved / size_.y;
  if (grab_ == Grab::kPan) {
    const glm::dvec2 world = of_height * view_height();
    pose_.target += pose_.up * world.y - right() * world.x;
  } else if (grab_ == Grab::kOrbit) {
    turn(of_height * std::numbers::pi);
  } else {
    const glm::dvec3 stays = eye();
    turn(of_height * std::numbers::pi / 2.0);
    pose_.target = stays - pose_.back * pose_.distance;
  }
  changed();
}

void CameraControl::magnify(double factor) {
  if (auto* const box = std::get_if<OrthographicProjection>(&shape_)) {
    for (double* const side : {&box->left, &box->right, &box->bottom, &box->top}) *side *= factor;
  } else {
    pose_.distance *= factor;
  }
  changed();
}

void CameraControl::scroll(double steps) {
  // Between a thousandth and a thousand times what was framed.
  const double height = view_height() * std::pow(kStepOfWheel, steps);
  if (height > ball_.radius / 1000 && height < ball_.radius * 1000) magnify(std::pow(kStepOfWheel, steps));
}

void CameraControl::hold(FlyDirection direction, bool held) {
  held_[static_cast<size_t>(direction)] = held;
}

void CameraControl::update(double seconds) {
  if (grab_ != Grab::kFly) return;
  const auto along = [this](FlyDirection to, FlyDirection from) {
    return double{held_[static_cast<size_t>(to)] ? 1.0 : 0.0} - (held_[static_cast<size_t>(from)] ? 1.0 : 0.0);
  };
  const glm::dvec3 direction = -pose_.back * along(FlyDirection::kForward, FlyDirection::kBackward) +
                               right() * along(FlyDirection::kRight, FlyDirection::kLeft) +
                               pose_.up * along(FlyDirection::kUp, FlyDirection::kDown);
  if (direction == glm::dvec3(0)) return;
  pose_.target += direction * (ball_.radius * seconds);
  changed();
}

void CameraControl::look_from(Side side) {
  // y is up in the models' world, unless the file's camera says otherwise.
  const glm::dvec3 z(0, 0, handed_);
  const glm::dvec3 y(0, 1, 0);
  const bool up_is_z = std::abs(glm::dot(world_up_, z)) > 0.9;
  const glm::dvec3 forwards = up_is_z ? -y : z;
  const glm::dvec3 front = glm::normalize(forwards - world_up_ * glm::dot(forwards, world_up_));
  pose_.up = side == Side::kTop ? -front : world_up_;
  pose_.back = side == Side::kTop ? world_up_ : front;
  if (side == Side::kRight) pose_.back = handed_ * glm::cross(world_up_, front);
  changed();
}

void CameraControl::frame(const Ball& ball) {
  ball_ = ball;
  pose_.target = ball.centre;
  const double narrow = std::min(1.0, aspect());
  if (is_orthographic(shape_)) {
    magnify(2 * kRoom * ball.radius / (view_height() * narrow));
    return;
  }
  const double half_angle = std::atan(view_height() / pose_.distance / 2 * narrow);
  pose_.distance = kRoom * ball.radius / std::sin(half_angle);
  changed();
}

void CameraControl::toggle_orthographic() {
  const double height = view_height();
  if (!is_orthographic(shape_)) {
    const double width = height * aspect();
    shape_ = OrthographicProjection{.left = -width / 2, .right = width / 2, .bottom = -height / 2, .top = height / 2};
  } else {
    shape_ = file_projection_.shape;
    if (is_orthographic(shape_)) shape_ = PerspectiveProjection{.fov_y = kFieldOfView};
    pose_.distance *= height / view_height();
  }
  changed();
}

void CameraControl::reset() {
  pose_ = file_pose_;
  shape_ = file_projection_.shape;
  moved_ = false;
  ++changes_;
}

void CameraControl::resize(double width, double height) {
  size_ = {width, height};
}

Projection CameraControl::projection() const {
  Projection projection{.shape = shape_, .near = file_projection_.near, .far = file_projection_.far};
  projection.far = std::max(projection.far, glm::distance(eye(), ball_.centre) + 1.5 * ball_.radius);
  if (auto* const box = std::get_if<OrthographicProjection>(&projection.shape)) {
    // One of our own is as wide as the picture has become.
    if (is_orthographic(file_projection_.shape)) return projection;
    const double width = (box->top - box->bottom) * aspect();
    box->left = -width / 2;
    box->right = width / 2;
    return projection;
  }
  const double nearer = std::min(1.0, pose_.distance / file_pose_.distance);
  projection.near *= nearer;
  if (auto* const sides = std::get_if<FrustumProjection>(&projection.shape)) {
    for (double* const side : {&sides->left, &sides->right, &sides->bottom, &sides->top}) *side *= nearer;
  }
  return projection;
}

void CameraControl::apply(Scene& scene) const {
  if (!moved_) return;
  scene.camera = {
      .placement = LookAt{.eye = array_of(eye()), .target = array_of(pose_.target), .up = array_of(pose_.up)},
      .handedness = file_camera_.handedness};
  scene.projection = projection();
}

}  // namespace fillrule::view
