// A quantity that is linear in the window, and how much float32 loses on the way to it (README.md, "Values").
#pragma once

#include <array>
#include <cstdint>

#include "reference/exact/linear_form.h"

namespace fillrule::exact {

inline constexpr double kUnitRoundoff = 0x1p-24;

// Where a triangle's vertices are in the window, pixels from the viewport's centre. Infinite where w is 0.
struct Projection {
  std::array<double, 3> x{};
  std::array<double, 3> y{};
  double centre_x = 0;
  double centre_y = 0;
  double width = 0;  // of the viewport
  double height = 0;

  // A vertex that a plane may be anchored at, with the edges e_1 and e_2 from it: what of a condition depends on no
  // value.
  struct Anchor {
    double e1_x = 0;  // magnitudes
    double e1_y = 0;
    double e2_x = 0;
    double e2_y = 0;
    double det = 0;        // |det(e_1, e_2)|
    double kappa = 0;      // by how much it cancels
    double flushed_x = 0;  // what is lost where a denormal is flushed, by the pixel
    double flushed_y = 0;
  };
  std::array<Anchor, 3> anchors{};
  double largest_x = 0;  // framebuffer coordinate, in magnitude
  double largest_y = 0;

  // Fills in what follows from the vertices and the viewport.
  void set_anchors();
};

class WindowLinear {
 public:
  WindowLinear() = default;
  // Whether the gradient is computed from differences to the anchor's value (z) or from the values (a/w, 1/w).
  enum class Gradient : uint8_t { kFromDifferences, kFromValues };
  // `form` is the exact function, `q` are the values at the vertices (infinite where w is 0: no bound then).
  // `magnitude` is what rounds on the way to them, where that is larger than they are.
  WindowLinear(const Projection& projection, const LinearForm& form, const std::array<double, 3>& q,
               Gradient gradient, double magnitude = 0);

  [[nodiscard]] double at(double dx, double dy) const { return form_.at(dx, dy); }
  [[nodiscard]] const LinearForm& form() const { return form_; }
  // C(q, p): the magnitudes that float32 rounds on the way to q at p, the largest sum over the choices of the vertex
  // that the plane is anchored at. A convex function of the position.
  [[nodiscard]] double condition(double dx, double dy) const;
  // The share of it that is the same everywhere.
  [[nodiscard]] double least_condition() const { return constant_; }
  // How much the gradient's computation rounds, in units of kUnitRoundoff: the sum of both coordinates' shares.
  [[nodiscard]] double gradient_condition() const;

 private:
  LinearForm form_;
  double constant_ = 0;  // the share of C that does not depend on p
  double centre_x_ = 0;
  double centre_y_ = 0;
  struct Anchor {
    double x = 0;
    double y = 0;
    double per_x = 0;
    double per_y = 0;
  };
  std::array<Anchor, 3> anchors_{};
};

}  // namespace fillrule::exact
