#include "renderer/line_clip.h"

namespace fillrule::renderer {
namespace {

// A point of the segment, (from * weight_from + to * weight_to) up to a positive factor: so nothing is divided.
struct Point {
  DoubleDouble weight_from;
  DoubleDouble weight_to;
};

constexpr Point kFrom{1, 0};
constexpr Point kTo{0, 1};

bool is_before(const Point& a, const Point& b) {
  return a.weight_to * b.weight_from - b.weight_to * a.weight_from < 0;
}

SegmentEnd end_at(const Point& point, const ClipPosition& from_clip, const ClipPosition& to_clip) {
  const auto weighted = [&](size_t i) {
    return (point.weight_from * from_clip[i] + point.weight_to * to_clip[i]).high;
  };
  return {.position = {weighted(0), weighted(1), weighted(2), weighted(3)}, .is_vertex = false};
}

SegmentEnd vertex(const ClipPosition& position_clip) {
  const auto& [x, y, z, w] = position_clip;
  return {.position = {x, y, z, w}};
}

}  // namespace

std::optional<VisibleSegment> clip_segment(const ClipPosition& from_clip, const ClipPosition& to_clip,
                                           std::span<const EndDistances> planes) {
  Point first = kFrom;
  Point last = kTo;
  for (const auto& [distance_from, distance_to] : planes) {
    if (distance_from < 0 && distance_to < 0) {
      return std::nullopt;
    }
    if (distance_from < 0) {
      const Point entry{distance_to, -distance_from};
      first = is_before(first, entry) ? entry : first;
    } else if (distance_to < 0) {
      const Point exit{-distance_to, distance_from};
      last = is_before(exit, last) ? exit : last;
    }
  }
  if (!is_before(first, last)) {
    return std::nullopt;
  }
  const VisibleSegment visible{is_before(kFrom, first) ? end_at(first, from_clip, to_clip) : vertex(from_clip),
                               is_before(last, kTo) ? end_at(last, from_clip, to_clip) : vertex(to_clip)};
  // Inside of every plane without a positive w is the origin (0, 0, 0, 0) alone: it is seen nowhere.
  if (!(visible.from.position.w > 0 && visible.to.position.w > 0)) {
    return std::nullopt;
  }
  return visible;
}

}  // namespace fillrule::renderer
