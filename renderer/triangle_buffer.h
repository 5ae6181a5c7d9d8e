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

// As many triangles as there are lanes on their way to their planes.
template <typename L>
class LaneTriangleBuffer {
 public:
  // Of a whole triangle the outline is its vertices.
  [[gnu::always_inline]] void put(uint32_t lane, const SetupPrimitive& primitive,
                                  std::span<const FixedPosition> outline,
                                  std::span<const ClipPosition> positions_clip) {
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
    depth_transform_ = depth_transform(state);
    const LaneAnchors anchors = plane_anchors(draw);
    L::store(anchors.x, anchor_x_.data());
    L::store(anchors.y, anchor_y_.data());
    LaneTriangles<L> triangles{.anchor_x = L::to_double(anchors.x), .anchor_y = L::to_double(anchors.y)};
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      const auto components = L::load_components(positions_clip_[vertex].front().data());
      for (size_t i = 0; i < 4; ++i) {
        triangles.positions_clip[vertex][i] = L::to_double(components[i]);
      }
    }
    const LanePlanes<L> planes = triangle_planes<L>(state.viewport, depth_transform_, triangles);
    for (size_t coefficient = 0; coefficient < 3; ++coefficient) {
      for (size_t vertex = 0; vertex < 3; ++vertex) {
        L::store(planes.per_w[vertex][coefficient], planes_[vertex][coefficient].data());
      }
      L::store(planes.depth_framebuffer[coefficient], planes_[3][coefficient].data());
    }
    L::store(planes.determinant, determinant_.data());
    L::store(planes.rounding, rounding_.data());
  }

  [[gnu::always_inline]] void get(uint32_t lane, PrimitiveInterpolation& interpolation) const {
    interpolation.anchor_x = anchor_x_[lane];
    interpolation.anchor_y = anchor_y_[lane];
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      interpolation.per_w[vertex] = plane(planes_[vertex], lane);
      interpolation.w[vertex] = positions_clip_[vertex][lane][3];
    }
    interpolation.depth_framebuffer = plane(planes_[3], lane);
    if (std::abs(determinant_[lane]) <= rounding_[lane]) {
      interpolation = constant(lane);
    }
  }

 private:
  using Int = typename L::Int;
  using Values = std::array<double, L::kWidth>;  // lane by lane

  struct LaneAnchors {
    Int x;
    Int y;
  };

  // As plane_anchor().
  [[nodiscard, gnu::always_inline]] LaneAnchors plane_anchors(const PreparedDraw& draw) const {
    const auto [x0, y0] = L::load_pairs(&corners_[0].front().x_fixed);
    const auto [x1, y1] = L::load_pairs(&corners_[1].front().x_fixed);
    const auto [x2, y2] = L::load_pairs(&corners_[2].front().x_fixed);
    const auto anchor = [&](const Int& a, const Int& b, const Int& c, int32_t least, int32_t greatest)
        __attribute__((always_inline)) {
      const Int of_two = a < b ? a : b;
      const Int pixel = (of_two < c ? of_two : c) >> static_cast<int32_t>(draw.subpixel_bits);
      const Int not_less = pixel < least ? least + Int{} : pixel;
      return not_less > greatest ? greatest + Int{} : not_less;
    };
    const PixelRect& limits = draw.viewport_pixels;
    return {anchor(x0, x1, x2, limits.left, limits.right), anchor(y0, y1, y2, limits.top, limits.bottom)};
  }

  static WindowPlane plane(const std::array<Values, 3>& coefficients, uint32_t lane) {
    return {.at_anchor = coefficients[2][lane], .step_x = coefficients[0][lane], .step_y = coefficients[1][lane]};
  }

  [[nodiscard, gnu::noinline]] PrimitiveInterpolation constant(uint32_t lane) const {
    return make_constant_interpolation(depth_transform_,
                                       {positions_clip_[0][lane], positions_clip_[1][lane], positions_clip_[2][lane]},
                                       anchor_x_[lane], anchor_y_[lane]);
  }

  DepthTransform depth_transform_;
  std::array<std::array<ClipPosition, L::kWidth>, 3> positions_clip_;
  std::array<std::array<FixedPosition, L::kWidth>, 3> corners_;
  std::array<int32_t, L::kWidth> anchor_x_;
  std::array<int32_t, L::kWidth> anchor_y_;
  std::array<std::array<Values, 3>, 4> planes_;  // of the three vertices, and of the depth
  Values determinant_;
  Values rounding_;
};

}  // namespace fillrule::renderer::internal
