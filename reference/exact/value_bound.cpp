#include "reference/exact/value_bound.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

#include "reference/exact/rational_triangle.h"

namespace fillrule::exact {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
// What lower bounds leave for all that they round in double.
constexpr double kBelow = 1 - 0x1p-20;

}  // namespace

double Tolerance::total() const {
  const double sum = snapping + rounding;
  if (std::isnan(sum)) return kUnbounded;
  return sum;
}

void PieceValues::varyings(double x, double y, std::span<const uint32_t> wanted,
                           std::span<Expected> components) const {
  for (const uint32_t c : wanted) {
    // NaN is within no tolerance, so that all of it is worked out.
    components[c] = varying_for(c, std::numeric_limits<float>::quiet_NaN(), x, y);
  }
}

void PieceValues::least_varyings(double x, double y, std::span<const uint32_t> wanted,
                                 std::span<Expected> components) const {
  varyings(x, y, wanted, components);
}

TriangleValues::TriangleValues(const Triangle& triangle, const Latitude& latitude)
    : triangle_(&triangle), latitude_(latitude), projection_(triangle.projection()) {
  const auto& clip = triangle.vertices();
  const std::array<double, 3> z{double{clip[0][2]}, double{clip[1][2]}, double{clip[2][2]}};
  const double scale = triangle.depth_scale();
  const double offset = triangle.depth_offset();
  LinearForm depth = triangle.interpolant(z);
  depth.a *= scale;
  depth.b *= scale;
  depth.c = depth.c * scale + offset;
  double magnitude = 0;
  std::array<double, 3> depths{};
  std::array<double, 3> reciprocals{};
  for (size_t i = 0; i < 3; ++i) {
    depths[i] = z[i] / triangle.w(i) * scale + offset;
    magnitude = std::max(magnitude, std::abs(z[i] / triangle.w(i) * scale) + std::abs(offset));
    reciprocals[i] = 1 / triangle.w(i);
    std::array<double, 3> selected{};
    selected[i] = triangle.w(i);
    barycentric_[i] = triangle.interpolant(selected);
  }
  depth_ = WindowLinear(projection_, depth, depths, WindowLinear::Gradient::kFromDifferences, magnitude);
  const std::array<double, 3> ones{1, 1, 1};
  reciprocal_w_ =
      WindowLinear(projection_, triangle.interpolant(ones), reciprocals, WindowLinear::Gradient::kFromValues);
  set_largest_depth_tolerance();
}

// The condition is a convex function of the position, and so is what a bias rounds: largest at a vertex. Inside A
// is 1.
// The factor leaves room for what doubles round: a wider range decides about less.
void TriangleValues::set_largest_depth_tolerance() {
  largest_depth_tolerance_ = triangle_->in_front() ? 0 : kUnbounded;
  for (size_t i = 0; i < 3 && std::isfinite(largest_depth_tolerance_); ++i) {
    const double tolerance =
        depth_tolerance(projection_.x[i] + triangle_->centre_x(), projection_.y[i] + triangle_->centre_y()).total();
    largest_depth_tolerance_ = std::max(largest_depth_tolerance_, tolerance * (1 + 0x1p-20));
  }
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
  return kBelow * (quantity.form().reach(latitude_.x, latitude_.y) + kUnitRoundoff * quantity.least_condition());
}

// A lower bound of the tolerance of a smooth varying of value v, times 1/w. The numerator n and 1/w = r give
// v(p + d) - v = (dn - v dr).d / r(p + d), where d and -d are both tried, A is 1 at least, and one of both r is at
// most r(p).
double TriangleValues::least_smooth(const Component& component, double value) const {
  const LinearForm& n = component.numerator.form();
  const LinearForm& r = reciprocal_w_.form();
  const double rounded = component.numerator.least_condition() + std::abs(value) * reciprocal_w_.least_condition();
  const double moved = latitude_.x * std::abs(n.a - value * r.a) + latitude_.y * std::abs(n.b - value * r.b);
  return kBelow * (kUnitRoundoff * rounded + moved);
}

// Rounding may move the vertices, hence the gradient: g' with g'.(e_i + D_i) = g.e_i, |g'.D_i| <= 2 R', R' =
// t_x |g'_x| + t_y |g'_y|, so |g' - g| <= 2 R' times the rows of the inverse of (e_1, e_2), for any anchor. With k
// the change of R' itself, R' <= R / (1 - k).
PolygonDepth TriangleValues::polygon_depth() const {
  const LinearForm& form = depth_.form();
  PolygonDepth polygon{.gradient_x = std::abs(form.a), .gradient_y = std::abs(form.b)};
  const Projection& p = projection_;
  double snapping = kUnbounded;
  for (size_t o = 0; o < 3; ++o) {
    const size_t i = (o + 1) % 3;
    const size_t j = (o + 2) % 3;
    const double e1x = p.x[i] - p.x[o];
    const double e1y = p.y[i] - p.y[o];
    const double e2x = p.x[j] - p.x[o];
    const double e2y = p.y[j] - p.y[o];
    const double det = std::abs(e1x * e2y - e2x * e1y);
    const double per_x = 2 * (std::abs(e1y) + std::abs(e2y)) / det;
    const double per_y = 2 * (std::abs(e1x) + std::abs(e2x)) / det;
    const double change = latitude_.x * per_x + latitude_.y * per_y;
    if (!(change < 0.5)) continue;
    const double moved = form.reach(latitude_.x, latitude_.y) / (1 - change);
    snapping = std::min(snapping, moved * (per_x + per_y));
  }
  polygon.gradient_tolerance = snapping + kUnitRoundoff * depth_.gradient_condition();
  if (std::isnan(polygon.gradient_tolerance)) polygon.gradient_tolerance = kUnbounded;
  for (const Position& corner : triangle_->visible_part(latitude_)) {
    const double depth = depth_.at(corner.x - triangle_->centre_x(), corner.y - triangle_->centre_y());
    polygon.least_depth = std::max(polygon.least_depth, std::abs(depth));
  }
  polygon.most_depth = polygon.least_depth;
  if (!triangle_->in_front()) return polygon;
  double of_vertices = 0;
  for (size_t i = 0; i < 3; ++i) of_vertices = std::max(of_vertices, std::abs(depth_.at(p.x[i], p.y[i])));
  if (triangle_->inside_volume()) polygon.least_depth = of_vertices;
  polygon.most_depth = std::max(polygon.least_depth, of_vertices);
  return polygon;
}

