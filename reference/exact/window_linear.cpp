#include "reference/exact/window_linear.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace fillrule::exact {
namespace {

// In the units of README.md, section "Values": a vertex's value is rounded about twice before it is used, a
// coordinate four times, and what depends on the gradient once where terms cancel, four times where they do not.
constexpr double kValueRoundings = 2;
constexpr double kPositionRoundings = 4;
constexpr double kGradientRoundings = 4;
// What is lost where a denormal is flushed to zero, which Vulkan permits: as a magnitude that rounds by as much.
constexpr double kFlushed = 0x1p-126 / kUnitRoundoff;

}  // namespace

WindowLinear::WindowLinear(const Projection& projection, const LinearForm& form, const std::array<double, 3>& q,
                           Gradient gradient, double magnitude)
    : form_(form), centre_x_(projection.centre_x), centre_y_(projection.centre_y) {
  std::array<glm::dvec2, 3> p;
  for (size_t i = 0; i < 3; ++i) p[i] = {projection.x[i], projection.y[i]};
  const double gx = std::abs(form.a);
  const double gy = std::abs(form.b);
  double largest = magnitude;
  double largest_x = 0;
  double largest_y = 0;
  for (size_t i = 0; i < 3; ++i) {
    largest = std::max(largest, std::abs(q[i]));
    largest_x = std::max(largest_x, std::abs(p[i].x + centre_x_));
    largest_y = std::max(largest_y, std::abs(p[i].y + centre_y_));
  }
  constant_ = kValueRoundings * (largest + kFlushed) + gx * (kPositionRoundings * largest_x + projection.width) +
              gy * (kPositionRoundings * largest_y + std::abs(projection.height));
  for (size_t o = 0; o < 3; ++o) {
    const size_t i1 = (o + 1) % 3;
    const size_t i2 = (o + 2) % 3;
    const glm::dvec2 e1 = p[i1] - p[o];
    const glm::dvec2 e2 = p[i2] - p[o];
    const double det = std::abs(e1.x * e2.y - e2.x * e1.y);
    const double kappa = (std::abs(e1.x * e2.y) + std::abs(e2.x * e1.y)) / det;
    double sum_x = 0;
    double sum_y = 0;
    if (gradient == Gradient::kFromDifferences) {
      const double d1 = std::abs(q[i1] - q[o]);
      const double d2 = std::abs(q[i2] - q[o]);
      sum_x = d1 * std::abs(e2.y) + d2 * std::abs(e1.y);
      sum_y = d1 * std::abs(e2.x) + d2 * std::abs(e1.x);
    } else {
      sum_x = std::abs(q[o]) * (std::abs(e1.y) + std::abs(e2.y)) + std::abs(q[i1] * e2.y) + std::abs(q[i2] * e1.y);
      sum_y = std::abs(q[o]) * (std::abs(e1.x) + std::abs(e2.x)) + std::abs(q[i1] * e2.x) + std::abs(q[i2] * e1.x);
    }
    // A lost vertex value, product or gradient, by its share of the gradient.
    const double flushed_x = kFlushed * (1 + (2 + std::abs(e1.y) + std::abs(e2.y)) / det);
    const double flushed_y = kFlushed * (1 + (2 + std::abs(e1.x) + std::abs(e2.x)) / det);
    const double cancelling_x = sum_x / det + gx * kappa;
    const double cancelling_y = sum_y / det + gy * kappa;
    anchors_[o] = {.x = p[o].x,
                   .y = p[o].y,
                   .per_x = cancelling_x + std::min(kGradientRoundings * gx, cancelling_x) + flushed_x,
                   .per_y = cancelling_y + std::min(kGradientRoundings * gy, cancelling_y) + flushed_y};
  }
}

double WindowLinear::condition(double dx, double dy) const {
  double largest = 0;
  for (const Anchor& anchor : anchors_) {
    largest = std::max(largest, anchor.per_x * std::abs(dx - anchor.x) + anchor.per_y * std::abs(dy - anchor.y));
  }
  return constant_ + largest + std::abs(form_.a * (dx + centre_x_)) + std::abs(form_.b * (dy + centre_y_));
}

double WindowLinear::gradient_condition() const {
  double largest = 0;
  for (const Anchor& anchor : anchors_) largest = std::max(largest, anchor.per_x + anchor.per_y);
  return largest;
}

}  // namespace fillrule::exact
