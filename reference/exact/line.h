// A line as the specification's "strict" rectangle ("Basic Line Segment Rasterization"): width `w` centred on the
// segment, cut at right angles at its ends. Which samples it must, may and must not cover; README.md, section
// "Lines".
#pragma once

#include <array>

#include "reference/exact/latitude.h"
#include "reference/exact/segment.h"
#include "reference/exact/shape.h"

namespace fillrule::exact {

// The widths or sizes (pixels) that may stand for the one asked for.
struct SizeRange {
  double least = 0;  // every sample within it has to be covered
  double most = 0;   // infinite where the size is undefined
};

// The specification has every implementation support widths from 1 to 8, and sizes from 1 to 64 ("Required Limits");
// beyond, they are clamped to a range of its own. 0, negative numbers and NaN are undefined.
SizeRange line_width_range(float width);
SizeRange point_size_range(float size);

class Line final : public Shape {
 public:
  Line(const Segment& segment, float width);

  // Doubt is kDoubtShape, here as everywhere.
  [[nodiscard]] bool undefined() const override { return segment_.undefined(); }
  [[nodiscard]] bool inside_volume() const override { return segment_.inside_volume(); }
  [[nodiscard]] Classification classify(double x, double y, const Latitude& latitude,
                                        DoubtBits undecided = kEveryBoundary) const override;
  [[nodiscard]] BlockClassification classify_block(const Block& block, const Latitude& latitude,
                                                   DoubtBits undecided = kEveryBoundary) const override;
  [[nodiscard]] std::array<double, 4> bounds(const Latitude& latitude) const override;
  // Where the corners of the rectangle lie is a matter of rounding, whatever grid the ends are on: no tie is told.
  [[nodiscard]] bool owns(double /*x*/, double /*y*/) const override { return false; }
  [[nodiscard]] bool on_grid(uint32_t /*subpixel_bits*/) const override { return false; }

  [[nodiscard]] const Segment& segment() const { return segment_; }
  [[nodiscard]] const SizeRange& width() const { return width_; }

  // How far rounding may move the borders of the rectangle around `part`, pixels, as seen from (dx, dy) pixels from
  // the viewport's centre. Not for lines of any direction.
  struct Margins {
    double side = 0;
    double begin = 0;
    double end = 0;
  };
  [[nodiscard]] Margins margins(const SegmentPart& part, double dx, double dy, const SegmentMoves& moves) const;

 private:
  [[nodiscard]] Coverage classify_caps(const SegmentPart& part, double dx, double dy,
                                       const SegmentMoves& moves) const;
  [[nodiscard]] Coverage classify_sides(double dx, double dy, const SegmentMoves& moves) const;
  [[nodiscard]] Coverage classify_point(double dx, double dy, const Latitude& latitude,
                                        const SegmentMoves& moves) const;
  [[nodiscard]] double side_margin(const SegmentMoves& moves) const;

  Segment segment_;
  SizeRange width_;
};

// Whether the sample is in the viewport: further inside than the latitude, in between, outside.
Coverage classify_viewport(const VkViewport& viewport, double x, double y, const Latitude& latitude);

}  // namespace fillrule::exact
