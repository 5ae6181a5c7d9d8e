#include "harness/faults/interpolation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fillrule::faults {
namespace {

double twice_area(const WindowCorner& a, const WindowCorner& b, const WindowCorner& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

std::vector<WindowCorner> largest_triangle(const std::vector<WindowCorner>& corners) {
  std::vector<WindowCorner> largest{corners[0], corners[1], corners[2]};
  double most = std::abs(twice_area(corners[0], corners[1], corners[2]));
  for (size_t i = 0; i < corners.size(); ++i) {
    for (size_t j = i + 1; j < corners.size(); ++j) {
      for (size_t k = j + 1; k < corners.size(); ++k) {
        const double area = std::abs(twice_area(corners[i], corners[j], corners[k]));
        if (!(area > most)) continue;
        most = area;
        largest = {corners[i], corners[j], corners[k]};
      }
    }
  }
  return largest;
}

double rounded_to_12_bits(double weight) {
  return std::nearbyint(weight * 0x1p12) * 0x1p-12;
}

}  // namespace

Interpolant::Interpolant(const Context& context, const std::vector<WindowCorner>& corners)
    : context_(context), corners_(corners.size() > 3 ? largest_triangle(corners) : corners) {
  if (corners_.size() == 3) span_triangle();
  if (corners_.size() == 2) span_line();
  for (const WindowCorner& corner : corners) greatest_depth_ = std::max(greatest_depth_, std::abs(corner.depth));
}

void Interpolant::span_triangle() {
  const WindowCorner& a = corners_[0];
  const WindowCorner& b = corners_[1];
  const WindowCorner& c = corners_[2];
  const double area = twice_area(a, b, c);
  if (area == 0) return;
  gradient_x_ = {(b.y - c.y) / area, (c.y - a.y) / area, (a.y - b.y) / area};
  gradient_y_ = {(c.x - b.x) / area, (a.x - c.x) / area, (b.x - a.x) / area};
}

void Interpolant::span_line() {
  const double dx = corners_[1].x - corners_[0].x;
  const double dy = corners_[1].y - corners_[0].y;
  const double length_squared = dx * dx + dy * dy;
  if (length_squared == 0) return;
  gradient_x_ = {-dx / length_squared, dx / length_squared, 0};
  gradient_y_ = {-dy / length_squared, dy / length_squared, 0};
}

Interpolated Interpolant::at(double x, double y) const {
  std::array<double, 3> b{};
  for (size_t i = 0; i < corners_.size(); ++i) {
    b[i] = (i == 0 ? 1 : 0) + gradient_x_[i] * (x - corners_[0].x) + gradient_y_[i] * (y - corners_[0].y);
  }
  if (context_.has(Fault::kWeightsSwapped)) std::swap(b[0], b[1]);
  Interpolated result;
  double depth_over_w = 0;
  std::array<double, 3> affine{};
  for (size_t k = 0; k < corners_.size(); ++k) {
    const WindowCorner& corner = corners_[k];
    result.depth += b[k] * corner.depth;
    result.reciprocal_w += b[k] * corner.reciprocal_w;
    depth_over_w += b[k] * corner.depth * corner.reciprocal_w;
    for (size_t i = 0; i < 3; ++i) {
      result.smooth[i] += b[k] * corner.weights_over_w[i];
      result.noperspective[i] += b[k] * corner.noperspective[i];
      affine[i] += b[k] * corner.weights_over_w[i] / corner.reciprocal_w;
    }
  }
  for (double& weight : result.smooth) weight /= result.reciprocal_w;
  if (context_.has(Fault::kAffineVaryings)) result.smooth = affine;
  if (context_.has(Fault::kNoperspectiveAsSmooth)) result.noperspective = result.smooth;
  for (auto* const weights : {&result.smooth, &result.noperspective}) {
    for (double& weight : *weights) {
      if (context_.has(Fault::kIntegerWeights)) weight = std::trunc(weight);
      if (context_.has(Fault::kCoarseWeights)) weight = rounded_to_12_bits(weight);
    }
  }
  if (context_.has(Fault::kPerspectiveDepth)) result.depth = depth_over_w / result.reciprocal_w;
  if (context_.has(Fault::kDepthOfPrimitive)) {
    result.depth = 0;
    for (const WindowCorner& corner : corners_) result.depth += corner.depth / static_cast<double>(corners_.size());
  }
  return result;
}

double Interpolant::depth_slope() const {
  double dx = 0;
  double dy = 0;
  for (size_t i = 0; i < corners_.size(); ++i) {
    dx += corners_[i].depth * gradient_x_[i];
    dy += corners_[i].depth * gradient_y_[i];
  }
  return std::max(std::abs(dx), std::abs(dy));
}

}  // namespace fillrule::faults
