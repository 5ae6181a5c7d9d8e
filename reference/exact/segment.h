// The centre line of a line primitive: where it runs in the window, and which part of it the view volume leaves.
//
// As with triangles nothing is divided by w before it has to be. With A and B the ends in homogeneous framebuffer
// coordinates (x, y, w), relative to the viewport's centre, and p = (dx, dy, 1) a sample, E(p) = det(p, A, B) is the
// distance of p from the line times the length of (E.a, E.b), and (E.b, -E.a) is the direction from A to B, for any
// signs of w.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "cases/model/case.h"
#include "reference/exact/latitude.h"
#include "reference/exact/linear_form.h"

namespace fillrule::exact {

// A clipper that computes A + t (B - A) in float32 rounds the difference, the product and the sum, for each plane
// that cuts: eight units of 2^-24 of the largest coordinate cover two planes. (An error of t itself moves along the
// segment and is of the same size.)
inline constexpr double kClipperRoundings = 8;

// One end of a part of the segment, in the window.
struct SegmentEnd {
  double along = 0;  // pixels from the viewport's centre along the direction; infinite where w reaches 0
  double x = 0;      // pixels from the viewport's centre
  double y = 0;
  double w = 0;      // of clip space
  double error = 0;  // pixels, a bound of how far doubles are from the exact place
  double slop = 0;   // pixels, how far float32 may be from it: a clipper's intersection rounds with both its ends
};

// What a set of clip planes leaves of it, `begin` nearer to the first vertex.
struct SegmentPart {
  SegmentEnd begin;
  SegmentEnd end;
  bool whole = true;  // nothing was cut off

  [[nodiscard]] double length() const { return end.along - begin.along; }
};

// How far rounding within the latitude moves what is left of the segment.
struct SegmentMoves {
  double along = 0;            // pixels, an end in the segment's direction
  double across = 0;           // pixels, at right angles to it
  double slop = 0;             // pixels, the larger one of the ends' (SegmentEnd)
  double turn = 0;             // radians
  bool any_direction = false;  // the segment is so short that it may be turned any way
};

class Segment {
 public:
  // `distances` are the two vertices' user clip distances, of equal number.
  Segment(const std::array<ClipPosition, 2>& vertices, const std::array<std::span<const float>, 2>& distances,
          const RasterState& state);

  // True where Vulkan says nothing: see Triangle::undefined().
  [[nodiscard]] bool undefined() const { return undefined_; }

  // True if both ends are at the same place of the window: there is no direction.
  [[nodiscard]] bool is_point() const { return scale_ == 0; }

  // What the whole view volume leaves, and what is left if the window's borders do not cut (their part is then cut
  // off by the viewport). Nothing if no part is inside.
  [[nodiscard]] const std::optional<SegmentPart>& clipped() const { return clipped_; }
  [[nodiscard]] const std::optional<SegmentPart>& unbounded() const { return unbounded_; }

  // Nothing is cut off by the view volume.
  [[nodiscard]] bool inside_volume() const { return clipped_ && clipped_->whole; }

  // Not for segments without any part inside.
  [[nodiscard]] SegmentMoves moves(const Latitude& latitude) const;

  // Pixels from the viewport's centre. `distance` is positive on the side of growing E.
  [[nodiscard]] double distance(double dx, double dy) const { return edge_.at(dx, dy) / scale_; }
  [[nodiscard]] double distance_error(double dx, double dy) const;
  [[nodiscard]] double along(double dx, double dy) const { return direction_x_ * dx + direction_y_ * dy; }
  [[nodiscard]] double along_error(double dx, double dy) const;

  // The length of (E.a, E.b).
  [[nodiscard]] double scale() const { return scale_; }
  // Of length one.
  [[nodiscard]] double direction_x() const { return direction_x_; }
  [[nodiscard]] double direction_y() const { return direction_y_; }

  [[nodiscard]] const std::array<ClipPosition, 2>& vertices() const { return vertices_; }
  [[nodiscard]] const VkViewport& viewport() const { return viewport_; }
  [[nodiscard]] bool negative_one_to_one() const { return negative_one_to_one_; }
  [[nodiscard]] double u(size_t vertex) const { return u_[vertex]; }
  [[nodiscard]] double v(size_t vertex) const { return v_[vertex]; }
  [[nodiscard]] double w(size_t vertex) const { return double{vertices_[vertex][3]}; }
  [[nodiscard]] double centre_x() const { return double{viewport_.x} + double{viewport_.width} / 2; }
  [[nodiscard]] double centre_y() const { return double{viewport_.y} + double{viewport_.height} / 2; }

 private:
  struct Cut;
  void clip(const std::array<std::span<const float>, 2>& distances, const RasterState& state);
  [[nodiscard]] SegmentPart part(const Cut& cut) const;
  [[nodiscard]] SegmentEnd end_at(double weight_a, double weight_b, bool is_begin) const;

  std::array<ClipPosition, 2> vertices_;
  VkViewport viewport_;
  bool negative_one_to_one_ = false;
  bool undefined_ = false;
  std::array<double, 2> u_{};
  std::array<double, 2> v_{};
  LinearForm edge_;
  double scale_ = 0;
  double direction_x_ = 0;
  double direction_y_ = 0;
  std::optional<SegmentPart> clipped_;
  std::optional<SegmentPart> unbounded_;
};

}  // namespace fillrule::exact
