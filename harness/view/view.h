// What is looked at: a scene whose camera and models are moved by hand, or a case as it is. It knows of no window.
#pragma once

#include <cstdint>
#include <glm/ext/vector_uint2.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "harness/scene/assets.h"
#include "harness/view/actions.h"
#include "harness/view/camera_control.h"
#include "harness/view/model_control.h"
#include "harness/view/parties.h"
#include "harness/view/switches.h"

namespace fillrule::view {

class View {
 public:
  // Of a case that is not built yet. Errors: a model or an image that cannot be read.
  static Result<View> create(Case looked_at);

  [[nodiscard]] bool is_scene() const { return camera_.has_value(); }
  [[nodiscard]] const std::string& name() const { return case_.name; }

  // The room for a picture, in pixels. A scene fills it, or, where its width to its height is given, fits into it;
  // other cases, and a scene in its own size, are as large as the file says.
  void resize(uint32_t width, uint32_t height);

  // While what it is time for an action.
  [[nodiscard]] During during() const;

  // Sets off an action on the view, or ends one that is held. What is to be told the user, if anything is. `mouse` is
  // in pixels of the picture. An action that is none on the view does nothing.
  std::string begin(const ActionRow& action, const Input& input, const glm::dvec2& mouse);
  void end(const ActionRow& action);
  void mouse_moved(const glm::dvec2& mouse);
  void update(double seconds);

  // What is to be drawn now.
  Result<Drawable> drawable();

  // Grows with each change of what is drawn.
  [[nodiscard]] uint64_t changes() const;

  // What mode it is in, in a few words.
  [[nodiscard]] std::string state_text() const;

 private:
  View(Case looked_at, std::unique_ptr<scene::Assets> assets);
  std::string do_scene_action(Action action, const Input& input, const glm::dvec2& mouse);
  std::string start_transform(ModelControl::Mode mode, const glm::dvec2& mouse);
  void reset();
  void nudge(Action action, bool far);
  void fit_camera();
  [[nodiscard]] glm::uvec2 picture_size() const;
  [[nodiscard]] Case current_scene() const;
  [[nodiscard]] Case current_case() const;

  Case case_;
  std::unique_ptr<scene::Assets> assets_;
  std::optional<CameraControl> camera_;  // of a scene
  std::optional<ModelControl> models_;   // of a scene
  Switches switches_;
  glm::ivec2 nudged_{0};   // subpixels, of a case that is no scene
  glm::uvec2 room_{1, 1};  // pixels
  uint64_t changes_ = 0;
};

}  // namespace fillrule::view
