// Setup of lines and points: of their own topologies, or the edges and corners of polygons that are drawn so (Vulkan,
// "Line Segments", "Points", "Polygon Mode").
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/primitive_setup.h"

namespace fillrule::renderer {

// Nothing if the line covers no sample for sure: clipped away, not finite, without length or outside of
// clip_pixels. Appends the outline, of a Bresenham line its two ends, to `polygon_vertices`.
std::optional<SetupPrimitive> setup_line(const SetupState& state, const AssembledPrimitive& primitive,
                                         const LineEnds& ends, std::vector<FixedPosition>& polygon_vertices);

// Nothing if the vertex is clipped away or not finite, or the point outside of clip_pixels.
std::optional<SetupPrimitive> setup_point(const SetupState& state, const AssembledPrimitive& primitive,
                                          uint8_t vertex, float point_size,
                                          std::vector<FixedPosition>& polygon_vertices);

}  // namespace fillrule::renderer
