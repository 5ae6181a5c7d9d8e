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

void Projection::set_anchors() {
  for (size_t o = 0; o < 3; ++o) {
    const size_t i1 = (o + 1) % 3;
    const size_t i2 = (o + 2) % 3;
    const glm::dvec2 e1{x[i1] - x[o], y[i1] - y[o]};
    const glm::dvec2 e2{x[i2] - x[o], y[i2] - y[o]};
    const double det = std::abs(e1.x * e2.y - e2.x * e1.y);
    // A lost vertex value, product or gradient, by its share of the gradient.
    const auto flushed = [det](double a, double b) { return kFlushed * (1 + (2 + std::abs(a) + std::abs(b)) / det); };
    anchors[o] = {.e1_x = std::abs(e1.x),
                  .e1_y = std::abs(e1.y),
                  .e2_x = std::abs(e2.x),
                  .e2_y = std::abs(e2.y),
                  .det = det,
                  .kappa = (std::abs(e1.x * e2.y) + std::abs(e2.x * e1.y)) / det,
                  .flushed_x = flushed(e1.y, e2.y),
                  .flushed_y = flushed(e1.x, e2.x)};
    largest_x = std::max(largest_x, std::abs(x[o] + centre_x));
    largest_y = std::max(largest_y, std::abs(y[o] + centre_y));
  }
}

WindowLinear::WindowLinear(const Projection& projection, const LinearForm& form, const std::array<double, 3>& q,
                           Gradient gradient, double magnitude)
    : form_(form), centre_x_(projection.centre_x), centre_y_(projection.centre_y) {
  const double gx = std::abs(form.a);
  const double gy = std::abs(form.b);
  double largest = magnitude;
  for (const double value : q) largest = std::max(largest, std::abs(value));
  constant_ = kValueRoundings * (largest + kFlushed) +
              gx * (kPositionRoundings * projection.largest_x + projection.width) +
              gy * (kPositionRoundings * projection.largest_y + std::abs(projection.height));
  for (size_t o = 0; o < 3; ++o) {
    const Projection::Anchor& anchor = projection.anchors[o];
    const double q0 = q[o];
    const double q1 = q[(o + 1) % 3];
    const double q2 = q[(o + 2) % 3];
    double sum_x = 0;
    double sum_y = 0;
    if (gradient == Gradient::kFromDifferences) {
      const double d1 = std::abs(q1 - q0);
      const double d2 = std::abs(q2 - q0);
      sum_x = d1 * anchor.e2_y + d2 * anchor.e1_y;
      sum_y = d1 * anchor.e2_x + d2 * anchor.e1_x;
    } else {
      sum_x = std::abs(q0) * (anchor.e1_y + anchor.e2_y) + std::abs(q1) * anchor.e2_y + std::abs(q2) * anchor.e1_y;
      sum_y = std::abs(q0) * (anchor.e1_x + anchor.e2_x) + std::abs(q1) * anchor.e2_x + std::abs(q2) * anchor.e1_x;
    }
    const double cancelling_x = sum_x / anchor.det + gx * anchor.kappa;
    const double cancelling_y = sum_y / anchor.det + gy * anchor.kappa;
    anchors_[o] = {.x = projection.x[o],
                   .y = projection.y[o],
                   .per_x = cancelling_x + std::min(kGradientRoundings * gx, cancelling_x) + anchor.flushed_x,
                   .per_y = cancelling_y + std::min(kGradientRoundings * gy, cancelling_y) + anchor.flushed_y};
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
