// The one table of what can be done at the window: keys, mouse, buttons and the help all come from it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/view/input.h"

namespace fillrule::view {

enum class Action : uint8_t {
  kOrbit,
  kPan,
  kDolly,
  kFly,
  kFlyForward,
  kFlyBackward,
  kFlyLeft,
  kFlyRight,
  kFlyDown,
  kFlyUp,
  kFrame,
  kReset,
  kFront,
  kRight,
  kTop,
  kOrthographic,
  kMove,
  kRotate,
  kScale,
  kAxisX,
  kAxisY,
  kAxisZ,
  kConfirm,
  kCancel,
  kNextObject,
  kNudgeLeft,
  kNudgeRight,
  kNudgeUp,
  kNudgeDown,
  kWireframe,
  kCulling,
  kTexture,
  kLights,
  kOwnSize,
  kNextMismatch,
  kBake,
  kHelp,
  kQuit,
};

// What sets an action off.
enum class Trigger : uint8_t {
  kKey,    // by what is printed on it
  kPlace,  // a key by its place, so that W A S D lie under the fingers on any keyboard; held
  kDrag,   // a mouse button, held while the mouse moves
  kWheel,
};

// While what it is there for. The same key may do one thing while the camera flies, and another one else.
enum class During : uint8_t { kAnything, kFlight, kTransform };

struct ActionRow {
  Action action;
  Trigger trigger;
  std::string_view key;  // or mouse button: "left", "middle", "right"; of the wheel: none
  During during;
  std::string_view button;  // what the button of the window says; empty: there is none
  std::string_view help;
  bool needs_scene;
};

std::span<const ActionRow> actions();

// What an input sets off, or ends, at this time; none of a motion of the mouse.
const ActionRow* find_action(const Input& input, During during);

// Whether some action has this key, and all keys that there are.
bool is_key(std::string_view key);
std::vector<std::string> key_names();

// Two columns: what to press, and what it does.
struct HelpLine {
  std::string keys;
  std::string_view help;
};
std::vector<HelpLine> help_lines();

}  // namespace fillrule::view
