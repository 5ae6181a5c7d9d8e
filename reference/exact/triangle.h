// One triangle of the oracle: which samples it must, may and must not cover, and the exact values there.
//
// Nothing is clipped and nothing is divided by w. With v_i = (X_i, Y_i, w_i) the vertices in homogeneous framebuffer
// coordinates, relative to the viewport's centre, and p = (dx, dy, 1) a sample, the edge functions
// E_i(p) = det(p, v_j, v_k) and D = det(v_0, v_1, v_2) give the weights l_i = E_i / D with p = sum l_i v_i. The
// sample is inside the triangle, and in front of the eye, if all l_i >= 0; its clip-space z, scaled so that w = 1, is
// sum l_i z_i, so the near and far planes are linear functions of the position like the edges. That holds for any
// sign of w (Olano and Greer, "Triangle Scan Conversion using 2D Homogeneous Coordinates", 1997).
//
// Arithmetic is filtered: doubles with a certain error bound (linear_form.h) decide where they can, rationals
// (rational_triangle.h) where they cannot.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cases/model/case.h"
#include "reference/exact/latitude.h"
#include "reference/exact/linear_form.h"
#include "reference/exact/shape.h"
#include "reference/exact/window_linear.h"

namespace fillrule::exact {

// What a primitive is clipped to besides the viewport.
struct ClipVolume {
  bool depth_clip = true;            // to the near and far planes
  bool negative_one_to_one = false;  // -w <= z instead of 0 <= z
  // User clip distances: for each plane the vertices' values. At most kMaxClipAndCullDistances.
  std::vector<std::array<float, 3>> distances;
};

class Triangle final : public Shape {
 public:
  Triangle(const std::array<ClipPosition, 3>& vertices, const VkViewport& viewport, ClipVolume volume = {});

  [[nodiscard]] bool undefined() const override { return undefined_; }
  [[nodiscard]] bool inside_volume() const override { return inside_volume_; }

  // True if every vertex is in front of the eye, w > 0.
  [[nodiscard]] bool in_front() const { return in_front_; }

  // The sign of D: 1 is clockwise in framebuffer coordinates (y down), -1 counter-clockwise, 0 no area.
  [[nodiscard]] int orientation() const { return orientation_; }

  // True if the area is so small that moving the vertices within the latitude may turn the triangle over.
  [[nodiscard]] bool orientation_in_doubt(const Latitude& latitude) const;

  // True if the triangle's smallest height is at most `width` pixels: its values are then undefined ground. Always
  // false where a vertex is not in front of the eye.
  [[nodiscard]] bool thinner_than(double width) const;

  [[nodiscard]] Classification classify(double x, double y, const Latitude& latitude,
                                        DoubtBits undecided = kEveryBoundary) const override;
  [[nodiscard]] BlockClassification classify_block(const Block& block, const Latitude& latitude,
                                                   DoubtBits undecided = kEveryBoundary) const override;
  [[nodiscard]] bool owns(double x, double y) const override;
  [[nodiscard]] bool on_grid(uint32_t subpixel_bits) const override;
  [[nodiscard]] std::array<double, 4> bounds(const Latitude& latitude) const override;
  [[nodiscard]] std::vector<Position> part_in(const Block& block, const Latitude& latitude) const override;

  // Linear in the window, in double: sum l_i q_i for the given q. Not defined where orientation() is 0.
  [[nodiscard]] LinearForm interpolant(std::span<const double, 3> q) const;

  [[nodiscard]] const std::array<ClipPosition, 3>& vertices() const { return vertices_; }
  [[nodiscard]] const VkViewport& viewport() const { return viewport_; }
  [[nodiscard]] const ClipVolume& volume() const { return volume_; }
  // How far vertex i is inside of the near plane.
  [[nodiscard]] double near_distance(size_t vertex) const;
  // The viewport transform of z: depth = z / w * scale + offset.
  [[nodiscard]] double depth_scale() const;
  [[nodiscard]] double depth_offset() const;
  // Not for undefined triangles.
  [[nodiscard]] Projection projection() const;
  // Vertices in homogeneous framebuffer coordinates relative to the viewport's centre.
  [[nodiscard]] double u(size_t vertex) const { return u_[vertex]; }
  [[nodiscard]] double v(size_t vertex) const { return v_[vertex]; }
  [[nodiscard]] double w(size_t vertex) const { return double{vertices_[vertex][3]}; }
  [[nodiscard]] double centre_x() const { return centre_x_; }
  [[nodiscard]] double centre_y() const { return centre_y_; }
  // The edge opposite of vertex i, positive inside.
  [[nodiscard]] const LinearForm& edge(size_t i) const { return edges_[i]; }

  // The near and the far plane, positive inside; null where the triangle has nothing to be clipped to it.
  [[nodiscard]] const LinearForm* near_plane() const { return needs_near_ ? &near_ : nullptr; }
  [[nodiscard]] const LinearForm* far_plane() const { return needs_far_ ? &far_ : nullptr; }

  // The corners of what clipping leaves of the triangle inside the viewport, grown by the latitude; framebuffer
  // coordinates. Empty where nothing is left.
  [[nodiscard]] std::vector<Position> visible_part(const Latitude& latitude) const;

  // A user clip plane that some vertex is outside of.
  struct ClipPlane {
    uint32_t number = 0;    // of the clip distance
    LinearForm form;        // positive inside
    WindowLinear quantity;  // the distance divided by w
  };
  [[nodiscard]] const std::vector<ClipPlane>& clip_planes() const { return clip_planes_; }
  // How far rounding may move the plane, in units of its form, at (dx, dy) pixels from the viewport's centre.
  [[nodiscard]] double clip_reach(const ClipPlane& plane, double dx, double dy, const Latitude& latitude) const;

 private:
  [[nodiscard]] bool has_equal_vertices() const;
  void set_up_edges();
  void set_up_planes();
  void set_up_clip_planes();
  void set_up_bounds();
  [[nodiscard]] Classification classify_without_area(double x, double y, const Latitude& latitude) const;
  [[nodiscard]] Coverage classify_against(const LinearForm& form, double dx, double dy, const Latitude& latitude,
                                          int exact_form) const;
  [[nodiscard]] Coverage classify_against(const ClipPlane& plane, double dx, double dy,
                                          const Latitude& latitude) const;
  [[nodiscard]] Coverage classify_viewport(double x, double y, const Latitude& latitude) const;
  [[nodiscard]] int side_of(int edge_number, double dx, double dy) const;
  [[nodiscard]] bool outside_bounds(double x, double y, const Latitude& latitude) const;

  std::array<ClipPosition, 3> vertices_;
  VkViewport viewport_;
  ClipVolume volume_;
  double centre_x_ = 0;
  double centre_y_ = 0;
  bool centre_is_short_ = false;
  bool undefined_ = false;
  bool inside_volume_ = true;
  bool in_front_ = true;
  bool outside_ = false;  // all vertices outside of one plane: no implementation draws it
  bool needs_near_ = false;
  bool needs_far_ = false;
  int orientation_ = 0;
  double determinant_ = 0;  // |D|
  std::array<double, 3> u_{};
  std::array<double, 3> v_{};
  std::array<LinearForm, 3> edges_{};  // times the sign of D
  LinearForm near_;
  LinearForm far_;
  std::vector<ClipPlane> clip_planes_;
  // Of the projected vertices, relative to the centre; only where in_front().
  double min_dx_ = 0;
  double min_dy_ = 0;
  double max_dx_ = 0;
  double max_dy_ = 0;
};

}  // namespace fillrule::exact
