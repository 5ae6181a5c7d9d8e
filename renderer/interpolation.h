// Values of a primitive at a point of the window: depth, and the weights of its vertices for smooth and noperspective
// varyings (Vulkan, "Basic Polygon Rasterization": barycentric coordinates; Olano and Greer 1997, homogeneous
// rasterization).
//
// For the original triangle, neither clipped nor snapped, with rows (X, Y, w), X/w and Y/w framebuffer coordinates in
// pixels, the adjugate of the 3x3 matrix divided by its determinant gives three functions l_i, linear in the window:
//   sum of l_i * w_i = 1                 l_i * w_i are the window barycentric coordinates (noperspective)
//   sum of l_i = 1/w                     l_i / sum are the perspective-correct ones (smooth)
//   sum of l_i * z_i = z / w             the depth, exactly linear
// No vertex needs w > 0 for that. All in double precision, anchored at a pixel centre near the triangle.
//
// A line and a point have such planes too, and so need no other code for their fragments: with t the projection onto
// the line, l = ((1 - t) / w_0, t / w_1, 0); at a point l = (1 / w_0, 0, 0). An unused vertex has w = 1.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "cases/model/case.h"
#include "renderer/depth.h"
#include "renderer/fixed_point.h"
#include "renderer/primitive_assembly.h"
#include "renderer/sample_locations.h"

namespace fillrule::renderer {

// A function that is linear in the window; x and y in pixels from the anchor.
struct WindowPlane {
  double at_anchor = 0;
  double step_x = 0;
  double step_y = 0;
  [[nodiscard]] double at(double x, double y) const { return at_anchor + step_x * x + step_y * y; }
};

// The weights of the three vertices; they add up to 1. All three are kept: of 1 less the two others, a weight much
// smaller than they are would have no correct digit.
using VertexWeights = std::array<double, 3>;

struct PixelWeights {
  VertexWeights smooth;
  VertexWeights noperspective;
};

// To float32; never infinite for a finite value.
inline float finite_float(double value) {
  const auto rounded = static_cast<float>(value);
  if (std::isinf(rounded) && std::isfinite(value)) {
    return std::copysign(std::numeric_limits<float>::max(), rounded);
  }
  return rounded;
}

// The value with these weights, rounded to float32 once. Never infinite for finite values.
inline float interpolate(float value0, float value1, float value2, const VertexWeights& weights) {
  return finite_float(weights[0] * double{value0} + weights[1] * double{value1} + weights[2] * double{value2});
}

struct PrimitiveInterpolation {
  // Inside the triangle every l_i is in [0, 1/w].
  static constexpr double kPlausible = 2;

  int32_t anchor_x = 0;  // pixels
  int32_t anchor_y = 0;
  std::array<WindowPlane, 3> per_w;          // l_i
  std::array<double, 3> w{};                 // clip space
  WindowPlane depth_framebuffer;             // before clamping and rounding
  std::array<WindowPlane, 2> point_coord{};  // gl_PointCoord of a point; else 0

  // All of these: at so much from the centre of the pixel (x, y).
  [[nodiscard]] double depth_at(int32_t x, int32_t y, const WindowOffset& from_centre = {}) const {
    return depth_framebuffer.at(x - anchor_x + from_centre.x, y - anchor_y + from_centre.y);
  }

  // Not positive beyond the horizon.
  [[nodiscard]] double reciprocal_w_at(int32_t x, int32_t y, const WindowOffset& from_centre = {}) const {
    const double x_from_anchor = x - anchor_x + from_centre.x;
    const double y_from_anchor = y - anchor_y + from_centre.y;
    return per_w[0].at(x_from_anchor, y_from_anchor) + per_w[1].at(x_from_anchor, y_from_anchor) +
           per_w[2].at(x_from_anchor, y_from_anchor);
  }

  [[nodiscard]] std::array<float, 2> point_coord_at(int32_t x, int32_t y,
                                                    const WindowOffset& from_centre = {}) const {
    const auto at = [&](const WindowPlane& plane) {
      return static_cast<float>(plane.at(x - anchor_x + from_centre.x, y - anchor_y + from_centre.y));
    };
    return {at(point_coord[0]), at(point_coord[1])};
  }

  [[nodiscard]] PixelWeights weights_at(int32_t x, int32_t y, const WindowOffset& from_centre = {}) const {
    const double x_from_anchor = x - anchor_x + from_centre.x;
    const double y_from_anchor = y - anchor_y + from_centre.y;
    const std::array<double, 3> l = {per_w[0].at(x_from_anchor, y_from_anchor),
                                     per_w[1].at(x_from_anchor, y_from_anchor),
                                     per_w[2].at(x_from_anchor, y_from_anchor)};
    const double reciprocal_w = l[0] + l[1] + l[2];
    const double greatest = std::max(std::max(std::abs(l[0]), std::abs(l[1])), std::abs(l[2]));
    if (!(greatest <= kPlausible * reciprocal_w)) {
      return constrained_weights(l);
    }
    const double w_at = 1 / reciprocal_w;
    return {.smooth = {l[0] * w_at, l[1] * w_at, l[2] * w_at},
            .noperspective = {l[0] * w[0], l[1] * w[1], l[2] * w[2]}};
  }

 private:
  // For points that snapping has moved so far out of a sliver, or beyond the horizon 1/w = 0, that extrapolated
  // weights mean nothing: the nearest weights inside the primitive.
  [[nodiscard]] PixelWeights constrained_weights(const std::array<double, 3>& l) const;
};

// `anchor` should be a pixel near the triangle. If the triangle is too thin for its plane equations to mean anything,
// its values are those of one vertex throughout.
PrimitiveInterpolation make_interpolation(const VkViewport& viewport, const DepthTransform& depth_transform,
                                          const std::array<ClipPosition, 3>& positions_clip, int32_t anchor_x,
                                          int32_t anchor_y);

// Of such a triangle: those of its first vertex that can be seen.
PrimitiveInterpolation make_constant_interpolation(const DepthTransform& depth_transform,
                                                   const std::array<ClipPosition, 3>& positions_clip,
                                                   int32_t anchor_x, int32_t anchor_y);

// What a point of a line takes its values from: the nearest point of the segment's line, or the one in the same
// column or row (of Bresenham lines, by their major direction).
enum class LineParameter : uint8_t { kProjection, kX, kY };

// Values of the segment between two of the primitive's vertices (Vulkan, "Basic Line Segment Rasterization"). With
// rows (X, Y, w) as above and the segment's direction D = w_from * (X, Y)_to - w_to * (X, Y)_from
//   l_from = ((X, Y)_to . D - w_to * p . D) / D . D        l_to = (w_from * p . D - (X, Y)_from . D) / D . D
// at the window position p: the same three sums hold, and no vertex needs w > 0. A segment without length has the
// values of its first vertex that can be seen.
PrimitiveInterpolation make_line_interpolation(const VkViewport& viewport, const DepthTransform& depth_transform,
                                               const std::array<ClipPosition, 3>& positions_clip,
                                               const LineEnds& ends, LineParameter parameter, int32_t anchor_x,
                                               int32_t anchor_y);

// Values of one of the primitive's vertices, which must have w > 0, all over a square of `size` pixels around it.
PrimitiveInterpolation make_point_interpolation(const VkViewport& viewport, const DepthTransform& depth_transform,
                                                const std::array<ClipPosition, 3>& positions_clip, uint32_t vertex,
                                                float size, int32_t anchor_x, int32_t anchor_y);

}  // namespace fillrule::renderer
