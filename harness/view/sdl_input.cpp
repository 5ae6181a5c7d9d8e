#include "harness/view/sdl_input.h"

#include <SDL_keyboard.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>

namespace fillrule::view {
namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

// As the table of actions has it.
std::string key_name(SDL_Keycode code) {
  std::string name = lower_case(SDL_GetKeyName(code));
  constexpr std::string_view kKeypad = "keypad ";
  if (name.starts_with(kKeypad)) name.erase(0, kKeypad.size());
  if (name == "return") return "enter";
  return name == "f1" ? "?" : name;
}

std::optional<Input> key_input(const SDL_KeyboardEvent& event) {
  Input input{.kind = event.type == SDL_KEYDOWN ? Input::Kind::kKeyDown : Input::Kind::kKeyUp,
              .key = key_name(event.keysym.sym),
              .place = lower_case(SDL_GetScancodeName(event.keysym.scancode)),
              .shift = (event.keysym.mod & KMOD_SHIFT) != 0};
  constexpr std::array<std::string_view, 4> kRepeated{"left", "right", "up", "down"};
  if (event.repeat != 0 && std::find(kRepeated.begin(), kRepeated.end(), input.key) == kRepeated.end()) {
    return std::nullopt;
  }
  if ((event.keysym.mod & KMOD_CTRL) != 0) {
    input.key = "ctrl+" + input.key;
    input.place.clear();
  }
  return input;
}

std::optional<Input> button_input(const SDL_MouseButtonEvent& event) {
  constexpr std::array kButtons{std::pair{SDL_BUTTON_LEFT, MouseButton::kLeft},
                                std::pair{SDL_BUTTON_MIDDLE, MouseButton::kMiddle},
                                std::pair{SDL_BUTTON_RIGHT, MouseButton::kRight}};
  for (const auto& [number, button] : kButtons) {
    if (event.button != number) continue;
    return Input{.kind = event.type == SDL_MOUSEBUTTONDOWN ? Input::Kind::kPress : Input::Kind::kRelease,
                 .button = button};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Input> input_of(const SDL_Event& event) {
  switch (event.type) {
    case SDL_MOUSEMOTION:
      return Input{.kind = Input::Kind::kMove,
                   .x = static_cast<double>(event.motion.x),
                   .y = static_cast<double>(event.motion.y)};
    case SDL_MOUSEWHEEL:
      return Input{.kind = Input::Kind::kWheel, .y = double{event.wheel.preciseY}};
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      return button_input(event.button);
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      return key_input(event.key);
    case SDL_TEXTINPUT:
      // Where it lies depends on the keyboard.
      if (std::string_view(event.text.text) == "?") return Input{.kind = Input::Kind::kKeyDown, .key = "?"};
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace fillrule::view
