// Models that are moved, rotated and scaled by hand, by mouse or arrows. It knows of no window: mouse positions are
// framebuffer coordinates of the picture.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "cases/model/scene.h"
#include "harness/view/lens.h"

namespace fillrule::view {

class ModelControl {
 public:
  enum class Mode : uint8_t { kNone, kMove, kRotate, kScale };
  enum class Axis : uint8_t { kX, kY, kZ };  // of the world

  explicit ModelControl(const Scene& scene);

  // Starts to move, rotate about, or scale from the centre of the object that is chosen; one that has been started
  // before is cancelled.
  void begin(Mode mode, const glm::dvec3& centre_world, const Lens& lens, const glm::dvec2& mouse);
  // Only along, or about, this axis; the same once more: freely again, in or about the picture.
  void constrain(Axis axis);
  void drag(const glm::dvec2& mouse);
  // An arrow: by 1/256 pixel, a degree or a percent each, to the right and upwards.
  void step(const glm::dvec2& steps);
  void confirm();
  void cancel();

  // Without a mode: the object moves by so many subpixels of 1/256 pixel on the picture, y upwards.
  void nudge(const glm::dvec3& centre_world, const Lens& lens, const glm::dvec2& subpixels);

  void next_object();
  void reset();  // as in the file

  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] std::optional<Axis> axis() const { return axis_; }
  [[nodiscard]] size_t object() const { return object_; }

  // The scene with its models as they are now.
  void apply(Scene& scene) const;

  // Grows with each change.
  [[nodiscard]] uint64_t changes() const { return changes_; }

 private:
  [[nodiscard]] Transform steps() const;
  [[nodiscard]] glm::dvec3 move_of(const glm::dvec2& pixels) const;
  void restart();
  void moved_by(const glm::dvec3& step);

  std::vector<Transform> file_;
  std::vector<Transform> now_;  // what is under way left out
  size_t object_ = 0;
  Mode mode_ = Mode::kNone;
  std::optional<Axis> axis_;
  glm::dvec3 centre_{0};
  Lens lens_;
  glm::dvec2 from_{0};
  glm::dvec2 mouse_{0};
  // What is under way.
  glm::dvec3 move_{0};
  double degrees_ = 0;  // seen from the axis' tip, counter-clockwise on the picture
  double factor_ = 1;
  uint64_t changes_ = 0;
};

}  // namespace fillrule::view
