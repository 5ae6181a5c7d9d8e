// Lines by the diamond-exit rule, word for word: each pixel is asked whether the line produces it (Vulkan
// specification, "Bresenham Line Segment Rasterization").
#pragma once

#include "harness/faults/window.h"

namespace fillrule::faults {

class DiamondExitLine {
 public:
  DiamondExitLine(const Context& context, const Snapped& a, const Snapped& b);

  // The pixel may be outside of the target.
  [[nodiscard]] bool produces(int64_t x, int64_t y) const;

 private:
  [[nodiscard]] bool leaves_diamond(int64_t x, int64_t y) const;

  const Context& context_;
  bool x_major_ = true;
  int64_t width_ = 1;  // pixels
  // In half subpixels, so that pixel centres and half a width are whole numbers.
  Snapped a_;
  Snapped b_;
  int64_t pixel_ = 512;
};

}  // namespace fillrule::faults
