// Exact depth and varyings of a point: one vertex's, at every sample; README.md, section "Points".
#pragma once

#include <cmath>
#include <vector>

#include "reference/exact/depth_bias.h"
#include "reference/exact/latitude.h"
#include "reference/exact/piece_values.h"
#include "reference/exact/point.h"

namespace fillrule::exact {

// Not for points that are undefined or not visible.
class PointValues final : public PieceValues {
 public:
  PointValues(const Point& point, const Latitude& latitude, bool negative_one_to_one);

  // Added to all depths: the bias of the polygon that the point is a corner of, or the point's own.
  void set_depth_bias(const BiasRange& bias) { bias_ = bias; }
  // What the point's own depends on.
  [[nodiscard]] PolygonDepth depths() const {
    return {.most_depth = std::abs(depth_) + depth_tolerance(0, 0).total()};
  }

  void add_component(float value) { components_.push_back(value); }

  [[nodiscard]] Expected depth(double x, double y) const override;
  [[nodiscard]] Expected depth_for(float /*value*/, double x, double y) const override { return depth(x, y); }
  [[nodiscard]] Tolerance depth_tolerance(double x, double y) const override;
  // What is exact to a few roundings of double is exact enough: the tolerance is as many of float32.
  [[nodiscard]] double depth_error(double x, double y) const override { return kDoubleError * depth(x, y).tolerance; }
  [[nodiscard]] double exact_depth(double x, double y) const override { return depth(x, y).value; }

  [[nodiscard]] Expected reciprocal_w(double x, double y) const override;
  [[nodiscard]] double reciprocal_w_error(double x, double y) const override {
    return kDoubleError * reciprocal_w(x, y).tolerance;
  }
  [[nodiscard]] double exact_reciprocal_w(double x, double y) const override { return reciprocal_w(x, y).value; }

  [[nodiscard]] float provoking(uint32_t component) const override { return components_[component]; }
  [[nodiscard]] bool judged(uint32_t component) const override;
  [[nodiscard]] Expected varying_for(uint32_t component, float value, double x, double y) const override;
  [[nodiscard]] Tolerance varying_tolerance(uint32_t component, double x, double y) const override;
  [[nodiscard]] double varying_error(uint32_t component, double x, double y) const override;
  [[nodiscard]] double exact_varying(uint32_t component, double x, double y) const override;

  // gl_PointCoord at (x, y), s for axis 0 and t for axis 1; the nearest to `value` of those that are right where the
  // size is not certain.
  [[nodiscard]] Expected point_coord_for(size_t axis, float value, double x, double y) const;

 private:
  static constexpr double kDoubleError = 0x1p-20;

  Point point_;
  Latitude latitude_;
  double depth_ = 0;
  BiasRange bias_;
  double depth_magnitude_ = 0;  // of what is added up to the depth
  std::vector<float> components_;
};

}  // namespace fillrule::exact
