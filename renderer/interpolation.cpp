#include "renderer/interpolation.h"

#include <algorithm>

#include "renderer/triangle_planes.h"

namespace fillrule::renderer {
namespace {

using Vector = std::array<double, 3>;

// (X, Y, w) with the origin of the window at the anchor's centre.
Vector window_row(const VkViewport& viewport, const ClipPosition& pos_clip, int32_t anchor_x, int32_t anchor_y) {
  const double half_width = double{viewport.width} / 2;
  const double half_height = double{viewport.height} / 2;
  const double centre_x = double{viewport.x} + half_width - (anchor_x + 0.5);
  const double centre_y = double{viewport.y} + half_height - (anchor_y + 0.5);
  const double w = pos_clip[3];
  return {half_width * double{pos_clip[0]} + centre_x * w, half_height * double{pos_clip[1]} + centre_y * w, w};
}

// One vertex everywhere: the first that can be seen.
std::array<WindowPlane, 3> constant_planes(const std::array<double, 3>& w) {
  size_t vertex = 0;
  while (vertex < 2 && w[vertex] <= 0) {
    ++vertex;
  }
  std::array<WindowPlane, 3> planes{};
  planes[vertex].at_anchor = w[vertex] > 0 ? 1 / w[vertex] : 1;
  return planes;
}

// Of z / w, to the framebuffer's depth.
WindowPlane depth_plane(const std::array<WindowPlane, 3>& per_w, const std::array<ClipPosition, 3>& positions_clip,
                        const DepthTransform& depth_transform) {
  const double z0 = positions_clip[0][2];
  const double z1 = positions_clip[1][2];
  const double z2 = positions_clip[2][2];
  const auto sum = [&](double of0, double of1, double of2) { return of0 * z0 + of1 * z1 + of2 * z2; };
  return {
      .at_anchor = sum(per_w[0].at_anchor, per_w[1].at_anchor, per_w[2].at_anchor) * depth_transform.scale +
                   depth_transform.offset,
      .step_x = sum(per_w[0].step_x, per_w[1].step_x, per_w[2].step_x) * depth_transform.scale,
      .step_y = sum(per_w[0].step_y, per_w[1].step_y, per_w[2].step_y) * depth_transform.scale,
  };
}

}  // namespace

PrimitiveInterpolation make_interpolation(const VkViewport& viewport, const DepthTransform& depth_transform,
                                          const std::array<ClipPosition, 3>& positions_clip, int32_t anchor_x,
                                          int32_t anchor_y) {
  internal::LaneTriangles<ScalarLanes> triangle{.anchor_x = static_cast<double>(anchor_x),
                                                .anchor_y = static_cast<double>(anchor_y)};
  for (size_t vertex = 0; vertex < 3; ++vertex) {
    std::copy(positions_clip[vertex].begin(), positions_clip[vertex].end(), triangle.positions_clip[vertex].begin());
  }
  const auto planes = internal::triangle_planes<ScalarLanes>(viewport, depth_transform, triangle);
  if (std::abs(planes.determinant) <= planes.rounding) {
    return make_constant_interpolation(depth_transform, positions_clip, anchor_x, anchor_y);
  }
  const auto plane = [](const internal::LaneVector<ScalarLanes>& of) {
    return WindowPlane{.at_anchor = of[2], .step_x = of[0], .step_y = of[1]};
  };
  return {.anchor_x = anchor_x,
          .anchor_y = anchor_y,
          .per_w = {plane(planes.per_w[0]), plane(planes.per_w[1]), plane(planes.per_w[2])},
          .w = {positions_clip[0][3], positions_clip[1][3], positions_clip[2][3]},
          .depth_framebuffer = plane(planes.depth_framebuffer)};
}

PrimitiveInterpolation make_constant_interpolation(const DepthTransform& depth_transform,
                                                   const std::array<ClipPosition, 3>& positions_clip,
                                                   int32_t anchor_x, int32_t anchor_y) {
  const std::array<double, 3> w{positions_clip[0][3], positions_clip[1][3], positions_clip[2][3]};
  const std::array<WindowPlane, 3> per_w = constant_planes(w);
  return {.anchor_x = anchor_x,
          .anchor_y = anchor_y,
          .per_w = per_w,
          .w = w,
          .depth_framebuffer = depth_plane(per_w, positions_clip, depth_transform)};
}

PrimitiveInterpolation make_line_interpolation(const VkViewport& viewport, const DepthTransform& depth_transform,
                                               const std::array<ClipPosition, 3>& positions_clip,
                                               const LineEnds& ends, LineParameter parameter, int32_t anchor_x,
                                               int32_t anchor_y) {
  // A vertex that is no end has no weight anywhere; nor may its w count.
  PrimitiveInterpolation interpolation{.anchor_x = anchor_x, .anchor_y = anchor_y, .w = {1, 1, 1}};
  const Vector from = window_row(viewport, positions_clip[ends.from], anchor_x, anchor_y);
  const Vector to = window_row(viewport, positions_clip[ends.to], anchor_x, anchor_y);
  interpolation.w[ends.from] = from[2];
  interpolation.w[ends.to] = to[2];
  const double dx = parameter == LineParameter::kY ? 0 : to[0] * from[2] - from[0] * to[2];
  const double dy = parameter == LineParameter::kX ? 0 : to[1] * from[2] - from[1] * to[2];
  const double length_squared = dx * dx + dy * dy;
  if (length_squared > 0) {
    const auto along = [&](const Vector& row) { return (row[0] * dx + row[1] * dy) / length_squared; };
    const double step_x = dx / length_squared;
    const double step_y = dy / length_squared;
    interpolation.per_w[ends.from] = {.at_anchor = along(to), .step_x = -to[2] * step_x, .step_y = -to[2] * step_y};
    interpolation.per_w[ends.to] = {
        .at_anchor = -along(from), .step_x = from[2] * step_x, .step_y = from[2] * step_y};
  } else {
    const uint8_t visible = from[2] > 0 ? ends.from : ends.to;
    interpolation.per_w[visible].at_anchor = 1 / interpolation.w[visible];
  }
  interpolation.depth_framebuffer = depth_plane(interpolation.per_w, positions_clip, depth_transform);
  return interpolation;
}

PrimitiveInterpolation make_point_interpolation(const VkViewport& viewport, const DepthTransform& depth_transform,
                                                const std::array<ClipPosition, 3>& positions_clip, uint32_t vertex,
                                                float size, int32_t anchor_x, int32_t anchor_y) {
  PrimitiveInterpolation interpolation{.anchor_x = anchor_x, .anchor_y = anchor_y, .w = {1, 1, 1}};
  const Vector row = window_row(viewport, positions_clip[vertex], anchor_x, anchor_y);
  interpolation.w[vertex] = row[2];
  interpolation.per_w[vertex].at_anchor = 1 / row[2];
  const double step = 1 / double{size};
  interpolation.point_coord = {{{.at_anchor = 0.5 - row[0] / row[2] * step, .step_x = step},
                                {.at_anchor = 0.5 - row[1] / row[2] * step, .step_y = step}}};
  interpolation.depth_framebuffer = depth_plane(interpolation.per_w, positions_clip, depth_transform);
  return interpolation;
}

PixelWeights PrimitiveInterpolation::constrained_weights(const std::array<double, 3>& l) const {
  std::array<double, 3> weights{};
  for (size_t i = 0; i < 3; ++i) {
    weights[i] = std::max(0.0, l[i]);
  }
  const double sum = weights[0] + weights[1] + weights[2];
  if (!(sum > 0)) {
    constexpr VertexWeights kFirst{1, 0, 0};
    return {.smooth = kFirst, .noperspective = kFirst};
  }
  const VertexWeights smooth{weights[0] / sum, weights[1] / sum, weights[2] / sum};
  if (!(w[0] > 0 && w[1] > 0 && w[2] > 0)) {
    return {.smooth = smooth, .noperspective = smooth};
  }
  for (size_t i = 0; i < 3; ++i) {
    weights[i] *= w[i];
  }
  const double sum_window = weights[0] + weights[1] + weights[2];
  return {.smooth = smooth,
          .noperspective = {weights[0] / sum_window, weights[1] / sum_window, weights[2] / sum_window}};
}

}  // namespace fillrule::renderer
