// Clipping of triangles in homogeneous clip space (Sutherland and Hodgman 1974; Vulkan, "Primitive Clipping") against
// the near and far planes, the guard band, and the half-spaces of the user's clip distances, which are linear there.
//
// Watertight: what remains of an edge depends on its two end points alone. Every plane is applied in the same order,
// and an intersection is always computed from the end inside to the end outside, so the two triangles at an edge,
// which walk it in opposite directions, get the same points to the bit.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "renderer/window_transform.h"

namespace fillrule::renderer {

// A triangle gains a vertex at most from each plane and half-space.
inline constexpr uint32_t kMaxPolygonVertices = 3 + kClipPlanes + kMaxClipAndCullDistances;

// The same number for each of a triangle's vertices.
using ClipDistances = std::array<std::span<const float>, 3>;

struct FixedPolygon {
  std::array<FixedPosition, kMaxPolygonVertices> vertices;
  uint32_t count = 0;
  [[nodiscard]] std::span<const FixedPosition> span() const { return {vertices.data(), count}; }
};

// The triangle's visible part, snapped, as a closed polygon; no vertices if nothing is left. Positions and distances
// must be finite.
FixedPolygon clip_triangle(const WindowTransform& transform, const std::array<ClipPosition, 3>& positions_clip,
                           const std::array<WindowVertex, 3>& window_vertices,
                           const ClipDistances& clip_distances = {});

}  // namespace fillrule::renderer
