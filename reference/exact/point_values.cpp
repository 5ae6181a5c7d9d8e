#include "reference/exact/point_values.h"

#include <algorithm>
#include <cmath>

#include "reference/exact/window_linear.h"

namespace fillrule::exact {
namespace {

// README.md, "Points": 1/w, its product with the value, and twice to get back or to scale to the depth range.
constexpr double kValueRoundings = 4;
constexpr double kPositionRoundings = 4;
// What is lost where a denormal is flushed to zero.
constexpr double kFlushed = 0x1p-126;

}  // namespace

PointValues::PointValues(const Point& point, const Latitude& latitude, bool negative_one_to_one)
    : point_(point), latitude_(latitude) {
  const VkViewport& viewport = point.viewport();
  const double range = double{viewport.maxDepth} - double{viewport.minDepth};
  const double z = double{point.vertex()[2]} / double{point.vertex()[3]};
  const double scaled = range * (negative_one_to_one ? (z + 1) / 2 : z);
  depth_ = scaled + double{viewport.minDepth};
  depth_magnitude_ = std::abs(double{viewport.minDepth}) + std::abs(double{viewport.maxDepth}) + std::abs(range * z);
}

Expected PointValues::depth(double x, double y) const {
  return {.value = depth_ + bias_.middle(), .tolerance = depth_tolerance(x, y).total(), .spread = bias_.spread()};
}

Expected PointValues::reciprocal_w(double /*x*/, double /*y*/) const {
  const double value = 1 / double{point_.vertex()[3]};
  return {.value = value, .tolerance = kValueRoundings * kUnitRoundoff * value + kFlushed};
}

Tolerance PointValues::depth_tolerance(double /*x*/, double /*y*/) const {
  return {.snapping = 0, .rounding = kValueRoundings * kUnitRoundoff * depth_magnitude_ + kFlushed + bias_.tolerance};
}

bool PointValues::judged(uint32_t component) const {
  return std::isfinite(components_[component]);
}

Expected PointValues::varying_for(uint32_t component, float /*value*/, double x, double y) const {
  return {.value = double{components_[component]}, .tolerance = varying_tolerance(component, x, y).total()};
}

// a (1/w) may be a denormal where a is not, and then it is lost: w times as much.
Tolerance PointValues::varying_tolerance(uint32_t component, double /*x*/, double /*y*/) const {
  const double value = std::abs(double{components_[component]});
  const double w{point_.vertex()[3]};
  return {.snapping = 0, .rounding = kValueRoundings * kUnitRoundoff * value + kFlushed * std::max(w, 1.0)};
}

double PointValues::varying_error(uint32_t component, double x, double y) const {
  return kDoubleError * varying_tolerance(component, x, y).total();
}

double PointValues::exact_varying(uint32_t component, double /*x*/, double /*y*/) const {
  return double{components_[component]};
}

Expected PointValues::point_coord_for(size_t axis, float value, double x, double y) const {
  const VkViewport& viewport = point_.viewport();
  const double vertex = axis == 0 ? point_.x() : point_.y();
  const double position = axis == 0 ? x : y;
  const double extent = std::abs(double{axis == 0 ? viewport.width : viewport.height});
  const double offset = position - vertex;
  const SizeRange& size = point_.size();
  // The size itself may be rounded to half a subpixel step.
  const double size_rounding = size.least == std::nearbyint(size.least) ? 0 : (axis == 0 ? latitude_.x : latitude_.y);
  const double least = size.least - size_rounding;
  const double most = size.most + size_rounding;
  const double a = 0.5 + offset / least;
  const double b = 0.5 + offset / most;
  const double rounded = kPositionRoundings * (std::abs(vertex) + std::abs(position)) + extent;
  const double tolerance = kUnitRoundoff * (rounded / least + kValueRoundings * (0.5 + std::abs(offset) / least));
  const double low = std::min(a, b);
  const double high = std::max(a, b);
  const double nearest = std::isnan(value) ? low + (high - low) / 2 : std::clamp(double{value}, low, high);
  return {.value = nearest, .tolerance = tolerance};
}

}  // namespace fillrule::exact
