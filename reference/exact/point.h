// A point: the square of its size around the vertex ("Basic Point Rasterization"); README.md, section "Points".
#pragma once

#include <array>
#include <span>

#include "cases/model/case.h"
#include "reference/exact/latitude.h"
#include "reference/exact/line.h"
#include "reference/exact/shape.h"

namespace fillrule::exact {

class Point final : public Shape {
 public:
  // `distances` are the vertex's user clip distances.
  Point(const ClipPosition& vertex, const SizeRange& size, std::span<const float> distances,
        const RasterState& state);

  // Doubt is kDoubtShape, here as everywhere.
  [[nodiscard]] bool undefined() const override { return undefined_; }
  // False if the vertex is outside of the clip volume: nothing is drawn then.
  [[nodiscard]] bool inside_volume() const override { return !undefined_ && visible_; }
  [[nodiscard]] Classification classify(double x, double y, const Latitude& latitude,
                                        DoubtBits undecided = kEveryBoundary) const override;
  [[nodiscard]] BlockClassification classify_block(const Block& block, const Latitude& latitude,
                                                   DoubtBits undecided = kEveryBoundary) const override;
  [[nodiscard]] std::array<double, 4> bounds(const Latitude& latitude) const override;
  // Which sides of the square include a sample that they touch, no rule says.
  [[nodiscard]] bool owns(double /*x*/, double /*y*/) const override { return false; }
  [[nodiscard]] bool on_grid(uint32_t /*subpixel_bits*/) const override { return false; }

  // The vertex in the framebuffer, pixels. Not defined where the point is undefined or not visible.
  [[nodiscard]] double x() const { return x_; }
  [[nodiscard]] double y() const { return y_; }
  [[nodiscard]] const SizeRange& size() const { return size_; }
  // How far rounding may move the sides of the square, pixels.
  [[nodiscard]] Latitude margin(const Latitude& latitude) const;
  [[nodiscard]] const ClipPosition& vertex() const { return vertex_; }
  [[nodiscard]] const VkViewport& viewport() const { return viewport_; }

 private:
  ClipPosition vertex_;
  VkViewport viewport_;
  SizeRange size_;
  bool undefined_ = false;
  bool visible_ = true;
  double x_ = 0;
  double y_ = 0;
};

}  // namespace fillrule::exact
