#include "renderer/clip.h"

#include <cmath>

#include "renderer/double_double.h"

namespace fillrule::renderer {
namespace {

using Position = HomogeneousPosition<DoubleDouble>;

constexpr uint32_t kMadeByClipping = 3;

struct ClipVertex {
  Position position;
  uint32_t source = kMadeByClipping;  // which of the triangle's vertices it is
};

struct ClipPolygon {
  std::array<ClipVertex, kMaxPolygonVertices> vertices;
  uint32_t count = 0;

  // A convex polygon gains one vertex a plane at most; a polygon that rounding has made concave must not gain more.
  void push(const ClipVertex& vertex) {
    if (count < kMaxPolygonVertices) {
      vertices[count++] = vertex;
    }
  }
};

// In homogeneous coordinates, where the weights need not have the sum 1: so nothing is divided, and the intersection
// of an edge between two vertices of floats is all but exact.
ClipVertex intersect(const WindowTransform& transform, ClipPlane plane, const Position& inside,
                     const DoubleDouble& distance_inside, const Position& outside,
                     const DoubleDouble& distance_outside) {
  const int exponent = -std::ilogb(distance_inside.high - distance_outside.high);
  const DoubleDouble weight_inside = scaled(-distance_outside, exponent);
  const DoubleDouble weight_outside = scaled(distance_inside, exponent);
  const auto weighted = [&](const DoubleDouble& a, const DoubleDouble& b) {
    return a * weight_inside + b * weight_outside;
  };
  Position position{weighted(inside.x, outside.x), weighted(inside.y, outside.y), weighted(inside.z, outside.z),
                    weighted(inside.w, outside.w)};
  transform.put_on(plane, position);
  return {.position = position};
}

ClipPolygon clip(const WindowTransform& transform, ClipPlane plane, const ClipPolygon& polygon) {
  std::array<DoubleDouble, kMaxPolygonVertices> distances;
  for (uint32_t i = 0; i < polygon.count; ++i) {
    distances[i] = transform.distance(plane, polygon.vertices[i].position);
  }
  ClipPolygon clipped;
  for (uint32_t i = 0; i < polygon.count; ++i) {
    const uint32_t next = i + 1 == polygon.count ? 0 : i + 1;
    const ClipVertex& vertex = polygon.vertices[i];
    const ClipVertex& vertex_next = polygon.vertices[next];
    if (!(distances[i] < 0)) {
      clipped.push(vertex);
      if (distances[next] < 0) {
        clipped.push(
            intersect(transform, plane, vertex.position, distances[i], vertex_next.position, distances[next]));
      }
    } else if (!(distances[next] < 0)) {
      clipped.push(intersect(transform, plane, vertex_next.position, distances[next], vertex.position, distances[i]));
    }
  }
  return clipped;
}

}  // namespace

FixedPolygon clip_triangle(const WindowTransform& transform, const std::array<ClipPosition, 3>& positions_clip,
                           const std::array<WindowVertex, 3>& window_vertices) {
  ClipPolygon polygon;
  for (uint32_t i = 0; i < 3; ++i) {
    const auto& [x, y, z, w] = positions_clip[i];
    polygon.push({.position = {x, y, z, w}, .source = i});
  }
  // All planes, whichever of them the triangle's own vertices cross: an intersection may be outside of a further
  // plane by rounding, and the neighbour must decide alike.
  for (uint32_t plane = transform.first_plane(); plane < kClipPlanes; ++plane) {
    polygon = clip(transform, static_cast<ClipPlane>(plane), polygon);
  }
  FixedPolygon snapped;
  for (uint32_t i = 0; i < polygon.count; ++i) {
    const ClipVertex& vertex = polygon.vertices[i];
    if (vertex.source != kMadeByClipping && window_vertices[vertex.source].clip_code == 0) {
      snapped.vertices[snapped.count++] = window_vertices[vertex.source].position;
    } else if (const auto& [x, y, z, w] = vertex.position; w.high > 0) {
      snapped.vertices[snapped.count++] = transform.project({x.high, y.high, z.high, w.high});
    }
    // What is inside of every plane without a positive w is the origin (0, 0, 0, 0): it is seen nowhere.
  }
  if (snapped.count < 3) {
    snapped.count = 0;
  }
  return snapped;
}

}  // namespace fillrule::renderer
