// From triangles that lie here and there to lanes, from which their planes are made at once, and back.
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
  [[gnu::always_inline]] void put(uint32_t lane, const PlaneAnchor& anchor, const std::array<uint32_t, 3>& vertices,
                                  std::span<const ClipPosition> positions_clip) {
    anchor_x_[lane] = anchor.x;
    anchor_y_[lane] = anchor.y;
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      const ClipPosition& position = positions_clip[vertices[vertex]];
      for (size_t i = 0; i < 4; ++i) {
        positions_clip_[vertex][i][lane] = position[i];
      }
    }
  }

  [[gnu::always_inline]] void compute(const VkViewport& viewport, const DepthTransform& depth_transform) {
    LaneTriangles<L> triangles{.anchor_x = L::load(anchor_x_.data()), .anchor_y = L::load(anchor_y_.data())};
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      for (size_t i = 0; i < 4; ++i) {
        triangles.positions_clip[vertex][i] = L::load(positions_clip_[vertex][i].data());
      }
    }
    depth_transform_ = depth_transform;
    const LanePlanes<L> planes = triangle_planes<L>(viewport, depth_transform, triangles);
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
    interpolation.anchor_x = static_cast<int32_t>(anchor_x_[lane]);
    interpolation.anchor_y = static_cast<int32_t>(anchor_y_[lane]);
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      interpolation.per_w[vertex] = plane(planes_[vertex], lane);
      interpolation.w[vertex] = positions_clip_[vertex][3][lane];
    }
    interpolation.depth_framebuffer = plane(planes_[3], lane);
    if (std::abs(determinant_[lane]) <= rounding_[lane]) {
      interpolation = constant(lane);
    }
  }

 private:
  using Values = std::array<double, L::kWidth>;  // lane by lane

  static WindowPlane plane(const std::array<Values, 3>& coefficients, uint32_t lane) {
    return {.at_anchor = coefficients[2][lane], .step_x = coefficients[0][lane], .step_y = coefficients[1][lane]};
  }

  [[gnu::noinline]] PrimitiveInterpolation constant(uint32_t lane) const {
    std::array<ClipPosition, 3> positions;
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      for (size_t i = 0; i < 4; ++i) {
        positions[vertex][i] = static_cast<float>(positions_clip_[vertex][i][lane]);
      }
    }
    return make_constant_interpolation(depth_transform_, positions, static_cast<int32_t>(anchor_x_[lane]),
                                       static_cast<int32_t>(anchor_y_[lane]));
  }

  DepthTransform depth_transform_;
  std::array<std::array<Values, 4>, 3> positions_clip_;
  Values anchor_x_;
  Values anchor_y_;
  std::array<std::array<Values, 3>, 4> planes_;  // of the three vertices, and of the depth
  Values determinant_;
  Values rounding_;
};

}  // namespace fillrule::renderer::internal
