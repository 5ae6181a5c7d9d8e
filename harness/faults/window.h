// From clip space to the window: division by w, viewport, rounding to the subpixel grid, facing (Vulkan
// specification, "Coordinate Transformations", "Controlling the Viewport", "Basic Polygon Rasterization").
#pragma once

#include <cstdint>
#include <vector>

#include "harness/faults/clip.h"

namespace fillrule::faults {

// Subpixels, from the framebuffer's top left corner.
struct Snapped {
  int64_t x = 0;
  int64_t y = 0;
};

struct WindowCorner {
  double x = 0;  // pixels, not rounded
  double y = 0;
  double depth = 0;         // window space, before bias and clamp
  double reciprocal_w = 0;  // 1/w
  // The value of a varying linear in the window is the sum of the vertices' values times these.
  std::array<double, 3> weights_over_w{};  // of a smooth one: those of value / w
  std::array<double, 3> noperspective{};
  Snapped snapped;
};

WindowCorner to_window(const Context& context, const Primitive& primitive, const Corner& corner);

// True if the whole polygon is to be dropped for where its corners are.
bool out_of_range(const Context& context, const std::vector<WindowCorner>& corners);

bool is_front_facing(const Context& context, const std::vector<Corner>& clipped,
                     const std::vector<WindowCorner>& corners);

bool is_culled(const Context& context, bool front_facing);

// Rounds pixels to the subpixel grid.
int64_t snap(const Context& context, double pixels);

}  // namespace fillrule::faults
