#include "harness/faults/clip.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace fillrule::faults {
namespace {

// The planes of the view volume; user clip plane i is kFirstUser + i.
enum Plane : uint32_t { kNear, kFar, kLeft, kRight, kTop, kBottom, kSmallW, kFirstUser };

// How far inside of the plane, in units of no matter.
Wide distance(const Context& context, uint32_t plane, const Corner& corner) {
  const auto& [x, y, z, w] = corner.position;
  switch (plane) {
    case kNear:
      return context.minus_one_to_one() || context.has(Fault::kGlDepthVolume) ? w + z : z;
    case kFar:
      return w - z;
    case kLeft:
      return w + x;
    case kRight:
      return w - x;
    case kTop:
      return w + y;
    case kBottom:
      return w - y;
    case kSmallW:
      return w - Wide{1e-4};
    default: {
      const Wide user = corner.distances[plane - kFirstUser];
      return context.has(Fault::kUserClipAffine) && w > 0 ? user * w : user;
    }
  }
}

// Those who rasterize whatever fits into their numbers do not clip at the sides what is in front of the eye.
bool clips_at_sides(const Context& context, std::span<const Corner> corners) {
  const bool has_guard_band = context.has(Fault::kSpillsOverViewport) || context.has(Fault::kFixedPointOverflow) ||
                              context.has(Fault::kGuardBandClamps) || context.has(Fault::kCullRangeTooSmall) ||
                              context.has(Fault::kEdgesIn32Bits) || context.has(Fault::kColumnBeyondTarget);
  return !has_guard_band || std::ranges::any_of(corners, [](const Corner& one) { return !(one.position[3] > 0); });
}

std::vector<uint32_t> planes_of(const Context& context, std::span<const Corner> corners) {
  std::vector<uint32_t> planes;
  if (context.depth_clip() && !context.has(Fault::kNoNearClip)) planes.push_back(kNear);
  if (context.depth_clip() && !context.has(Fault::kNoFarClip)) planes.push_back(kFar);
  if (clips_at_sides(context, corners)) {
    for (const Plane plane : {kLeft, kRight, kTop, kBottom}) {
      const bool negative = plane == kLeft || plane == kTop;
      if (!(negative && context.has(Fault::kNegativeSideKept))) planes.push_back(plane);
    }
  }
  if (context.has(Fault::kSmallWCutOff)) planes.push_back(kSmallW);
  for (uint32_t i = 0; i < context.draw.clip_distance_count; ++i) {
    if (!context.has(Fault::kUserClipIgnored)) planes.push_back(kFirstUser + i);
  }
  return planes;
}

// Where the edge from `inside` to `outside` meets the plane; the same to the bit for both polygons that share it, and
// for both sides of the plane.
Corner cut(const Context& context, const Corner& inside, Wide in, const Corner& outside, Wide out) {
  const auto mix = [&](Wide a, Wide b) { return (in * b - out * a) / (in - out); };
  Corner corner{.is_new = true};
  for (size_t i = 0; i < 4; ++i) corner.position[i] = mix(inside.position[i], outside.position[i]);
  for (size_t i = 0; i < 3; ++i) corner.weights[i] = mix(inside.weights[i], outside.weights[i]);
  for (size_t i = 0; i < context.draw.clip_distance_count; ++i) {
    corner.distances[i] = mix(inside.distances[i], outside.distances[i]);
  }
  if (context.has(Fault::kClipKeepsAttributes)) corner.weights = inside.weights;
  return corner;
}

// A polygon is closed, a line is not.
std::vector<Corner> cut_at(const Context& context, uint32_t plane, const std::vector<Corner>& corners, bool closed) {
  std::vector<Corner> left;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Corner& here = corners[i];
    const Wide here_distance = distance(context, plane, here);
    if (here_distance >= 0) left.push_back(here);
    if (i + 1 == corners.size() && !closed) break;
    const Corner& next = corners[(i + 1) % corners.size()];
    const Wide next_distance = distance(context, plane, next);
    if (here_distance >= 0 && next_distance < 0) {
      left.push_back(cut(context, here, here_distance, next, next_distance));
    } else if (here_distance < 0 && next_distance >= 0) {
      left.push_back(cut(context, next, next_distance, here, here_distance));
    }
  }
  return left;
}

std::vector<Corner> corners_of(const Context& context, const Primitive& primitive) {
  const Draw& draw = context.draw;
  std::vector<Corner> corners(primitive.size);
  for (size_t i = 0; i < corners.size(); ++i) {
    const uint32_t vertex = primitive.vertices[i];
    for (size_t k = 0; k < 4; ++k) corners[i].position[k] = draw.positions[vertex][k];
    corners[i].weights[i] = 1;
    for (size_t k = 0; k < draw.clip_distance_count; ++k) {
      corners[i].distances[k] = draw.clip_distances[size_t{vertex} * draw.clip_distance_count + k];
    }
    const Wide w = corners[i].position[3];
    if (context.has(Fault::kWSignIgnored) && w < 0) corners[i].position[3] = -w;
    if (context.has(Fault::kStretchToOrigin) && w <= 0) corners[i].position = {0, 0, 0, 1};
  }
  return corners;
}