void TriangleValues::set_depth_bias(const DepthBias& bias, VkFormat format) {
  bias_ = bias_range(bias, format, polygon_depth());
  set_largest_depth_tolerance();
}

Expected TriangleValues::depth(double x, double y) const {
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  const double value = depth_.at(dx, dy) + bias_.middle();
  return {.value = value, .tolerance = depth_tolerance(x, y).total(), .spread = bias_.spread()};
}

Expected TriangleValues::depth_inside(double x, double y) const {
  const double value = depth_.at(x - triangle_->centre_x(), y - triangle_->centre_y()) + bias_.middle();
  return {.value = value, .tolerance = largest_depth_tolerance_, .spread = bias_.spread()};
}

Expected TriangleValues::depth_for(float value, double x, double y) const {
  const double exact = depth_.at(x - triangle_->centre_x(), y - triangle_->centre_y()) + bias_.middle();
  const double least = least_linear(depth_);
  if (!(std::abs(double{value} - exact) - bias_.spread() <= least)) return depth(x, y);
  return {.value = exact, .tolerance = least, .spread = bias_.spread()};
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
      WindowLinear(projection_, triangle_->interpolant(weighted), q,
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
  const double least = least_smooth(component, exact) / reciprocal;
  if (std::abs(double{value} - exact) <= least) return {.value = exact, .tolerance = least};
  return {.value = exact, .tolerance = smooth_tolerance(component, exact, dx, dy).total()};
}

void TriangleValues::least_varyings(double x, double y, std::span<const uint32_t> wanted,
                                    std::span<Expected> components) const {
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  const double w = 1 / reciprocal_w_.at(dx, dy);
  for (const uint32_t c : wanted) {
    const Component& component = components_[c];
    if (component.interpolation == Interpolation::kFlat || !component.judged) {
      components[c] = varying(component, x, y);
    } else if (component.interpolation == Interpolation::kNoperspective) {
      components[c] = {.value = component.numerator.at(dx, dy), .tolerance = least_linear(component.numerator)};
    } else {
      const double value = component.numerator.at(dx, dy) * w;
      components[c] = {.value = value, .tolerance = least_smooth(component, value) * w};
    }
  }
}

Tolerance TriangleValues::depth_tolerance(double x, double y) const {
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  Tolerance tolerance = linear_tolerance(depth_, dx, dy);
  // The bias, and the sum that adds it.
  const bool biased = bias_.low != 0 || bias_.high != 0 || bias_.tolerance != 0;
  if (biased) {
    tolerance.rounding +=
        bias_.tolerance + kUnitRoundoff * (std::abs(depth_.at(dx, dy) + bias_.middle()) + bias_.spread());
  }
  return tolerance;
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
  return form_error(form, dx, dy) + 0x1p-51 * (terms + std::abs(bias_.middle()));
}

double TriangleValues::reciprocal_w_error(double x, double y) const {
  return form_error(reciprocal_w_.form(), x - triangle_->centre_x(), y - triangle_->centre_y());
}

Expected TriangleValues::reciprocal_w(double x, double y) const {
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  return {.value = reciprocal_w_.at(dx, dy), .tolerance = linear_tolerance(reciprocal_w_, dx, dy).total()};
}

double TriangleValues::exact_reciprocal_w(double x, double y) const {
  return exact::exact_reciprocal_w(*triangle_, x, y);
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
  return exact::exact_depth(*triangle_, x, y) + bias_.middle();
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
    expected[i] = form.at(dx + static_cast<double>(i), dy) + bias_.middle();
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
  for (size_t i = 0; i < expected.size(); ++i) {
    expected[i] = form.at(dx + static_cast<double>(i), dy) * w[i];
    least[i] = least_smooth(component, expected[i]) * w[i];
  }
}

DepthRange TriangleValues::depth_range() const {
  DepthRange range{.low = kUnbounded, .high = -kUnbounded};
  for (size_t i = 0; i < 3; ++i) {
    const double depth = depth_.at(projection_.x[i], projection_.y[i]);
    range.low = std::min(range.low, depth);
    range.high = std::max(range.high, depth);
  }
  return {.low = range.low + bias_.low - largest_depth_tolerance_,
          .high = range.high + bias_.high + largest_depth_tolerance_};
}

}  // namespace fillrule::exact
