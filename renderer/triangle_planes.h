// The plane equations of triangles (interpolation.h says which), of one triangle or lane by lane of several. L is a
// lane type (lanes.h).
#pragma once

#include <array>
#include <cstdint>

#include "cases/model/case.h"
#include "renderer/depth.h"
#include "renderer/lanes.h"

namespace fillrule::renderer::internal {

// X, Y and w of a vertex, or the coefficients of a plane.
template <typename L>
using LaneVector = std::array<typename L::Double, 3>;

template <typename L>
struct LaneTriangles {
  std::array<std::array<typename L::Double, 4>, 3> positions_clip;
  typename L::Double anchor_x;  // pixels
  typename L::Double anchor_y;
};

// Planes by their steps to the right and down and by their value at the anchor.
template <typename L>
struct LanePlanes {
  std::array<LaneVector<L>, 3> per_w;
  LaneVector<L> depth_framebuffer;
  // Where `determinant` is not greater than `rounding`, either way, rounding alone decides about it: the planes mean
  // nothing.
  typename L::Double determinant;
  typename L::Double rounding;
};

template <typename L>
[[gnu::always_inline]] inline LaneVector<L> cross(const LaneVector<L>& a, const LaneVector<L>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// (X, Y, w) with the origin of the window at the anchor's centre.
template <typename L>
[[gnu::always_inline]] inline LaneVector<L> window_row(const VkViewport& viewport, const LaneTriangles<L>& triangles,
                                                       size_t vertex) {
  const auto& [x, y, z, w] = triangles.positions_clip[vertex];
  const double half_width = double{viewport.width} / 2;
  const double half_height = double{viewport.height} / 2;
  const auto centre_x = L::all(double{viewport.x} + half_width) - (triangles.anchor_x + L::all(0.5));
  const auto centre_y = L::all(double{viewport.y} + half_height) - (triangles.anchor_y + L::all(0.5));
  return {L::all(half_width) * x + centre_x * w, L::all(half_height) * y + centre_y * w, w};
}

// The sum of the determinant's absolute terms: what its rounding errors are proportional to.
template <typename L>
[[gnu::always_inline]] inline typename L::Double determinant_scale(const LaneVector<L>& a, const LaneVector<L>& b,
                                                                   const LaneVector<L>& c) {
  using Double = typename L::Double;
  const auto term = [](const Double& r, const Double& s, const Double& t, const Double& u, const Double& v)
      __attribute__((always_inline)) {
    return L::magnitude(r) * (L::magnitude(s * t) + L::magnitude(u * v));
  };
  return term(a[0], b[1], c[2], b[2], c[1]) + term(a[1], b[2], c[0], b[0], c[2]) + term(a[2], b[0], c[1], b[1], c[0]);
}

// Of z / w, to the framebuffer's depth.
template <typename L>
[[gnu::always_inline]] inline LaneVector<L> depth_plane(const std::array<LaneVector<L>, 3>& per_w,
                                                        const LaneTriangles<L>& triangles,
                                                        const DepthTransform& depth_transform) {
  const auto scaled = [&](size_t coefficient) __attribute__((always_inline)) {
    return (per_w[0][coefficient] * triangles.positions_clip[0][2] +
            per_w[1][coefficient] * triangles.positions_clip[1][2] +
            per_w[2][coefficient] * triangles.positions_clip[2][2]) *
           L::all(depth_transform.scale);
  };
  return {scaled(0), scaled(1), scaled(2) + L::all(depth_transform.offset)};
}

template <typename L>
[[gnu::always_inline]] inline LanePlanes<L> triangle_planes(const VkViewport& viewport,
                                                            const DepthTransform& depth_transform,
                                                            const LaneTriangles<L>& triangles) {
  constexpr double kMinRelativeDeterminant = 0x1p-48;
  const LaneVector<L> a = window_row<L>(viewport, triangles, 0);
  const LaneVector<L> b = window_row<L>(viewport, triangles, 1);
  const LaneVector<L> c = window_row<L>(viewport, triangles, 2);
  const std::array<LaneVector<L>, 3> adjugate{cross<L>(b, c), cross<L>(c, a), cross<L>(a, b)};
  LanePlanes<L> planes;
  planes.determinant = a[0] * adjugate[0][0] + a[1] * adjugate[0][1] + a[2] * adjugate[0][2];
  planes.rounding = L::all(kMinRelativeDeterminant) * determinant_scale<L>(a, b, c);
  for (size_t vertex = 0; vertex < 3; ++vertex) {
    for (size_t coefficient = 0; coefficient < 3; ++coefficient) {
      planes.per_w[vertex][coefficient] = adjugate[vertex][coefficient] / planes.determinant;
    }
  }
  planes.depth_framebuffer = depth_plane<L>(planes.per_w, triangles, depth_transform);
  return planes;
}

}  // namespace fillrule::renderer::internal
