// What a user does at the window, in words of no toolkit: the window translates its events into these, and recorded
// ones are read from a file (event_file.h).
#pragma once

#include <cstdint>
#include <string>

namespace fillrule::view {

enum class MouseButton : uint8_t { kLeft, kMiddle, kRight };

struct Input {
  enum class Kind : uint8_t {
    kMove,   // the mouse, to x, y
    kPress,  // a mouse button, where the mouse is
    kRelease,
    kWheel,  // by y steps, positive away from the user
    kKeyDown,
    kKeyUp,
    kWait,  // until everything that was asked for is drawn and judged; only from a file
  };
  Kind kind = Kind::kMove;
  double x = 0;  // pixels of the window, from its top left corner
  double y = 0;
  MouseButton button = MouseButton::kLeft;
  std::string key;    // in lower case: what is printed on it ("ctrl+s", "?", "up")
  std::string place;  // what is printed there on an American keyboard: its scancode
  bool shift = false;
  bool operator==(const Input&) const = default;
};

}  // namespace fillrule::view
