#include "reference/exact/value_bound.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <glm/vec2.hpp>
#include <limits>

#include "reference/exact/rational_triangle.h"

namespace fillrule::exact {
namespace {

constexpr double kUnitRoundoff = 0x1p-24;
// In the units of README.md, section "Values": a vertex's value is rounded about twice before it is used, a
// coordinate four times, and what depends on the gradient once where terms cancel, four times where they do not.
constexpr double kValueRoundings = 2;
constexpr double kPositionRoundings = 4;
constexpr double kGradientRoundings = 4;
// What is lost where a denormal is flushed to zero, which Vulkan permits: as a magnitude that rounds by as much.
constexpr double kFlushed = 0x1p-126 / kUnitRoundoff;
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

// Window positions, relative to the viewport's centre.
std::array<glm::dvec2, 3> positions(const Triangle& triangle) {
  std::array<glm::dvec2, 3> result;
  for (size_t i = 0; i < 3; ++i) {
    result[i] = glm::dvec2(triangle.u(i), triangle.v(i)) / triangle.w(i);
  }
  return result;
}

double clamp_depth(double depth) {
  return std::clamp(depth, 0.0, 1.0);
}

}  // namespace

double Tolerance::total() const {
  const double sum = snapping + rounding;
  if (std::isnan(sum)) return kUnbounded;
  return sum;
}

WindowLinear::WindowLinear(const Triangle& triangle, const LinearForm& form, const std::array<double, 3>& q,
                           Gradient gradient)
    : form_(form) {
  const auto p = positions(triangle);
  const double gx = std::abs(form.a);
  const double gy = std::abs(form.b);
  double largest_x = 0;
  double largest_y = 0;
  for (size_t i = 0; i < 3; ++i) {
    largest_ = std::max(largest_, std::abs(q[i]));
    largest_x = std::max(largest_x, std::abs(p[i].x + triangle.centre_x()));
    largest_y = std::max(largest_y, std::abs(p[i].y + triangle.centre_y()));
  }
  const VkViewport& viewport = triangle.viewport();
  constant_ = kValueRoundings * (largest_ + kFlushed) +
              gx * (kPositionRoundings * largest_x + double{viewport.width}) +
              gy * (kPositionRoundings * largest_y + std::abs(double{viewport.height}));
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
  centre_x_ = triangle.centre_x();
  centre_y_ = triangle.centre_y();
}

double WindowLinear::condition(double dx, double dy) const {
  double largest = 0;
  for (const Anchor& anchor : anchors_) {
    largest = std::max(largest, anchor.per_x * std::abs(dx - anchor.x) + anchor.per_y * std::abs(dy - anchor.y));
  }
  return constant_ + largest + std::abs(form_.a * (dx + centre_x_)) + std::abs(form_.b * (dy + centre_y_));
}

TriangleValues::TriangleValues(const Triangle& triangle, const Latitude& latitude)
    : triangle_(&triangle), latitude_(latitude) {
  const auto& clip = triangle.vertices();
  const VkViewport& viewport = triangle.viewport();
  const std::array<double, 3> z{double{clip[0][2]}, double{clip[1][2]}, double{clip[2][2]}};
  const double range = double{viewport.maxDepth} - double{viewport.minDepth};
  LinearForm depth = triangle.interpolant(z);
  depth.a *= range;
  depth.b *= range;
  depth.c = depth.c * range + double{viewport.minDepth};
  std::array<double, 3> depths{};
  std::array<double, 3> reciprocals{};
  for (size_t i = 0; i < 3; ++i) {
    depths[i] = z[i] / triangle.w(i) * range + double{viewport.minDepth};
    reciprocals[i] = 1 / triangle.w(i);
    std::array<double, 3> selected{};
    selected[i] = triangle.w(i);
    barycentric_[i] = triangle.interpolant(selected);
  }
  depth_ = WindowLinear(triangle, depth, depths, WindowLinear::Gradient::kFromDifferences);
  const std::array<double, 3> ones{1, 1, 1};
  reciprocal_w_ =
      WindowLinear(triangle, triangle.interpolant(ones), reciprocals, WindowLinear::Gradient::kFromValues);
}

double TriangleValues::barycentric_size(double dx, double dy) const {
  double size = 0;
  for (const LinearForm& form : barycentric_) size += std::abs(form.at(dx, dy));
  return size;
}

Tolerance TriangleValues::linear_tolerance(const WindowLinear& quantity, double dx, double dy) const {
  return {.snapping = barycentric_size(dx, dy) * quantity.form().reach(latitude_.x, latitude_.y),
          .rounding = kUnitRoundoff * quantity.condition(dx, dy)};
}

double TriangleValues::least_linear(const WindowLinear& quantity) const {
  return quantity.form().reach(latitude_.x, latitude_.y) + kValueRoundings * kUnitRoundoff * quantity.largest();
}

Expected TriangleValues::depth(double x, double y) const {
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  return {.value = clamp_depth(depth_.at(dx, dy)), .tolerance = linear_tolerance(depth_, dx, dy).total()};
}

Expected TriangleValues::depth_for(float value, double x, double y) const {
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  const double exact = clamp_depth(depth_.at(dx, dy));
  const double least = least_linear(depth_);
  if (std::abs(double{value} - exact) <= least) return {.value = exact, .tolerance = least};
  return {.value = exact, .tolerance = linear_tolerance(depth_, dx, dy).total()};
}

TriangleValues::Component TriangleValues::component(Interpolation interpolation, const std::array<float, 3>& values,
                                                    float provoking) const {
  Component result{.interpolation = interpolation, .values = values, .provoking = provoking};
  if (interpolation == Interpolation::kFlat) return result;
  std::array<double, 3> weighted{};
  std::array<double, 3> q{};
  const bool smooth = interpolation == Interpolation::kSmooth;
  for (size_t i = 0; i < 3; ++i) {
    const double w = triangle_->w(i);
    const double value{values[i]};
    q[i] = smooth ? value / w : value;
    weighted[i] = smooth ? value : value * w;
    if (!std::isfinite(value) || std::abs(q[i]) > double{FLT_MAX} / 16) result.judged = false;
  }
  if (!result.judged) return result;
  result.numerator =
      WindowLinear(*triangle_, triangle_->interpolant(weighted), q,
                   smooth ? WindowLinear::Gradient::kFromValues : WindowLinear::Gradient::kFromDifferences);
  return result;
}

Tolerance TriangleValues::smooth_tolerance(const Component& component, double value, double dx, double dy) const {
  const double size = barycentric_size(dx, dy);
  const double reciprocal = reciprocal_w_.at(dx, dy);
  double moved = 0;
  for (const double sign_x : {-1.0, 1.0}) {
    for (const double sign_y : {-1.0, 1.0}) {
      const double x = dx + sign_x * size * latitude_.x;
      const double y = dy + sign_y * size * latitude_.y;
      const double there = reciprocal_w_.at(x, y);
      if (!(there > 0)) return {.snapping = kUnbounded};
      moved = std::max(moved, std::abs(component.numerator.at(x, y) / there - value));
    }
  }
  const double rounded = component.numerator.condition(dx, dy) + std::abs(value) * reciprocal_w_.condition(dx, dy);
  return {.snapping = moved, .rounding = kUnitRoundoff * rounded / reciprocal};
}

Expected TriangleValues::varying(const Component& component, double x, double y) const {
  return varying_for(component, std::numeric_limits<float>::quiet_NaN(), x, y);
}

Expected TriangleValues::varying_for(const Component& component, float value, double x, double y) const {
  if (component.interpolation == Interpolation::kFlat) return {.value = double{component.provoking}, .tolerance = 0};
  if (!component.judged) return {.value = std::numeric_limits<double>::quiet_NaN(), .tolerance = kUnbounded};
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  if (component.interpolation == Interpolation::kNoperspective) {
    const double exact = component.numerator.at(dx, dy);
    const double least = least_linear(component.numerator);
    if (std::abs(double{value} - exact) <= least) return {.value = exact, .tolerance = least};
    return {.value = exact, .tolerance = linear_tolerance(component.numerator, dx, dy).total()};
  }
  const double reciprocal = reciprocal_w_.at(dx, dy);
  const double exact = component.numerator.at(dx, dy) / reciprocal;
  // C >= max |q_i| for both quantities, so this is no more than the tolerance.
  const double least = kValueRoundings * kUnitRoundoff *
                       (component.numerator.largest() + std::abs(exact) * reciprocal_w_.largest()) / reciprocal;
  if (std::abs(double{value} - exact) <= least) return {.value = exact, .tolerance = least};
  return {.value = exact, .tolerance = smooth_tolerance(component, exact, dx, dy).total()};
}

Tolerance TriangleValues::depth_tolerance(double x, double y) const {
  return linear_tolerance(depth_, x - triangle_->centre_x(), y - triangle_->centre_y());
}

Tolerance TriangleValues::varying_tolerance(const Component& component, double x, double y) const {
  if (component.interpolation == Interpolation::kFlat) return {};
  if (!component.judged) return {.snapping = kUnbounded, .rounding = kUnbounded};
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  if (component.interpolation == Interpolation::kNoperspective) return linear_tolerance(component.numerator, dx, dy);
  return smooth_tolerance(component, component.numerator.at(dx, dy) / reciprocal_w_.at(dx, dy), dx, dy);
}

// The last term: dx and dy round where the viewport's centre is no short number.
double TriangleValues::form_error(const LinearForm& form, double dx, double dy) const {
  return form.error_at(dx, dy) + form.reach(0x1p-52 * (std::abs(dx) + std::abs(triangle_->centre_x())),
                                            0x1p-52 * (std::abs(dy) + std::abs(triangle_->centre_y())));
}

double TriangleValues::depth_error(double x, double y) const {
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  // Scaling to the depth range rounds three times, to numbers of at most the terms' sum plus 1.
  const LinearForm& form = depth_.form();
  const double terms = std::abs(form.a * dx) + std::abs(form.b * dy) + std::abs(form.c) + 1;
  return form_error(form, dx, dy) + 0x1p-51 * terms;
}

double TriangleValues::varying_error(const Component& component, double x, double y) const {
  if (component.interpolation == Interpolation::kFlat) return 0;
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  const LinearForm& numerator = component.numerator.form();
  const double numerator_error = form_error(numerator, dx, dy);
  if (component.interpolation == Interpolation::kNoperspective) return numerator_error;
  // |n'/r' - n/r| <= (|n' - n| + |n/r| |r' - r|) / |r'|, and the quotient rounds.
  const double reciprocal = std::abs(reciprocal_w_.at(dx, dy));
  const double reciprocal_error = form_error(reciprocal_w_.form(), dx, dy);
  if (!(reciprocal > 2 * reciprocal_error)) return kUnbounded;
  const double largest = (std::abs(numerator.at(dx, dy)) + numerator_error) / (reciprocal - reciprocal_error);
  return ((numerator_error + largest * reciprocal_error) / reciprocal + 0x1p-52 * largest) * (1 + 0x1p-48);
}

double TriangleValues::exact_depth(double x, double y) const {
  return clamp_depth(exact::exact_depth(*triangle_, x, y));
}

double TriangleValues::exact_varying(uint32_t component, double x, double y) const {
  const Component& prepared = components_[component];
  const bool smooth = prepared.interpolation == Interpolation::kSmooth;
  return (smooth ? exact_smooth : exact_noperspective)(*triangle_, prepared.values, x, y);
}

void TriangleValues::depth_row(double x, double y, std::span<double> expected, std::span<double> least) const {
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  const LinearForm& form = depth_.form();
  const double tolerance = least_linear(depth_);
  for (size_t i = 0; i < expected.size(); ++i) {
    expected[i] = clamp_depth(form.at(dx + static_cast<double>(i), dy));
    least[i] = tolerance;
  }
}

void TriangleValues::w_row(double x, double y, std::span<double> w) const {
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  const LinearForm& form = reciprocal_w_.form();
  for (size_t i = 0; i < w.size(); ++i) w[i] = 1 / form.at(dx + static_cast<double>(i), dy);
}

void TriangleValues::varying_row(const Component& component, double x, double y, std::span<const double> w,
                                 std::span<double> expected, std::span<double> least) const {
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  const LinearForm& form = component.numerator.form();
  if (component.interpolation == Interpolation::kNoperspective) {
    const double tolerance = least_linear(component.numerator);
    for (size_t i = 0; i < expected.size(); ++i) {
      expected[i] = form.at(dx + static_cast<double>(i), dy);
      least[i] = tolerance;
    }
    return;
  }
  const double of_numerator = kValueRoundings * kUnitRoundoff * component.numerator.largest();
  const double of_reciprocal = kValueRoundings * kUnitRoundoff * reciprocal_w_.largest();
  for (size_t i = 0; i < expected.size(); ++i) {
    expected[i] = form.at(dx + static_cast<double>(i), dy) * w[i];
    least[i] = (of_numerator + std::abs(expected[i]) * of_reciprocal) * w[i];
  }
}

TriangleValues::DepthRange TriangleValues::depth_range() const {
  DepthRange range{.low = kUnbounded, .high = -kUnbounded};
  double tolerance = 0;
  // The condition is a convex function of the position: largest at a vertex. Inside, A is 1.
  for (size_t i = 0; i < 3; ++i) {
    const double dx = triangle_->u(i) / triangle_->w(i);
    const double dy = triangle_->v(i) / triangle_->w(i);
    range.low = std::min(range.low, depth_.at(dx, dy));
    range.high = std::max(range.high, depth_.at(dx, dy));
    tolerance = std::max(tolerance, linear_tolerance(depth_, dx, dy).total());
  }
  return {.low = range.low - tolerance, .high = range.high + tolerance};
}

}  // namespace fillrule::exact
