#include "renderer/clip.h"

#include <cmath>

#include "renderer/double_double.h"

namespace fillrule::renderer {
namespace {

using Position = HomogeneousPosition<DoubleDouble>;

constexpr uint32_t kMadeByClipping = 3;

// kDistances is the room for the user's clip distances: few triangles that are clipped have any, or more than one.
template <size_t kDistances>
struct ClipVertex {
  Position position;
  std::array<DoubleDouble, kDistances> distances;
  uint32_t source = kMadeByClipping;  // which of the triangle's vertices it is
};

template <size_t kDistances>
struct ClipPolygon {
  std::array<ClipVertex<kDistances>, kMaxPolygonVertices> vertices;
  uint32_t count = 0;

  // A convex polygon gains one vertex a plane at most; a polygon that rounding has made concave must not gain more.
  void push(const ClipVertex<kDistances>& vertex) {
    if (count < kMaxPolygonVertices) {
      vertices[count++] = vertex;
    }
  }
};

// The planes in their one order: those of the clip volume, then the user's.
template <size_t kDistances>
class Planes {
 public:
  Planes(const WindowTransform& transform, size_t user_planes)
      : transform_(transform), end_(kClipPlanes + static_cast<uint32_t>(user_planes)) {}

  [[nodiscard]] uint32_t begin() const { return transform_.first_plane(); }
  [[nodiscard]] uint32_t end() const { return end_; }

  [[nodiscard]] DoubleDouble distance(uint32_t plane, const ClipVertex<kDistances>& vertex) const {
    if constexpr (kDistances > 0) {
      if (plane >= kClipPlanes) {
        return vertex.distances[plane - kClipPlanes];
      }
    }
    return transform_.distance(static_cast<ClipPlane>(plane), vertex.position);
  }

  // In homogeneous coordinates, where the weights need not have the sum 1: so nothing is divided, and the
  // intersection of an edge between two vertices of floats is all but exact.
  [[nodiscard]] ClipVertex<kDistances> intersect(uint32_t plane, const ClipVertex<kDistances>& inside,
                                                 const DoubleDouble& distance_inside,
                                                 const ClipVertex<kDistances>& outside,
                                                 const DoubleDouble& distance_outside) const {
    const int exponent = -std::ilogb(distance_inside.high - distance_outside.high);
    const DoubleDouble weight_inside = scaled(-distance_outside, exponent);
    const DoubleDouble weight_outside = scaled(distance_inside, exponent);
    const auto weighted = [&](const DoubleDouble& a, const DoubleDouble& b) {
      return a * weight_inside + b * weight_outside;
    };
    const Position& a = inside.position;
    const Position& b = outside.position;
    ClipVertex<kDistances> vertex{
        .position = {weighted(a.x, b.x), weighted(a.y, b.y), weighted(a.z, b.z), weighted(a.w, b.w)}};
    for (size_t i = 0; i < kDistances; ++i) {
      vertex.distances[i] = weighted(inside.distances[i], outside.distances[i]);
    }
    if (plane < kClipPlanes) {
      transform_.put_on(static_cast<ClipPlane>(plane), vertex.position);
    }
    return vertex;
  }

 private:
  const WindowTransform& transform_;
  uint32_t end_;
};

// What the plane leaves of the polygon, in `clipped`; false, and nothing is written, where it leaves all.
template <size_t kDistances>
bool clip(const Planes<kDistances>& planes, uint32_t plane, const ClipPolygon<kDistances>& polygon,
          ClipPolygon<kDistances>& clipped) {
  std::array<DoubleDouble, kMaxPolygonVertices> distances;
  bool cuts = false;
  for (uint32_t i = 0; i < polygon.count; ++i) {
    distances[i] = planes.distance(plane, polygon.vertices[i]);
    cuts = cuts || distances[i] < 0;
  }
  if (!cuts) {
    return false;
  }
  clipped.count = 0;
  for (uint32_t i = 0; i < polygon.count; ++i) {
    const uint32_t next = i + 1 == polygon.count ? 0 : i + 1;
    const auto& vertex = polygon.vertices[i];
    const auto& vertex_next = polygon.vertices[next];
    if (!(distances[i] < 0)) {
      clipped.push(vertex);
      if (distances[next] < 0) {
        clipped.push(planes.intersect(plane, vertex, distances[i], vertex_next, distances[next]));
      }
    } else if (!(distances[next] < 0)) {
      clipped.push(planes.intersect(plane, vertex_next, distances[next], vertex, distances[i]));
    }
  }
  return true;
}

template <size_t kDistances>
FixedPolygon clip_with(const WindowTransform& transform, const std::array<ClipPosition, 3>& positions_clip,
                       const std::array<WindowVertex, 3>& window_vertices, const ClipDistances& clip_distances) {
  // What is left so far, and room for what the next plane leaves of it.
  std::array<ClipPolygon<kDistances>, 2> polygons;
  size_t current = 0;
  for (uint32_t i = 0; i < 3; ++i) {
    const auto& [x, y, z, w] = positions_clip[i];
    ClipVertex<kDistances> vertex{.position = {x, y, z, w}, .source = i};
    for (size_t k = 0; k < clip_distances[i].size(); ++k) {
      vertex.distances[k] = clip_distances[i][k];
    }
    polygons[current].push(vertex);
  }
  // All planes, whichever of them the triangle's own vertices cross: an intersection may be outside of a further
  // plane by rounding, and the neighbour must decide alike.
  const Planes<kDistances> planes(transform, clip_distances[0].size());
  for (uint32_t plane = planes.begin(); plane < planes.end(); ++plane) {
    if (clip(planes, plane, polygons[current], polygons[1 - current])) {
      current = 1 - current;
    }
  }
  const ClipPolygon<kDistances>& polygon = polygons[current];
  FixedPolygon snapped;
  for (uint32_t i = 0; i < polygon.count; ++i) {
    const auto& vertex = polygon.vertices[i];
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

}  // namespace

FixedPolygon clip_triangle(const WindowTransform& transform, const std::array<ClipPosition, 3>& positions_clip,
                           const std::array<WindowVertex, 3>& window_vertices, const ClipDistances& clip_distances) {
  if (clip_distances[0].empty()) {
    return clip_with<0>(transform, positions_clip, window_vertices, clip_distances);
  }
  if (clip_distances[0].size() == 1) {
    return clip_with<1>(transform, positions_clip, window_vertices, clip_distances);
  }
  return clip_with<kMaxClipAndCullDistances>(transform, positions_clip, window_vertices, clip_distances);
}

}  // namespace fillrule::renderer
