// A line by the specification's diamond-exit rule ("Bresenham Line Segment Rasterization") and the four rules that
// leave implementations some freedom; README.md, section "Bresenham lines".
//
// A line of width w is a line of width 1, moved by (w - 1) / 2 pixels against its minor axis, of which every fragment
// is replaced by w fragments side by side along that axis. The words column and row below are an x-major line's; for
// a y-major one they change places.
#pragma once

#include <array>
#include <cstdint>

#include "reference/exact/latitude.h"
#include "reference/exact/segment.h"
#include "reference/exact/shape.h"

namespace fillrule::exact {

// Over all roundings of the ends within the latitude.
struct CountRange {
  int64_t least = 0;
  int64_t most = 0;
};

class BresenhamLine final : public Shape {
 public:
  BresenhamLine(const Segment& segment, float width);

  // kMay within one pixel of a fragment that the diamond-exit rule makes, for some rounding of the ends; else
  // kMustNot. What holds for the centre of a pixel holds for all its samples. Doubt is kDoubtShape.
  [[nodiscard]] Classification classify(double x, double y, const Latitude& latitude,
                                        DoubtBits undecided = kEveryBoundary) const override;
  [[nodiscard]] BlockClassification classify_block(const Block& block, const Latitude& latitude,
                                                   DoubtBits undecided = kEveryBoundary) const override;
  [[nodiscard]] bool undefined() const override { return segment_.undefined() || undefined_width_; }
  [[nodiscard]] bool inside_volume() const override { return segment_.inside_volume(); }
  [[nodiscard]] std::array<double, 4> bounds(const Latitude& latitude) const override;

  // Whether the diamond-exit rule makes a fragment of the pixel around (x, y). Only where on_grid().
  [[nodiscard]] bool owns(double x, double y) const override;
  // ... and the line is not clipped.
  [[nodiscard]] bool on_grid(uint32_t subpixel_bits) const override;

  // The rules for the line as a whole speak of one segment of one major axis: false where it is clipped, undefined,
  // or where rounding may change the axis, the direction or the width.
  [[nodiscard]] bool has_rules(const Latitude& latitude) const;
  [[nodiscard]] bool x_major() const { return x_major_; }
  [[nodiscard]] bool ascending() const { return ascending_; }  // towards larger x (y) if x-major (y-major)
  [[nodiscard]] int64_t width() const { return width_most_; }
  // How many columns have a fragment by the diamond-exit rule.
  [[nodiscard]] CountRange columns(const Latitude& latitude) const;

  [[nodiscard]] const Segment& segment() const { return segment_; }

 private:
  struct End {
    double x = 0;  // framebuffer, pixels
    double y = 0;
  };
  [[nodiscard]] bool maybe_major(bool x_major, const Latitude& latitude) const;
  [[nodiscard]] bool near_fragment(bool x_major, double x, double y, const Latitude& latitude) const;

  Segment segment_;
  int64_t width_least_ = 1;  // pixels; they differ where the width is half way between two
  int64_t width_most_ = 1;
  bool undefined_width_ = false;
  bool x_major_ = true;
  bool ascending_ = true;
  bool bounded_ = false;  // both ends are in the window's finite part
  double slop_ = 0;       // pixels, of clipped ends
  End begin_;
  End end_;
};

}  // namespace fillrule::exact
