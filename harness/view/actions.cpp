#include "harness/view/actions.h"

#include <algorithm>
#include <array>

namespace fillrule::view {
namespace {

using enum Trigger;
using enum During;

constexpr std::array<std::string_view, 3> kButtonNames{"left", "middle", "right"};

constexpr std::array kActions{
    ActionRow{Action::kConfirm, kDrag, "left", kTransform, "", "leave the model as it is now", true},
    ActionRow{Action::kCancel, kDrag, "right", kTransform, "", "put the model back", true},
    ActionRow{Action::kOrbit, kDrag, "left", kAnything, "", "orbit around what is looked at", true},
    ActionRow{Action::kPan, kDrag, "middle", kAnything, "", "pan", true},
    ActionRow{Action::kDolly, kWheel, "", kAnything, "", "dolly towards it, or away", true},
    ActionRow{Action::kFly, kDrag, "right", kAnything, "", "look around, and fly:", true},
    ActionRow{Action::kFlyForward, kPlace, "w", kFlight, "", "forward", true},
    ActionRow{Action::kFlyBackward, kPlace, "s", kFlight, "", "backward", true},
    ActionRow{Action::kFlyLeft, kPlace, "a", kFlight, "", "to the left", true},
    ActionRow{Action::kFlyRight, kPlace, "d", kFlight, "", "to the right", true},
    ActionRow{Action::kFlyDown, kPlace, "q", kFlight, "", "down", true},
    ActionRow{Action::kFlyUp, kPlace, "e", kFlight, "", "up", true},
    ActionRow{Action::kFrame, kKey, "f", kAnything, "Frame", "frame the models", true},
    ActionRow{Action::kConfirm, kKey, "enter", kTransform, "", "leave the model as it is now", true},
    ActionRow{Action::kReset, kKey, "enter", kAnything, "Reset", "camera and models as in the file", false},
    ActionRow{Action::kFront, kKey, "1", kAnything, "Front", "look from the front", true},
    ActionRow{Action::kRight, kKey, "3", kAnything, "Right", "look from the right", true},
    ActionRow{Action::kTop, kKey, "7", kAnything, "Top", "look from above", true},
    ActionRow{Action::kOrthographic, kKey, "5", kAnything, "Ortho", "orthographic or perspective", true},
    ActionRow{Action::kMove, kKey, "g", kAnything, "", "move the model by mouse or arrows", true},
    ActionRow{Action::kRotate, kKey, "r", kAnything, "", "rotate it; an arrow by 1 degree", true},
    ActionRow{Action::kScale, kKey, "s", kAnything, "", "scale it; an arrow by 1 percent", true},
    ActionRow{Action::kAxisX, kKey, "x", kTransform, "", "along or about the world's x alone", true},
    ActionRow{Action::kAxisY, kKey, "y", kTransform, "", "y alone", true},
    ActionRow{Action::kAxisZ, kKey, "z", kTransform, "", "z alone", true},
    ActionRow{Action::kCancel, kKey, "escape", kTransform, "", "put the model back", true},
    ActionRow{Action::kNextObject, kKey, "tab", kAnything, "", "the next model of several", true},
    ActionRow{Action::kNudgeLeft, kKey, "left", kAnything, "", "nudge by one subpixel; with shift by a pixel", false},
    ActionRow{Action::kNudgeRight, kKey, "right", kAnything, "", "likewise", false},
    ActionRow{Action::kNudgeUp, kKey, "up", kAnything, "", "likewise", false},
    ActionRow{Action::kNudgeDown, kKey, "down", kAnything, "", "likewise", false},
    ActionRow{Action::kWireframe, kKey, "w", kAnything, "Wire", "wireframe or filled", false},
    ActionRow{Action::kCulling, kKey, "c", kAnything, "Cull", "back faces culled or not", false},
    ActionRow{Action::kTexture, kKey, "t", kAnything, "Texture", "textures on or off", true},
    ActionRow{Action::kLights, kKey, "l", kAnything, "Lights", "lights on or off", true},
    ActionRow{Action::kOwnSize, kKey, "0", kAnything, "Size", "as large as the window, or as in the file", true},
    ActionRow{Action::kNextMismatch, kKey, "n", kAnything, "Next", "the next mismatch, the worst first", false},
    ActionRow{Action::kBake, kKey, "ctrl+s", kAnything, "Bake", "bake the view into a new case file", false},
    ActionRow{Action::kHelp, kKey, "?", kAnything, "?", "this help", false},
    ActionRow{Action::kQuit, kKey, "ctrl+q", kAnything, "", "quit", false},
};

bool sets_off(const ActionRow& row, const Input& input) {
  switch (row.trigger) {
    case kKey:
      return (input.kind == Input::Kind::kKeyDown || input.kind == Input::Kind::kKeyUp) && row.key == input.key;
    case kPlace:
      return (input.kind == Input::Kind::kKeyDown || input.kind == Input::Kind::kKeyUp) && row.key == input.place;
    case kDrag:
      return (input.kind == Input::Kind::kPress || input.kind == Input::Kind::kRelease) &&
             row.key == kButtonNames[static_cast<size_t>(input.button)];
    case kWheel:
      return input.kind == Input::Kind::kWheel;
  }
  return false;
}

std::string keys_of(const ActionRow& row) {
  std::string keys(row.key);
  if (row.trigger == kDrag) keys += " button";
  if (row.trigger == kWheel) keys = "wheel";
  if (row.during == kTransform) keys += " (after g, r, s)";
  return keys;
}

}  // namespace

std::span<const ActionRow> actions() {
  return kActions;
}

const ActionRow* find_action(const Input& input, During during) {
  const ActionRow* found = nullptr;
  for (const ActionRow& row : kActions) {
    if (!sets_off(row, input)) continue;
    if (row.during == during) return &row;
    if (row.during == kAnything && found == nullptr) found = &row;
  }
  return found;
}

bool is_key(std::string_view key) {
  return std::any_of(kActions.begin(), kActions.end(), [&](const ActionRow& row) {
    return (row.trigger == kKey || row.trigger == kPlace) && row.key == key;
  });
}

std::vector<std::string> key_names() {
  std::vector<std::string> names;
  for (const ActionRow& row : kActions) {
    if (!is_key(row.key) || std::find(names.begin(), names.end(), row.key) != names.end()) continue;
    names.emplace_back(row.key);
  }
  return names;
}

std::vector<HelpLine> help_lines() {
  std::vector<HelpLine> lines;
  lines.reserve(kActions.size());
  for (const ActionRow& row : kActions) lines.push_back({.keys = keys_of(row), .help = row.help});
  return lines;
}

}  // namespace fillrule::view
