// Depth, 1/w and the weights of varyings across a primitive: all of them linear in the window, or a quotient of two
// that are (Vulkan specification, "Basic Polygon Rasterization", "Basic Line Segment Rasterization").
#pragma once

#include <array>
#include <vector>

#include "harness/faults/window.h"

namespace fillrule::faults {

// At one position. A varying is the sum of the vertices' values times the weights.
struct Interpolated {
  double depth = 0;  // window space, before bias and clamp
  double reciprocal_w = 0;
  std::array<double, 3> smooth{};
  std::array<double, 3> noperspective{};
};

class Interpolant {
 public:
  // Across a polygon (three corners or more), along a line (two), or constant (one). Of a polygon the three corners
  // that span the largest triangle stand for all.
  Interpolant(const Context& context, const std::vector<WindowCorner>& corners);

  // Pixels.
  [[nodiscard]] Interpolated at(double x, double y) const;

  // |dz/dx| and |dz/dy|, whichever is greater: 1/pixel.
  [[nodiscard]] double depth_slope() const;
  // Of the corners.
  [[nodiscard]] double greatest_depth() const { return greatest_depth_; }

 private:
  void span_triangle();
  void span_line();

  const Context& context_;
  std::vector<WindowCorner> corners_;  // one to three
  // The barycentric coordinate of corner i: (i == 0) + gradient_x_[i] (x - x_0) + gradient_y_[i] (y - y_0).
  std::array<double, 3> gradient_x_{};
  std::array<double, 3> gradient_y_{};
  double greatest_depth_ = 0;
};

}  // namespace fillrule::faults
