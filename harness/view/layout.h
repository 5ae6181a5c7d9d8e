// Where things are in the window: bars of the user interface above and below, and the panes side by side between
// them.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace fillrule::view {

struct Rect {
  int x = 0;  // pixels of the window, from its top left corner
  int y = 0;
  int width = 1;
  int height = 1;
  bool operator==(const Rect&) const = default;
};

inline constexpr int kBarHeight = 56;     // above the panes: buttons, and the panes' names
inline constexpr int kStatusHeight = 24;  // below
inline constexpr int kGap = 4;            // between panes

// So many panes of equal size.
std::vector<Rect> panes_of(int window_width, int window_height, size_t panes);

// The window that leaves each of the panes so much room.
Rect window_of(int pane_width, int pane_height, size_t panes);

// A picture in the middle of its pane: each pixel as a square of as many as fit; one that is too large is cut at the
// right and at the bottom.
struct Placement {
  Rect rect;  // of the whole picture
  int scale = 1;

  // Pixels of the picture.
  [[nodiscard]] glm::dvec2 picture_point(const glm::dvec2& window) const {
    return {(window.x - rect.x) / scale, (window.y - rect.y) / scale};
  }
};
Placement place(const Rect& pane, uint32_t width, uint32_t height);

}  // namespace fillrule::view
