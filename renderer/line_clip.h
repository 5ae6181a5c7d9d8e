// Clipping of line segments in homogeneous clip space (Cyrus and Beck 1978; Vulkan, "Primitive Clipping").
//
// A segment is clipped to the view volume itself, not to a guard band: the ends of a wide line show where it was cut.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "renderer/double_double.h"
#include "renderer/window_transform.h"

namespace fillrule::renderer {

// The signed distances of a segment's two ends from a plane, in any unit; negative outside.
using EndDistances = std::array<DoubleDouble, 2>;

struct SegmentEnd {
  HomogeneousPosition<double> position;
  bool is_vertex = true;  // false: made by clipping
};

struct VisibleSegment {
  SegmentEnd from;
  SegmentEnd to;
};

// The part of a segment of finite positions that is inside of all planes; nothing if none is left.
std::optional<VisibleSegment> clip_segment(const ClipPosition& from_clip, const ClipPosition& to_clip,
                                           std::span<const EndDistances> planes);

}  // namespace fillrule::renderer
