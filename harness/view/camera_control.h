// A camera that is moved by hand. It knows of no window: mouse positions are pixels of the picture, y down, whose
// size is that of the scene's viewport. It works in worlds of either handedness.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cases/model/scene.h"
#include "harness/view/lens.h"

namespace fillrule::view {

enum class Grab : uint8_t { kNone, kOrbit, kPan, kFly };
enum class Side : uint8_t { kFront, kRight, kTop };
enum class FlyDirection : uint8_t { kForward, kBackward, kLeft, kRight, kDown, kUp };

class CameraControl {
 public:
  // Of a scene whose models are within the ball.
  CameraControl(const Scene& scene, const Ball& ball);

  // Turns around the target, moves along with the mouse, or looks around, until the end. What is under the mouse
  // follows it.
  void grab_begin(Grab grab, const glm::dvec2& mouse);
  void grab_update(const glm::dvec2& mouse);
  void grab_end();
  [[nodiscard]] Grab grab() const { return grab_; }

  // By steps of the wheel towards the target; an orthographic picture is magnified.
  void scroll(double steps);

  // Flies while a direction is held and the camera is grabbed for it, by a ball's radius a second.
  void hold(FlyDirection direction, bool held);
  void update(double seconds);

  void look_from(Side side);
  void frame(const Ball& ball);  // so that all of the ball is seen
  void toggle_orthographic();    // with the same size at the target
  void reset();                  // as in the file

  // The picture's size in pixels.
  void resize(double width, double height);

  // The scene seen by this camera: exactly the scene's own as long as nothing has been moved. The near plane comes
  // nearer as the camera does, and the far plane stays behind the models.
  void apply(Scene& scene) const;

  // Grows with each change.
  [[nodiscard]] uint64_t changes() const { return changes_; }

 private:
  struct Pose {
    glm::dvec3 target{0};
    glm::dvec3 back{0, 0, 1};  // from the target to the eye, length 1
    glm::dvec3 up{0, 1, 0};    // on the picture, length 1, at right angles to back
    double distance = 1;
  };

  [[nodiscard]] glm::dvec3 eye() const { return pose_.target + pose_.back * pose_.distance; }
  [[nodiscard]] glm::dvec3 right() const;
  [[nodiscard]] double view_height() const;  // at the target, in the world
  [[nodiscard]] double aspect() const;       // width / height of what is seen
  [[nodiscard]] Projection projection() const;
  void turn(const glm::dvec2& radians);
  void magnify(double factor);
  void changed();

  Camera file_camera_;
  Projection file_projection_;
  Ball ball_;
  double handed_ = 1;             // -1 in a left-handed world
  glm::dvec3 world_up_{0, 1, 0};  // that is orbited about
  Pose file_pose_;
  Pose pose_;
  decltype(Projection::shape) shape_;
  glm::dvec2 size_{1, 1};
  Grab grab_ = Grab::kNone;
  glm::dvec2 mouse_{0};
  std::array<bool, 6> held_{};
  bool moved_ = false;
  uint64_t changes_ = 0;
};

}  // namespace fillrule::view
