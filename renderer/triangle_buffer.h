// From triangles that lie here and there to lanes, from which what their fragments need is made at once, and back.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "renderer/interpolation.h"
#include "renderer/shading.h"
#include "renderer/triangle_planes.h"

namespace fillrule::renderer::internal {

// As many triangles as there are lanes, and their planes.
template <typename L>
class LaneTriangleBuffer {
  using Int = typename L::Int;

 public:
  // Of a whole triangle the outline is its vertices.
  [[gnu::always_inline]] void put(uint32_t lane, const SetupPrimitive& primitive,
                                  std::span<const FixedPosition> outline,
                                  std::span<const ClipPosition> positions_clip) {
    primitives_[lane] = &primitive;
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      positions_clip_[vertex][lane] = positions_clip[primitive.indices[vertex]];
      corners_[vertex][lane] = outline[vertex];
    }
    for (size_t vertex = 3; vertex < outline.size(); ++vertex) {
      corners_[0][lane] = least_corner(corners_[0][lane], outline[vertex]);
    }
  }

  [[gnu::always_inline]] void compute(const PreparedDraw& draw) {
    const RasterState& state = draw.input.state;
    const DepthTransform depth = depth_transform(state);
    const LaneAnchors anchors = plane_anchors(draw);
    L::store(anchors.x, anchor_x_.data());
    L::store(anchors.y, anchor_y_.data());
    LaneTriangles<L> triangles{.anchor_x = L::to_double(anchors.x), .anchor_y = L::to_double(anchors.y)};
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      const auto components = L::load_components([&](uint32_t lane) __attribute__((always_inline)) {
        return positions_clip_[vertex][lane].data();
      });
      for (size_t i = 0; i < 4; ++i) {
        triangles.positions_clip[vertex][i] = L::to_double(components[i]);
      }
    }
    const LanePlanes<L> planes = triangle_planes<L>(state.viewport, depth, triangles);
    for (size_t coefficient = 0; coefficient < 3; ++coefficient) {
      for (size_t vertex = 0; vertex < 3; ++vertex) {
        L::store(planes.per_w[vertex][coefficient], planes_[vertex][coefficient].data());
      }
      L::store(planes.depth_framebuffer[coefficient], planes_[3][coefficient].data());
    }
    Values determinant;
    Values rounding;
    L::store(planes.determinant, determinant.data());
    L::store(planes.rounding, rounding.data());
    for (uint32_t lane = 0; lane < L::kWidth; ++lane) {
      if (std::abs(determinant[lane]) <= rounding[lane]) {
        make_constant(lane, depth);
      }
    }
  }

  [[gnu::always_inline]] void get(uint32_t lane, PrimitiveInterpolation& interpolation) const {
    interpolation.anchor_x = anchor_x_[lane];
    interpolation.anchor_y = anchor_y_[lane];
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      interpolation.per_w[vertex] = plane(planes_[vertex], lane);
      interpolation.w[vertex] = positions_clip_[vertex][lane][3];
    }
    interpolation.depth_framebuffer = plane(planes_[3], lane);
    interpolation.point_coord = {};
  }

  // The pixels at which the planes are anchored.
  [[nodiscard]] const std::array<int32_t, L::kWidth>& anchor_x() const { return anchor_x_; }
  [[nodiscard]] const std::array<int32_t, L::kWidth>& anchor_y() const { return anchor_y_; }

  [[nodiscard, gnu::always_inline]] WindowPlane depth_framebuffer(uint32_t lane) const {
    return plane(planes_[3], lane);
  }

  struct LaneAnchors {
    Int x;
    Int y;
  };
  // The pixels of the tile that begins at (left, top) at which planes of varyings are anchored: as set_anchor() of
  // one primitive, since what covers a pixel of the tile has its least corner before the tile's end.
  [[nodiscard, gnu::always_inline]] LaneAnchors anchors_within(int32_t left, int32_t top) const {
    return {L::greater(L::load(anchor_x_.data()), L::all(left)), L::greater(L::load(anchor_y_.data()), L::all(top))};
  }

  // What programs are given, for planes of varyings that are anchored at other pixels.
  [[nodiscard, gnu::always_inline]] PrimitiveLanes<L> shaded(const Int& anchor_x, const Int& anchor_y) const {
    const auto x = L::to_double(anchor_x - L::load(anchor_x_.data()));
    const auto y = L::to_double(anchor_y - L::load(anchor_y_.data()));
    PrimitiveLanes<L> shaded{.primitives = primitives_};
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      shaded.step_x[vertex] = L::load(planes_[vertex][0].data());
      shaded.step_y[vertex] = L::load(planes_[vertex][1].data());
      shaded.at_anchor[vertex] =
          L::load(planes_[vertex][2].data()) + shaded.step_x[vertex] * x + shaded.step_y[vertex] * y;
    }
    return shaded;
  }

 private:
  using Values = std::array<double, L::kWidth>;  // lane by lane

  // As plane_anchor().
  [[nodiscard, gnu::always_inline]] LaneAnchors plane_anchors(const PreparedDraw& draw) const {
    const auto [x0, y0] = L::load_pairs(&corners_[0].front().x_fixed);
    const auto [x1, y1] = L::load_pairs(&corners_[1].front().x_fixed);
    const auto [x2, y2] = L::load_pairs(&corners_[2].front().x_fixed);
    const auto anchor = [&](const Int& a, const Int& b, const Int& c, int32_t least, int32_t greatest)
        __attribute__((always_inline)) {
      const Int pixel = L::lesser(L::lesser(a, b), c) >> static_cast<int32_t>(draw.subpixel_bits);
      return L::lesser(L::greater(pixel, L::all(least)), L::all(greatest));
    };
    const PixelRect& limits = draw.viewport_pixels;
    return {anchor(x0, x1, x2, limits.left, limits.right), anchor(y0, y1, y2, limits.top, limits.bottom)};
  }

  static WindowPlane plane(const std::array<Values, 3>& coefficients, uint32_t lane) {
    return {.at_anchor = coefficients[2][lane], .step_x = coefficients[0][lane], .step_y = coefficients[1][lane]};
  }

  // Where plane equations mean nothing.
  [[gnu::noinline]] void make_constant(uint32_t lane, const DepthTransform& depth) {
    const PrimitiveInterpolation constant = make_constant_interpolation(
        depth, {positions_clip_[0][lane], positions_clip_[1][lane], positions_clip_[2][lane]}, anchor_x_[lane],
        anchor_y_[lane]);
    const auto set = [lane](const WindowPlane& plane, std::array<Values, 3>& coefficients) {
      coefficients[0][lane] = plane.step_x;
      coefficients[1][lane] = plane.step_y;
      coefficients[2][lane] = plane.at_anchor;
    };
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      set(constant.per_w[vertex], planes_[vertex]);
    }
    set(constant.depth_framebuffer, planes_[3]);
  }

  std::array<const SetupPrimitive*, L::kWidth> primitives_;
  std::array<std::array<ClipPosition, L::kWidth>, 3> positions_clip_;
  std::array<std::array<FixedPosition, L::kWidth>, 3> corners_;
  std::array<int32_t, L::kWidth> anchor_x_;
  std::array<int32_t, L::kWidth> anchor_y_;
  std::array<std::array<Values, 3>, 4> planes_;  // of the three vertices, and of the depth: step_x, step_y, at_anchor
};

}  // namespace fillrule::renderer::internal
