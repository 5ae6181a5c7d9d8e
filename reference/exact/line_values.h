// Exact depth and varyings along a line in double, and how far a float32 implementation may be from them; README.md,
// section "Lines".
#pragma once

#include <array>
#include <vector>

#include "reference/exact/latitude.h"
#include "reference/exact/piece_values.h"
#include "reference/exact/segment.h"
#include "reference/exact/value_bound.h"

namespace fillrule::exact {

// Places along the line, in pixels from the viewport's centre: where a value at a sample may be taken.
struct Interval {
  double low = 0;
  double high = 0;
};

// A quantity that is linear along the line in the window, with the condition of computing it (WindowLinear's
// pendant).
class LineQuantity {
 public:
  LineQuantity() = default;
  // `homogeneous` are the vertices' values times w, `q` the values themselves.
  LineQuantity(const Segment& segment, const std::array<double, 2>& homogeneous, const std::array<double, 2>& q,
               WindowLinear::Gradient gradient);

  [[nodiscard]] double at(double along) const { return slope_ * along + constant_; }
  [[nodiscard]] double slope() const { return slope_; }    // per pixel
  [[nodiscard]] double length() const { return length_; }  // between both ends in the window, pixels
  // C(q, p) in units of 2^-24: README.md.
  [[nodiscard]] double condition(double dx, double dy) const;
  // The share of it that is the same everywhere.
  [[nodiscard]] double least_condition() const { return constant_condition_; }
  // q times `factor` plus `summand`, of window values `q`.
  [[nodiscard]] LineQuantity scaled(double factor, double summand, const std::array<double, 2>& q) const;

 private:
  void set_condition(const std::array<double, 2>& q);
  double slope_ = 0;
  double constant_ = 0;
  double difference_ = 0;  // what the gradient is computed from, over the line's length
  double clipper_ = 0;     // what a clipper rounds on the way to a new end, in units of 2^-24
  double length_ = 0;
  std::array<double, 2> x_{};  // of the ends, pixels from the viewport's centre
  std::array<double, 2> y_{};
  double direction_x_ = 0;
  double direction_y_ = 0;
  VkViewport viewport_{};
  double centre_x_ = 0;
  double centre_y_ = 0;
  // What the condition is made of: a constant, by the pixel of the place's coordinates, and by the pixel from an end.
  double constant_condition_ = 0;
  double per_x_ = 0;
  double per_y_ = 0;
  double from_end_x_ = 0;
  double from_end_y_ = 0;
};

// The values of one line. Not for undefined ones, nor for those that are a point.
class LineValues final : public PieceValues {
 public:
  // How the place along the line is found: by projecting the sample onto it; for Bresenham lines the major axis'
  // coordinate may be used too, and wide ones may have one value for all their fragments side by side.
  enum class Rule : uint8_t { kProjected, kBresenham, kWideBresenham };
  LineValues(const Segment& segment, const Latitude& latitude, Rule rule);

  // Added to all depths: the bias of the polygon that the line is an edge of, or the line's own.
  void set_depth_bias(const BiasRange& bias) { bias_ = bias; }
  // What the line's own depends on. The slope may be counted along the line or for each pixel of its major axis.
  [[nodiscard]] PolygonDepth depths() const;

  void add_component(Interpolation interpolation, const std::array<float, 2>& values, float provoking);

  // Where several values are right the nearest of them, or, if none is given, their middle with all of them within
  // the tolerance.
  [[nodiscard]] Expected depth_for(float value, double x, double y) const override;
  [[nodiscard]] Expected depth(double x, double y) const override;
  [[nodiscard]] Tolerance depth_tolerance(double x, double y) const override;
  // Doubles are all there is: they err by far less than a millionth of the tolerance, of which float32's rounding of
  // the same terms is a part.
  [[nodiscard]] double depth_error(double x, double y) const override { return kDoubleError * depth(x, y).tolerance; }
  [[nodiscard]] double exact_depth(double x, double y) const override { return depth(x, y).value; }

  [[nodiscard]] Expected reciprocal_w(double x, double y) const override;
  [[nodiscard]] double reciprocal_w_error(double x, double y) const override {
    return kDoubleError * reciprocal_w(x, y).tolerance;
  }
  [[nodiscard]] double exact_reciprocal_w(double x, double y) const override { return reciprocal_w(x, y).value; }

  [[nodiscard]] float provoking(uint32_t component) const override { return components_[component].provoking; }
  [[nodiscard]] bool judged(uint32_t component) const override { return components_[component].judged; }
  [[nodiscard]] Expected varying_for(uint32_t number, float value, double x, double y) const override;
  void least_varyings(double x, double y, std::span<const uint32_t> wanted,
                      std::span<Expected> components) const override;
  [[nodiscard]] Tolerance varying_tolerance(uint32_t component, double x, double y) const override;
  [[nodiscard]] double varying_error(uint32_t component, double x, double y) const override;
  [[nodiscard]] double exact_varying(uint32_t component, double x, double y) const override;

 private:
  static constexpr double kDoubleError = 0x1p-20;
  struct Component {
    Interpolation interpolation = Interpolation::kSmooth;
    float provoking = 0;
    LineQuantity numerator;  // a/w of a smooth varying, the value itself of a noperspective one
    bool judged = true;
  };
  struct Judgement {
    Expected expected;
    Tolerance tolerance;
  };
  // A quantity at a place along the line.
  struct Local {
    double value = 0;
    double least = 0;  // a lower bound of its tolerance
  };
  [[nodiscard]] double bias_rounding(double biased) const;
  [[nodiscard]] Interval places(double dx, double dy) const;
  [[nodiscard]] double moved(double along, double dx, double dy) const;
  [[nodiscard]] Local local_linear(const LineQuantity& quantity, double along) const;
  [[nodiscard]] Local local_smooth(const LineQuantity& numerator, double along) const;
  [[nodiscard]] Local local(const Component& component, double along) const;
  // Of the nearest value to this one, as in varying_for(), with a lower bound of its tolerance.
  [[nodiscard]] Expected least_varying(const Component& component, float value, const Interval& along) const;
  [[nodiscard]] Judgement linear(const LineQuantity& quantity, float value, double x, double y) const;
  [[nodiscard]] Judgement smooth(const LineQuantity& numerator, float value, double x, double y) const;
  [[nodiscard]] Judgement varying(uint32_t number, float value, double x, double y) const;

  Segment segment_;
  Rule rule_;
  SegmentMoves moves_;
  LineQuantity depth_;
  LineQuantity reciprocal_w_;
  BiasRange bias_;
  std::array<LineQuantity, 2> share_;  // of either end in the window
  std::vector<Component> components_;
};

}  // namespace fillrule::exact
