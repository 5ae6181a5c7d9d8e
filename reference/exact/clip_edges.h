// What clipping may add to a polygon that is drawn as lines or points: the clipped polygon's edges along the planes
// of the clip volume, and its corners there. The specification rasterizes the edges and vertices of the polygon as it
// leaves clipping, but an implementation need not clip where the result of filling is the same; so nothing must be
// drawn there, and everything within the line's or point's reach of a plane and of the polygon may.
#pragma once

#include <utility>

#include "reference/exact/triangle.h"

namespace fillrule::exact {

class ClipEdges final : public Shape {
 public:
  // `reach`: pixels, how far from its centre line or vertex a line or a point may cover a sample.
  ClipEdges(Triangle polygon, double reach) : polygon_(std::move(polygon)), reach_(reach) {}

  [[nodiscard]] bool undefined() const override { return polygon_.undefined(); }
  [[nodiscard]] bool inside_volume() const override { return false; }
  [[nodiscard]] Classification classify(double x, double y, const Latitude& latitude,
                                        DoubtBits undecided = kEveryBoundary) const override;
  [[nodiscard]] BlockClassification classify_block(const Block& block, const Latitude& latitude,
                                                   DoubtBits undecided = kEveryBoundary) const override;
  [[nodiscard]] std::array<double, 4> bounds(const Latitude& latitude) const override;
  [[nodiscard]] bool owns(double /*x*/, double /*y*/) const override { return false; }
  [[nodiscard]] bool on_grid(uint32_t /*subpixel_bits*/) const override { return false; }

  [[nodiscard]] const Triangle& polygon() const { return polygon_; }

 private:
  [[nodiscard]] Latitude grown(const Latitude& latitude) const {
    return {.x = latitude.x + reach_, .y = latitude.y + reach_};
  }

  Triangle polygon_;
  double reach_;
};

}  // namespace fillrule::exact
