#include "harness/view/model_control.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

namespace fillrule::view {
namespace {

constexpr double kSubpixel = 1.0 / 256;
constexpr double kLeastScale = 1e-3;

Vector3 array_of(const glm::dvec3& vector) {
  return {vector.x, vector.y, vector.z};
}

glm::dvec3 direction_of(ModelControl::Axis axis) {
  glm::dvec3 direction(0);
  direction[static_cast<glm::length_t>(axis)] = 1;
  return direction;
}

// About a point.
Transform about(const glm::dvec3& centre, TransformStep step) {
  return {Translate{array_of(-centre)}, step, Translate{array_of(centre)}};
}

// Steps that do the same are one: nudging for an hour leaves one translation.
void append(Transform& transform, const Transform& steps) {
  for (const TransformStep& step : steps) {
    const auto* const move = std::get_if<Translate>(&step);
    auto* const last = transform.empty() ? nullptr : std::get_if<Translate>(&transform.back());
    if (move == nullptr || last == nullptr) {
      transform.push_back(step);
      continue;
    }
    for (size_t i = 0; i < 3; ++i) last->by[i] += move->by[i];
  }
}

}  // namespace

ModelControl::ModelControl(const Scene& scene) {
  for (const SceneObject& object : scene.objects) file_.push_back(object.transform);
  now_ = file_;
}

void ModelControl::begin(Mode mode, const glm::dvec3& centre_world, const Lens& lens, const glm::dvec2& mouse) {
  mode_ = mode;
  axis_.reset();
  centre_ = centre_world;
  lens_ = lens;
  mouse_ = mouse;
  restart();
}

void ModelControl::restart() {
  from_ = mouse_;
  move_ = glm::dvec3(0);
  degrees_ = 0;
  factor_ = 1;
  ++changes_;
}

void ModelControl::constrain(Axis axis) {
  if (mode_ == Mode::kNone) return;
  axis_ = axis_ == axis ? std::nullopt : std::optional(axis);
  const glm::dvec2 from = from_;
  const glm::dvec2 mouse = mouse_;
  restart();
  mouse_ = from_ = from;
  drag(mouse);
}

// Along the axis, where there is one, by as much of the step on the picture as lies in its direction there.
glm::dvec3 ModelControl::move_of(const glm::dvec2& pixels) const {
  if (!axis_) return lens_.step_of(centre_, pixels);
  const glm::dvec3 direction = direction_of(*axis_);
  // So small that perspective does not count.
  const double small = 1e-4 * glm::length(lens_.step_of(centre_, {1, 0}));
  const glm::dvec2 on_picture = (lens_.project(centre_ + direction * small) - lens_.project(centre_)) / small;
  const double squared = glm::dot(on_picture, on_picture);
  return squared > 0 ? direction * (glm::dot(pixels, on_picture) / squared) : glm::dvec3(0);
}

void ModelControl::moved_by(const glm::dvec3& step) {
  // An axis that points at the viewer would take the model anywhere.
  if (glm::length(step) < 1e6 * glm::length(lens_.step_of(centre_, {1, 0}))) move_ += step;
}

void ModelControl::drag(const glm::dvec2& mouse) {
  if (mode_ == Mode::kNone || mouse == mouse_) return;
  const glm::dvec2 centre = lens_.project(centre_);
  const glm::dvec2 before = mouse_ - centre;
  const glm::dvec2 now = mouse - centre;
  if (mode_ == Mode::kMove) {
    moved_by(move_of(mouse - mouse_));
  } else if (mode_ == Mode::kRotate) {
    // y is down.
    const double swept = std::atan2(before.x * -now.y + before.y * now.x, glm::dot(before, now));
    const bool from_behind = axis_ && glm::dot(direction_of(*axis_), lens_.back) < 0;
    degrees_ += glm::degrees(from_behind ? -swept : swept);
  } else {
    factor_ = std::max(glm::length(now) / std::max(glm::distance(from_, centre), 1.0), kLeastScale);
  }
  mouse_ = mouse;
  ++changes_;
}

void ModelControl::step(const glm::dvec2& steps) {
  const double along = steps.x + steps.y;
  switch (mode_) {
    case Mode::kNone:
      return;
    case Mode::kMove:
      if (axis_) {
        const glm::dvec3 direction = direction_of(*axis_);
        const glm::dvec2 right(1, 0);
        moved_by(direction * (along * kSubpixel * glm::length(lens_.step_of(centre_, right))));
      } else {
        moved_by(lens_.step_of(centre_, glm::dvec2(steps.x, -steps.y) * kSubpixel));
      }
      break;
    case Mode::kRotate:
      degrees_ += along;
      break;
    case Mode::kScale:
      factor_ = std::max(factor_ * std::pow(1.01, along), kLeastScale);
      break;
  }
  ++changes_;
}

Transform ModelControl::steps() const {
  if (mode_ == Mode::kMove) return {Translate{array_of(move_)}};
  if (mode_ == Mode::kRotate) {
    // Positive angles of a left-handed world are clockwise.
    const double degrees = lens_.left_handed ? -degrees_ : degrees_;
    return about(centre_, Rotate{array_of(axis_ ? direction_of(*axis_) : lens_.back), degrees});
  }
  if (mode_ == Mode::kScale) {
    Scale scale{{factor_, factor_, factor_}};
    if (axis_) scale.by = array_of(glm::dvec3(1) + direction_of(*axis_) * (factor_ - 1));
    return about(centre_, scale);
  }
  return {};
}

void ModelControl::confirm() {
  append(now_[object_], steps());
  mode_ = Mode::kNone;
  ++changes_;
}

void ModelControl::cancel() {
  mode_ = Mode::kNone;
  ++changes_;
}

void ModelControl::nudge(const glm::dvec3& centre_world, const Lens& lens, const glm::dvec2& subpixels) {
  const glm::dvec3 step = lens.step_of(centre_world, glm::dvec2(subpixels.x, -subpixels.y) * kSubpixel);
  append(now_[object_], {Translate{array_of(step)}});
  ++changes_;
}

void ModelControl::next_object() {
  if (mode_ != Mode::kNone) cancel();
  object_ = (object_ + 1) % now_.size();
}

void ModelControl::reset() {
  now_ = file_;
  mode_ = Mode::kNone;
  ++changes_;
}

void ModelControl::apply(Scene& scene) const {
  for (size_t i = 0; i < now_.size(); ++i) scene.objects[i].transform = now_[i];
  if (mode_ != Mode::kNone) append(scene.objects[object_].transform, steps());
}

}  // namespace fillrule::view
