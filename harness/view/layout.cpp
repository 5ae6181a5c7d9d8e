#include "harness/view/layout.h"

#include <algorithm>

namespace fillrule::view {

std::vector<Rect> panes_of(int window_width, int window_height, size_t panes) {
  const int count = static_cast<int>(panes);
  const int width = std::max((window_width - (count - 1) * kGap) / count, 1);
  const int height = std::max(window_height - kBarHeight - kStatusHeight, 1);
  std::vector<Rect> rects;
  rects.reserve(panes);
  for (int i = 0; i < count; ++i) {
    rects.push_back({.x = i * (width + kGap), .y = kBarHeight, .width = width, .height = height});
  }
  return rects;
}

Rect window_of(int pane_width, int pane_height, size_t panes) {
  const int count = static_cast<int>(panes);
  return {.width = count * pane_width + (count - 1) * kGap, .height = pane_height + kBarHeight + kStatusHeight};
}

Placement place(const Rect& pane, uint32_t width, uint32_t height) {
  const int w = std::max(static_cast<int>(width), 1);
  const int h = std::max(static_cast<int>(height), 1);
  const int scale = std::max(std::min(pane.width / w, pane.height / h), 1);
  return {.rect = {.x = pane.x + std::max((pane.width - w * scale) / 2, 0),
                   .y = pane.y + std::max((pane.height - h * scale) / 2, 0),
                   .width = w * scale,
                   .height = h * scale},
          .scale = scale};
}

}  // namespace fillrule::view
