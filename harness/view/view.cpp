#include "harness/view/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "harness/scene/build.h"
#include "harness/scene/view.h"

namespace fillrule::view {
namespace {

constexpr int kSubpixelsInPixel = 256;

std::optional<FlyDirection> direction_of(Action action) {
  switch (action) {
    case Action::kFlyForward:
      return FlyDirection::kForward;
    case Action::kFlyBackward:
      return FlyDirection::kBackward;
    case Action::kFlyLeft:
      return FlyDirection::kLeft;
    case Action::kFlyRight:
      return FlyDirection::kRight;
    case Action::kFlyDown:
      return FlyDirection::kDown;
    case Action::kFlyUp:
      return FlyDirection::kUp;
    default:
      return std::nullopt;
  }
}

// To the right and upwards.
std::optional<glm::ivec2> arrow_of(Action action) {
  switch (action) {
    case Action::kNudgeLeft:
      return glm::ivec2(-1, 0);
    case Action::kNudgeRight:
      return glm::ivec2(1, 0);
    case Action::kNudgeUp:
      return glm::ivec2(0, 1);
    case Action::kNudgeDown:
      return glm::ivec2(0, -1);
    default:
      return std::nullopt;
  }
}

// Whether the picture may have any width and height without being stretched.
bool fits_any_size(const Scene& scene) {
  const auto* const perspective = std::get_if<PerspectiveProjection>(&scene.projection.shape);
  return perspective != nullptr && !perspective->aspect;
}

}  // namespace

View::View(Case looked_at, std::unique_ptr<scene::Assets> assets)
    : case_(std::move(looked_at)), assets_(std::move(assets)), switches_(case_) {}

Result<View> View::create(Case looked_at) {
  View view(std::move(looked_at), std::make_unique<scene::Assets>());
  view.room_ = {view.case_.target.width, view.case_.target.height};
  if (!view.case_.scene) return view;
  const Result<Ball> ball = ball_around(view.case_, *view.assets_);
  if (!ball) return tl::unexpected(ball.error());
  view.camera_.emplace(*view.case_.scene, *ball);
  view.models_.emplace(*view.case_.scene);
  // So that whatever else is wrong with it is found before there is a window.
  return view.drawable().map([&](const Drawable&) { return std::move(view); });
}

void View::resize(uint32_t width, uint32_t height) {
  const glm::uvec2 room(std::clamp(width, 1U, kMaxTargetSize), std::clamp(height, 1U, kMaxTargetSize));
  if (room == room_) return;
  room_ = room;
  fit_camera();
  ++changes_;
}

glm::uvec2 View::picture_size() const {
  const Target& target = case_.target;
  if (!is_scene() || switches_.own_size()) return {target.width, target.height};
  if (fits_any_size(*case_.scene)) return room_;
  const double aspect = static_cast<double>(target.width) / target.height;
  const auto length = [](double pixels) { return std::max(static_cast<uint32_t>(std::lround(pixels)), 1U); };
  const uint32_t width = std::min(room_.x, length(room_.y * aspect));
  return {width, std::min(room_.y, length(width / aspect))};
}

// The viewport covers as much of the picture as in the file.
void View::fit_camera() {
  if (!camera_) return;
  const VkViewport& viewport = case_.scene->state.viewport;
  const glm::uvec2 size = picture_size();
  camera_->resize(double{viewport.width} * size.x / case_.target.width,
                  std::abs(double{viewport.height}) * size.y / case_.target.height);
}

During View::during() const {
  if (models_ && models_->mode() != ModelControl::Mode::kNone) return During::kTransform;
  if (camera_ && camera_->grab() == Grab::kFly) return During::kFlight;
  return During::kAnything;
}

std::string View::begin(const ActionRow& action, const Input& input, const glm::dvec2& mouse) {
  if (action.needs_scene && !is_scene()) {
    return fmt::format("'{}' needs a scene, and this case has none", action.help);
  }
  if (arrow_of(action.action)) {
    nudge(action.action, input.shift);
    return {};
  }
  if (action.action == Action::kReset) {
    reset();
    return {};
  }
  if (std::string told = switches_.flip(action.action); !told.empty()) {
    fit_camera();
    ++changes_;
    return told;
  }
  return is_scene() ? do_scene_action(action.action, input, mouse) : std::string();
}

void View::reset() {
  switches_ = Switches(case_);
  fit_camera();
  nudged_ = glm::ivec2(0);
  if (camera_) camera_->reset();
  if (models_) models_->reset();
  ++changes_;
}

// An arrow moves the model by a subpixel, or does a step of what is under way.
void View::nudge(Action action, bool far) {
  const glm::ivec2 arrow = *arrow_of(action);
  const glm::ivec2 by = arrow * (far ? kSubpixelsInPixel : 1);
  if (!is_scene()) {
    nudged_ += by;
    ++changes_;
    return;
  }
  if (models_->mode() != ModelControl::Mode::kNone) {
    const bool moves = models_->mode() == ModelControl::Mode::kMove;
    models_->step(moves ? by : arrow * (far ? 10 : 1));
    return;
  }
  const Case now = current_scene();
  if (const auto ball = ball_around(now, models_->object(), *assets_)) {
    models_->nudge(ball->centre, lens_of(*now.scene), by);
  }
}

std::string View::start_transform(ModelControl::Mode mode, const glm::dvec2& mouse) {
  models_->cancel();
  const Case now = current_scene();
  const Result<Ball> ball = ball_around(now, models_->object(), *assets_);
  if (!ball) return to_string(ball.error());
  models_->begin(mode, ball->centre, lens_of(*now.scene), mouse);
  return {};
}

std::string View::do_scene_action(Action action, const Input& input, const glm::dvec2& mouse) {
  if (const auto direction = direction_of(action)) {
    camera_->hold(*direction, true);
    return {};
  }
  switch (action) {
    case Action::kOrbit:
      camera_->grab_begin(Grab::kOrbit, mouse);
      break;
    case Action::kPan:
      camera_->grab_begin(Grab::kPan, mouse);
      break;
    case Action::kFly:
      camera_->grab_begin(Grab::kFly, mouse);
      break;
    case Action::kDolly:
      camera_->scroll(input.y);
      break;
    case Action::kFrame:
      if (const auto ball = ball_around(current_scene(), *assets_)) camera_->frame(*ball);
      break;
    case Action::kFront:
      camera_->look_from(Side::kFront);
      break;
    case Action::kRight:
      camera_->look_from(Side::kRight);
      break;
    case Action::kTop:
      camera_->look_from(Side::kTop);
      break;
    case Action::kOrthographic:
      camera_->toggle_orthographic();
      break;
    case Action::kMove:
      return start_transform(ModelControl::Mode::kMove, mouse);
    case Action::kRotate:
      return start_transform(ModelControl::Mode::kRotate, mouse);
    case Action::kScale:
      return start_transform(ModelControl::Mode::kScale, mouse);
    case Action::kAxisX:
      models_->constrain(ModelControl::Axis::kX);
      break;
    case Action::kAxisY:
      models_->constrain(ModelControl::Axis::kY);
      break;
    case Action::kAxisZ:
      models_->constrain(ModelControl::Axis::kZ);
      break;
    case Action::kConfirm:
      models_->confirm();
      break;
    case Action::kCancel:
      models_->cancel();
      break;
    case Action::kNextObject:
      models_->next_object();
      return fmt::format("model {}: {}", models_->object() + 1, case_.scene->objects[models_->object()].mesh.text);
    default:
      break;
  }
  return {};
}

void View::end(const ActionRow& action) {
  if (!is_scene()) return;
  if (const auto direction = direction_of(action.action)) camera_->hold(*direction, false);
  if (action.trigger == Trigger::kDrag) camera_->grab_end();
}

void View::mouse_moved(const glm::dvec2& mouse) {
  if (!is_scene()) return;
  if (models_->mode() != ModelControl::Mode::kNone) {
    models_->drag(mouse);
  } else {
    camera_->grab_update(mouse);
  }
}

void View::update(double seconds) {
  if (camera_) camera_->update(seconds);
}

uint64_t View::changes() const {
  return changes_ + (camera_ ? camera_->changes() : 0) + (models_ ? models_->changes() : 0);
}

Case View::current_scene() const {
  Scene scene = *case_.scene;
  models_->apply(scene);
  switches_.apply(scene);
  camera_->apply(scene);
  const glm::uvec2 size = picture_size();
  return scene::resized(scene::with_scene(case_, std::move(scene)), size.x, size.y);
}

Case View::current_case() const {
  Case now = case_;
  for (Draw& draw : now.draws) {
    switches_.apply(draw.state);
    const VkViewport& viewport = draw.state.viewport;
    const float x = 2 * static_cast<float>(nudged_.x) / (kSubpixelsInPixel * viewport.width);
    const float y = -2 * static_cast<float>(nudged_.y) / (kSubpixelsInPixel * viewport.height);
    for (ClipPosition& position : draw.positions) {
      position[0] += x * position[3];
      position[1] += y * position[3];
    }
  }
  return now;
}

Result<Drawable> View::drawable() {
  if (!is_scene()) return Drawable{.version = changes(), .built = current_case()};
  Result<Case> built = scene::build(current_scene(), *assets_);
  if (!built) return tl::unexpected(built.error());
  auto shading = scene::shading_of(*built, *assets_);
  if (!shading) return tl::unexpected(shading.error());
  return Drawable{.version = changes(), .built = std::move(*built), .shading = std::move(*shading)};
}

std::string View::state_text() const {
  if (!is_scene()) return {};
  constexpr std::array<const char*, 4> kModes{"", "move", "rotate", "scale"};
  constexpr std::array<const char*, 3> kAxes{" x", " y", " z"};
  const std::string axis = models_->axis() ? kAxes[static_cast<size_t>(*models_->axis())] : "";
  if (during() == During::kTransform) return kModes[static_cast<size_t>(models_->mode())] + axis;
  return camera_->grab() == Grab::kFly ? "fly" : "";
}

}  // namespace fillrule::view