bool is_inside(const Context& context, std::span<const uint32_t> planes, const Corner& corner) {
  return std::ranges::all_of(planes, [&](uint32_t plane) { return distance(context, plane, corner) >= 0; });
}

// Whether what crosses a plane is dropped as a whole, by a rule too simple.
bool dropped_by_rule(const Context& context, std::span<const uint32_t> planes, const std::vector<Corner>& corners) {
  const auto inside = [&](const Corner& corner) { return is_inside(context, planes, corner); };
  if (context.has(Fault::kDropIfAnyOutside)) return true;
  if (context.has(Fault::kDropIfAllOutside)) return std::ranges::none_of(corners, inside);
  if (context.has(Fault::kDropIfAnyBehindEye)) {
    return std::ranges::any_of(corners, [](const Corner& corner) { return corner.position[3] <= 0; });
  }
  return false;
}

void divide_by_w(std::vector<Corner>& corners) {
  for (Corner& corner : corners) {
    const Wide w = corner.position[3];
    if (w == 0) continue;
    for (Wide& component : corner.position) component /= w;
  }
}

bool is_finite(const Context& context, const Primitive& primitive) {
  const auto finite = [](float value) { return std::isfinite(value); };
  for (uint32_t i = 0; i < primitive.size; ++i) {
    const uint32_t vertex = primitive.vertices[i];
    if (!std::ranges::all_of(context.draw.positions[vertex], finite)) return false;
    const size_t count = context.draw.clip_distance_count;
    if (!std::ranges::all_of(std::span(context.draw.clip_distances).subspan(vertex * count, count), finite)) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Corner> clip(const Context& context, const Primitive& primitive) {
  if (!is_finite(context, primitive)) return {};
  std::vector<Corner> corners = corners_of(context, primitive);
  const std::vector<uint32_t> planes = planes_of(context, corners);
  const auto inside = [&](const Corner& corner) { return is_inside(context, planes, corner); };
  if (!std::ranges::all_of(corners, inside)) {
    if (primitive.size == 1) {
      const bool kept = context.has(Fault::kPointsBeyondVolume) && corners[0].position[3] > 0;
      return kept ? corners : std::vector<Corner>{};
    }
    if (dropped_by_rule(context, planes, corners)) return {};
    const bool whole = context.has(Fault::kUnclippedIfAnyInside) && std::ranges::any_of(corners, inside);
    if (context.has(Fault::kClipAfterDivide)) divide_by_w(corners);
    const size_t before = corners.size();
    for (const uint32_t plane : planes) {
      if (!whole) corners = cut_at(context, plane, corners, primitive.size == 3);
    }
    if (context.has(Fault::kWindingAfterClip) && corners.size() > before) std::ranges::reverse(corners);
    if (context.has(Fault::kFirstPieceOnly) && corners.size() > 3) corners.resize(3);
  }
  // A vertex in the eye is nowhere in the window.
  const bool in_the_eye = std::ranges::any_of(corners, [](const Corner& one) { return one.position[3] == 0; });
  return in_the_eye || corners.size() < primitive.size ? std::vector<Corner>{} : corners;
}

bool culled_by_distances(const Context& context, const Primitive& primitive) {
  const size_t count = context.draw.cull_distance_count;
  const auto vertices = std::span(primitive.vertices).first(primitive.size);
  const auto negative = [&](uint32_t vertex, size_t i) {
    return context.draw.cull_distances[vertex * count + i] < 0;
  };
  const auto for_some_plane = [&](const auto& is_negative) {
    for (size_t i = 0; i < count; ++i) {
      if (is_negative(i)) return true;
    }
    return false;
  };
  if (context.has(Fault::kCullDistanceOfAnyVertex)) {
    return for_some_plane([&](size_t i) {
      return std::ranges::any_of(vertices, [&](uint32_t vertex) { return negative(vertex, i); });
    });
  }
  if (context.has(Fault::kCullDistanceAcrossPlanes)) {
    return std::ranges::all_of(
        vertices, [&](uint32_t vertex) { return for_some_plane([&](size_t i) { return negative(vertex, i); }); });
  }
  return for_some_plane(
      [&](size_t i) { return std::ranges::all_of(vertices, [&](uint32_t vertex) { return negative(vertex, i); }); });
}

}  // namespace fillrule::faults
