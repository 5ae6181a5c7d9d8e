// What the window shows of a session, by Dear ImGui and OpenGL: buttons, panes, status, help. The OpenGL context must
// be current.
#pragma once

#include <array>
#include <cstdint>
#include <glm/ext/vector_uint2.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "harness/view/input.h"
#include "harness/view/session.h"

namespace fillrule::view {

class UserInterface {
 public:
  UserInterface();
  ~UserInterface();
  UserInterface(const UserInterface&) = delete;
  UserInterface(UserInterface&&) = delete;
  UserInterface& operator=(const UserInterface&) = delete;
  UserInterface& operator=(UserInterface&&) = delete;

  // The window's size in pixels.
  void resize(int width, int height);

  // Hands the input to the session, or keeps it if it is for the buttons: the mouse in the bars.
  void handle(const Input& input, Session& session);

  // Draws everything, and does what buttons are pressed for.
  void draw(Session& session, double seconds);

 private:
  struct Texture {
    unsigned name = 0;
    glm::uvec2 size{0, 0};  // pixels
    uint64_t stamp = 0;
  };
  static void draw_buttons(Session& session);
  static void draw_pane(const Session::Pane& pane, const Mismatch* mismatch, Texture& texture);
  static void draw_help();

  std::vector<Texture> textures_;
  std::array<bool, 3> is_down_{};
  std::array<bool, 3> was_pressed_{};  // since the last frame
  glm::dvec2 mouse_{0};
  int width_ = 1;
  int height_ = 1;
};

}  // namespace fillrule::view
