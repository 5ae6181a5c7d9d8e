#include "reference/exact/line_values.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <numbers>

namespace fillrule::exact {
namespace {

// README.md, "Lines": roundings of a vertex's value, of a coordinate, and of t.
constexpr double kValueRoundings = 2;
constexpr double kPositionRoundings = 4;
constexpr double kPlaceRoundings = 6;
// As in value_bound.cpp: what flushing a denormal to zero loses, as a magnitude that rounds by as much.
constexpr double kFlushed = 0x1p-126 / kUnitRoundoff;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// What lower bounds leave for all that they round in double.
constexpr double kBelow = 1 - 0x1p-20;
constexpr float kAnyValue = std::numeric_limits<float>::quiet_NaN();

double infinite_unless(bool known, double value) {
  if (known) return value;
  return kInfinity;
}

// The one of the values between a and b that is nearest to `value`, or, for NaN, the middle of them.
Expected nearest(float value, double a, double b, double tolerance) {
  const double low = std::min(a, b);
  const double high = std::max(a, b);
  if (!std::isnan(value)) return {.value = std::clamp(double{value}, low, high), .tolerance = tolerance};
  return {.value = low + (high - low) / 2, .tolerance = tolerance + (high - low) / 2};
}

}  // namespace

LineQuantity::LineQuantity(const Segment& segment, const std::array<double, 2>& homogeneous,
                           const std::array<double, 2>& q, WindowLinear::Gradient gradient)
    : direction_x_(segment.direction_x()),
      direction_y_(segment.direction_y()),
      viewport_(segment.viewport()),
      centre_x_(segment.centre_x()),
      centre_y_(segment.centre_y()) {
  // p = l_a A + l_b B for the point p of the line at `along`: l_a = (along_B - along w_B) / scale and
  // l_b = (along w_A - along_A) / scale, along_i homogeneous too.
  std::array<double, 2> along{};
  for (size_t i = 0; i < 2; ++i) {
    along[i] = segment.along(segment.u(i), segment.v(i));
    x_[i] = segment.u(i) / segment.w(i);
    y_[i] = segment.v(i) / segment.w(i);
  }
  slope_ = difference_of_products(segment.w(0), homogeneous[1], segment.w(1), homogeneous[0]) / segment.scale();
  constant_ = difference_of_products(along[1], homogeneous[0], along[0], homogeneous[1]) / segment.scale();
  length_ = std::hypot(x_[1] - x_[0], y_[1] - y_[0]);
  difference_ =
      gradient == WindowLinear::Gradient::kFromDifferences ? std::abs(q[1] - q[0]) : std::abs(q[0]) + std::abs(q[1]);
  const auto& part = segment.clipped() ? segment.clipped() : segment.unbounded();
  if (part && !part->whole) {
    const double largest = std::max(std::abs(homogeneous[0]), std::abs(homogeneous[1]));
    const double largest_w = std::max(std::abs(segment.w(0)), std::abs(segment.w(1)));
    for (const SegmentEnd& end : {part->begin, part->end}) {
      const double rounded = (largest + std::abs(at(end.along)) * largest_w) / end.w;
      clipper_ = std::max(clipper_, kClipperRoundings * rounded);
    }
  }
  set_condition(q);
}

void LineQuantity::set_condition(const std::array<double, 2>& q) {
  per_x_ = std::abs(slope_ * direction_x_);
  per_y_ = std::abs(slope_ * direction_y_);
  const double flushed = kFlushed * (1 + 2 / length_);
  from_end_x_ = difference_ / length_ * std::abs(direction_x_) + kPlaceRoundings * per_x_ + flushed;
  from_end_y_ = difference_ / length_ * std::abs(direction_y_) + kPlaceRoundings * per_y_ + flushed;
  const double largest = std::max(std::abs(q[0]), std::abs(q[1]));
  const double largest_x = std::max(std::abs(x_[0] + centre_x_), std::abs(x_[1] + centre_x_));
  const double largest_y = std::max(std::abs(y_[0] + centre_y_), std::abs(y_[1] + centre_y_));
  constant_condition_ = kValueRoundings * (largest + kFlushed) + clipper_ +
                        per_x_ * (kPositionRoundings * largest_x + double{viewport_.width}) +
                        per_y_ * (kPositionRoundings * largest_y + std::abs(double{viewport_.height}));
}

LineQuantity LineQuantity::scaled(double factor, double summand, const std::array<double, 2>& q) const {
  LineQuantity result = *this;
  result.slope_ *= factor;
  result.constant_ = constant_ * factor + summand;
  result.difference_ = std::abs(q[1] - q[0]);
  result.clipper_ *= std::abs(factor);
  result.set_condition(q);
  return result;
}

double LineQuantity::condition(double dx, double dy) const {
  double from_end = 0;
  for (size_t i = 0; i < 2; ++i) {
    from_end = std::max(from_end, from_end_x_ * std::abs(dx - x_[i]) + from_end_y_ * std::abs(dy - y_[i]));
  }
  return constant_condition_ + per_x_ * std::abs(dx + centre_x_) + per_y_ * std::abs(dy + centre_y_) + from_end;
}

LineValues::LineValues(const Segment& segment, const Latitude& latitude, Rule rule)
    : segment_(segment), rule_(rule), moves_(segment.moves(latitude)) {
  const auto& clip = segment.vertices();
  const VkViewport& viewport = segment.viewport();
  using Gradient = WindowLinear::Gradient;
  const double range = double{viewport.maxDepth} - double{viewport.minDepth};
  const double min_depth{viewport.minDepth};
  const std::array<double, 2> z{double{clip[0][2]}, double{clip[1][2]}};
  const std::array<double, 2> z_ndc{z[0] / segment.w(0), z[1] / segment.w(1)};
  const double scale = segment.negative_one_to_one() ? range / 2 : range;
  const double zero = segment.negative_one_to_one() ? min_depth + range / 2 : min_depth;
  depth_ = LineQuantity(segment, z, z_ndc, Gradient::kFromDifferences)
               .scaled(scale, zero, {z_ndc[0] * scale + zero, z_ndc[1] * scale + zero});
  reciprocal_w_ = LineQuantity(segment, {1, 1}, {1 / segment.w(0), 1 / segment.w(1)}, Gradient::kFromValues);
  share_[0] = LineQuantity(segment, {segment.w(0), 0}, {1, 0}, Gradient::kFromDifferences);
  share_[1] = LineQuantity(segment, {0, segment.w(1)}, {0, 1}, Gradient::kFromDifferences);
}

void LineValues::add_component(Interpolation interpolation, const std::array<float, 2>& values, float provoking) {
  Component result{.interpolation = interpolation, .provoking = provoking};
  const bool smooth = interpolation == Interpolation::kSmooth;
  std::array<double, 2> homogeneous{};
  std::array<double, 2> q{};
  for (size_t i = 0; i < 2; ++i) {
    const double w = segment_.w(i);
    const double value{values[i]};
    q[i] = smooth ? value / w : value;
    homogeneous[i] = smooth ? value : value * w;
    if (!std::isfinite(value) || std::abs(q[i]) > double{FLT_MAX} / 16) result.judged = false;
  }
  if (result.judged) {
    using Gradient = WindowLinear::Gradient;
    result.numerator =
        LineQuantity(segment_, homogeneous, q, smooth ? Gradient::kFromValues : Gradient::kFromDifferences);
  }
  components_.push_back(result);
}

Interval LineValues::places(double dx, double dy) const {
  const double projected = segment_.along(dx, dy);
  if (rule_ == Rule::kProjected) return {.low = projected, .high = projected};
  const double x = segment_.direction_x();
  const double y = segment_.direction_y();
  const double distance = segment_.distance(dx, dy);
  // Rounding the ends may make a line at nearly 45 degrees x-major or y-major.
  const double lean = std::abs(x) - std::abs(y);
  const double turn = moves_.any_direction ? 1 : std::numbers::sqrt2 * moves_.turn;
  const bool may_be_x_major = lean >= -turn;
  const bool may_be_y_major = lean <= turn;
  // The fragment that a wide line's others follow is within a pixel and a half of the line along the minor axis.
  const double others = rule_ == Rule::kWideBresenham ? 1.5 * std::min(std::abs(x), std::abs(y)) : 0;
  Interval interval{.low = projected, .high = projected};
  // From the sample along the minor axis to the line.
  const auto add = [&](double by_major) {
    interval.low = std::min(interval.low, by_major - others);
    interval.high = std::max(interval.high, by_major + others);
  };
  if (may_be_x_major) add(projected - distance * y / x);
  if (may_be_y_major) add(projected + distance * x / y);
  return interval;
}

// How far rounding the ends moves the sample's place along the line.
double LineValues::moved(double along, double dx, double dy) const {
  const double shares = std::abs(share_[0].at(along)) + std::abs(share_[1].at(along));
  return shares * (moves_.along + moves_.slop) + std::abs(segment_.distance(dx, dy)) * moves_.turn;
}

// The shares of both ends add up to 1, and so are no less than that in magnitude.
LineValues::Local LineValues::local_linear(const LineQuantity& quantity, double along) const {
  const double moved = std::abs(quantity.slope()) * (moves_.along + moves_.slop);
  return {.value = quantity.at(along), .least = kBelow * (moved + kUnitRoundoff * quantity.least_condition())};
}

// As TriangleValues::least_smooth(): the numerator n and 1/w = r give v(p + d) - v = (n' - v r') d / r(p + d), where
// d and -d are both tried, and one of both r is at most r(p).
LineValues::Local LineValues::local_smooth(const LineQuantity& numerator, double along) const {
  const double w = 1 / reciprocal_w_.at(along);
  const double value = numerator.at(along) * w;
  const double moved = std::abs(numerator.slope() - value * reciprocal_w_.slope()) * (moves_.along + moves_.slop);
  const double rounded = numerator.least_condition() + std::abs(value) * reciprocal_w_.least_condition();
  return {.value = value, .least = kBelow * (moved + kUnitRoundoff * rounded) * std::abs(w)};
}

LineValues::Local LineValues::local(const Component& component, double along) const {
  const bool is_smooth = component.interpolation == Interpolation::kSmooth;
  return is_smooth ? local_smooth(component.numerator, along) : local_linear(component.numerator, along);
}

LineValues::Judgement LineValues::linear(const LineQuantity& quantity, float value, double x, double y) const {
  const double dx = x - segment_.centre_x();
  const double dy = y - segment_.centre_y();
  const Interval along = places(dx, dy);
  const double shift = std::max(moved(along.low, dx, dy), moved(along.high, dx, dy));
  const Tolerance tolerance{.snapping = std::abs(quantity.slope()) * shift,
                            .rounding = kUnitRoundoff * quantity.condition(dx, dy)};
  return {.expected = nearest(value, quantity.at(along.low), quantity.at(along.high), tolerance.total()),
          .tolerance = tolerance};
}

LineValues::Judgement LineValues::smooth(const LineQuantity& numerator, float value, double x, double y) const {
  const double dx = x - segment_.centre_x();
  const double dy = y - segment_.centre_y();
  const Interval along = places(dx, dy);
  const auto at = [&](double place) { return numerator.at(place) / reciprocal_w_.at(place); };
  Tolerance tolerance;
  const size_t places = along.low == along.high ? 1 : 2;
  for (size_t i = 0; i < places; ++i) {
    const double place = i == 0 ? along.low : along.high;
    const double shift = moved(place, dx, dy);
    for (const double there : {place - shift, place + shift}) {
      const bool in_front = reciprocal_w_.at(there) > 0;
      tolerance.snapping = std::max(tolerance.snapping, infinite_unless(in_front, std::abs(at(there) - at(place))));
    }
    const double rounded = numerator.condition(dx, dy) + std::abs(at(place)) * reciprocal_w_.condition(dx, dy);
    tolerance.rounding = std::max(tolerance.rounding, kUnitRoundoff * rounded / std::abs(reciprocal_w_.at(place)));
  }
  return {.expected = nearest(value, at(along.low), at(along.high), tolerance.total()), .tolerance = tolerance};
}

LineValues::Judgement LineValues::varying(uint32_t number, float value, double x, double y) const {
  const Component& component = components_[number];
  if (!component.judged) {
    return {.expected = {.value = std::numeric_limits<double>::quiet_NaN(), .tolerance = kInfinity},
            .tolerance = {.snapping = kInfinity, .rounding = kInfinity}};
  }
  const bool is_smooth = component.interpolation == Interpolation::kSmooth;
  return is_smooth ? smooth(component.numerator, value, x, y) : linear(component.numerator, value, x, y);
}

Expected LineValues::depth_for(float value, double x, double y) const {
  const auto unbiased = static_cast<float>(double{value} - bias_.middle());
  Expected expected = linear(depth_, unbiased, x, y).expected;
  expected.value += bias_.middle();
  expected.tolerance += bias_rounding(expected.value);
  expected.spread = bias_.spread();
  return expected;
}

// The bias, and what adding it rounds.
double LineValues::bias_rounding(double biased) const {
  return bias_.tolerance + kUnitRoundoff * (std::abs(biased) + std::abs(bias_.middle()));
}

Expected LineValues::depth(double x, double y) const {
  return depth_for(kAnyValue, x, y);
}

PolygonDepth LineValues::depths() const {
  const double slope = std::numbers::sqrt2 * std::abs(depth_.slope());
  // Rounding makes the line shorter, and either depth as good as any within its bound.
  const double length = depth_.length();
  const double shortened = length - 2 * (moves_.along + moves_.slop);
  double most = 0;
  double rounded = 0;
  for (size_t i = 0; i < 2; ++i) {
    const double x = segment_.u(i) / segment_.w(i);
    const double y = segment_.v(i) / segment_.w(i);
    most = infinite_unless(segment_.w(i) > 0, std::max(most, std::abs(depth_.at(segment_.along(x, y)))));
    rounded = std::max(rounded, kUnitRoundoff * depth_.condition(x, y));
  }
  const double tolerance = (slope * (length - shortened) + 2 * std::numbers::sqrt2 * rounded) / shortened;
  return {.gradient_x = slope,
          .gradient_tolerance = infinite_unless(shortened > 0, tolerance),
          .most_depth = most + rounded};
}

Expected LineValues::reciprocal_w(double x, double y) const {
  return linear(reciprocal_w_, kAnyValue, x, y).expected;
}

Tolerance LineValues::depth_tolerance(double x, double y) const {
  const Judgement judgement = linear(depth_, kAnyValue, x, y);
  Tolerance tolerance = judgement.tolerance;
  tolerance.rounding += bias_rounding(judgement.expected.value + bias_.middle());
  return tolerance;
}

Expected LineValues::varying_for(uint32_t number, float value, double x, double y) const {
  const Component& component = components_[number];
  if (component.judged) {
    const Expected expected =
        least_varying(component, value, places(x - segment_.centre_x(), y - segment_.centre_y()));
    if (std::abs(double{value} - expected.value) <= expected.tolerance) return expected;
  }
  return varying(number, value, x, y).expected;
}

void LineValues::least_varyings(double x, double y, std::span<const uint32_t> wanted,
                                std::span<Expected> components) const {
  const Interval along = places(x - segment_.centre_x(), y - segment_.centre_y());
  for (const uint32_t c : wanted) {
    const Component& component = components_[c];
    components[c] = component.judged ? least_varying(component, kAnyValue, along) : varying_for(c, kAnyValue, x, y);
  }
}

Expected LineValues::least_varying(const Component& component, float value, const Interval& along) const {
  const Local a = local(component, along.low);
  if (along.low == along.high) return {.value = a.value, .tolerance = a.least};
  const Local b = local(component, along.high);
  return nearest(value, a.value, b.value, std::min(a.least, b.least));
}

Tolerance LineValues::varying_tolerance(uint32_t component, double x, double y) const {
  return varying(component, kAnyValue, x, y).tolerance;
}

double LineValues::varying_error(uint32_t component, double x, double y) const {
  return kDoubleError * varying(component, kAnyValue, x, y).expected.tolerance;
}

double LineValues::exact_varying(uint32_t component, double x, double y) const {
  return varying(component, kAnyValue, x, y).expected.value;
}

}  // namespace fillrule::exact
