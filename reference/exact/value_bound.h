// Exact depth and varyings of a triangle in double, and how far a float32 implementation may be from them.
//
// The bound is derived in reference/exact/README.md ("Values"). In short, for a quantity q that is linear in the
// window (depth, a/w, 1/w) an implementation (1) may interpolate between rounded vertices, which moves q by up to
// A (t_x |dq/dx| + t_y |dq/dy|), A = sum of |window barycentric coordinates|, and (2) rounds every step to float32,
// which errs by u C(q, p), u = 2^-24, where C adds up the magnitudes that are rounded, as often as they are.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "reference/exact/depth_bias.h"
#include "reference/exact/depth_format.h"
#include "reference/exact/piece_values.h"
#include "reference/exact/triangle.h"
#include "reference/exact/window_linear.h"

namespace fillrule::exact {

// The values of one triangle. Not for triangles without area, nor undefined ones.
class TriangleValues final : public PieceValues {
 public:
  TriangleValues(const Triangle& triangle, const Latitude& latitude);

  // Adds the bias to all depths.
  void set_depth_bias(const DepthBias& bias, VkFormat format);
  [[nodiscard]] const BiasRange& depth_bias() const { return bias_; }

  [[nodiscard]] Expected depth(double x, double y) const override;
  [[nodiscard]] Expected depth_inside(double x, double y) const override;
  [[nodiscard]] Expected depth_for(float value, double x, double y) const override;

  // The vertices' values of one component of a varying, prepared.
  struct Component {
    Interpolation interpolation = Interpolation::kSmooth;
    std::array<float, 3> values{};
    float provoking = 0;
    WindowLinear numerator;  // a/w of a smooth varying, the value itself of a noperspective one
    bool judged = true;      // false where a vertex's value is not finite, or a/w leaves float32
  };
  [[nodiscard]] Component component(Interpolation interpolation, const std::array<float, 3>& values,
                                    float provoking) const;

  [[nodiscard]] Expected varying(const Component& component, double x, double y) const;
  [[nodiscard]] Expected varying_for(const Component& component, float value, double x, double y) const;

  [[nodiscard]] Tolerance depth_tolerance(double x, double y) const override;
  [[nodiscard]] Tolerance varying_tolerance(const Component& component, double x, double y) const;

  [[nodiscard]] double depth_error(double x, double y) const override;
  [[nodiscard]] double varying_error(const Component& component, double x, double y) const;
  [[nodiscard]] double exact_depth(double x, double y) const override;
  [[nodiscard]] Expected reciprocal_w(double x, double y) const override;
  [[nodiscard]] double reciprocal_w_error(double x, double y) const override;
  [[nodiscard]] double exact_reciprocal_w(double x, double y) const override;

  // The components that the vertices carry, in their order, for the functions below.
  void reserve(size_t components) { components_.reserve(components); }
  void add_component(const Component& component) { components_.push_back(component); }
  [[nodiscard]] const Component& component(uint32_t number) const { return components_[number]; }
  [[nodiscard]] float provoking(uint32_t component) const override { return components_[component].provoking; }
  [[nodiscard]] bool judged(uint32_t component) const override { return components_[component].judged; }
  [[nodiscard]] Expected varying_for(uint32_t component, float value, double x, double y) const override {
    return varying_for(components_[component], value, x, y);
  }
  void least_varyings(double x, double y, std::span<const uint32_t> wanted,
                      std::span<Expected> components) const override;
  [[nodiscard]] Tolerance varying_tolerance(uint32_t component, double x, double y) const override {
    return varying_tolerance(components_[component], x, y);
  }
  [[nodiscard]] double varying_error(uint32_t component, double x, double y) const override {
    return varying_error(components_[component], x, y);
  }
  [[nodiscard]] double exact_varying(uint32_t component, double x, double y) const override;

  // The same for a row of samples at (x + i, y), i from 0: exact values, and for each a tolerance that is no more
  // than the one that varying() and depth() would give (the spread left aside). Cheap, for the many values that are
  // well within it.
  void depth_row(double x, double y, std::span<double> expected, std::span<double> least) const;
  // The w of the row's samples, which the rows of smooth varyings are made with.
  void w_row(double x, double y, std::span<double> w) const;
  // Not for flat varyings, nor those that are not judged.
  void varying_row(const Component& component, double x, double y, std::span<const double> w,
                   std::span<double> expected, std::span<double> least) const;

  // The range of depths within the triangle, widened by the largest tolerance there. All w must be positive.
  [[nodiscard]] DepthRange depth_range() const;

  [[nodiscard]] const Triangle& triangle() const { return *triangle_; }

 private:
  [[nodiscard]] double barycentric_size(double dx, double dy) const;
  void set_largest_depth_tolerance();
  [[nodiscard]] PolygonDepth polygon_depth() const;
  [[nodiscard]] double form_error(const LinearForm& form, double dx, double dy) const;
  [[nodiscard]] Tolerance linear_tolerance(const WindowLinear& quantity, double dx, double dy) const;
  // A lower bound of the tolerance of a quantity that is linear in the window: A >= 1.
  [[nodiscard]] double least_linear(const WindowLinear& quantity) const;
  [[nodiscard]] double least_smooth(const Component& component, double value) const;
  [[nodiscard]] Tolerance smooth_tolerance(const Component& component, double value, double dx, double dy) const;

  const Triangle* triangle_;
  Latitude latitude_;
  Projection projection_;
  WindowLinear depth_;
  WindowLinear reciprocal_w_;
  std::array<LinearForm, 3> barycentric_;  // of the window
  BiasRange bias_;
  double largest_depth_tolerance_ = 0;  // within the triangle; infinite where a vertex is not in front of the eye
  std::vector<Component> components_;
};

}  // namespace fillrule::exact
