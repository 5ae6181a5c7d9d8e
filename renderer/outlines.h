// The outlines of points and of rectangular lines: what coverage.h fills like a polygon (Vulkan, "Basic Point
// Rasterization", "Basic Line Segment Rasterization").
//
// Rounded as lavapipe rounds: the centre or the ends are snapped on their own and the half extents on their own, and
// what is half-way between two subpixels goes away from zero (a polygon's vertex goes to the even one). So the
// coverage is equal to its to the bit.
#pragma once

#include <array>
#include <optional>

#include "renderer/fixed_point.h"
#include "renderer/window_transform.h"

namespace fillrule::renderer {

using FixedQuad = std::array<FixedPosition, 4>;

inline constexpr float kMaxLineWidth = 255;  // pixels; as lavapipe's lineWidthRange
inline constexpr float kMinPointSize = 1;    // pixels; as lavapipe's pointSizeRange, which a size is clamped to
inline constexpr float kMaxPointSize = 255;

// The size that is drawn, within the range above. Not a number is the least.
float effective_point_size(float point_size);

// An end of a line, or a point's centre, on the subpixel grid; to the nearest, ties away from zero.
FixedPosition snapped_end(const FramebufferPosition& position, uint32_t subpixel_bits);

// The square with its centre there, the size rounded to whole subpixels.
FixedQuad point_outline(const FramebufferPosition& centre, float effective_size, uint32_t subpixel_bits);

// The rectangle of this width (pixels) around the segment: two edges parallel to it, two through its ends. Nothing
// for a segment without length.
std::optional<FixedQuad> line_outline(const FramebufferPosition& a, const FramebufferPosition& b, float width,
                                      uint32_t subpixel_bits);

}  // namespace fillrule::renderer
