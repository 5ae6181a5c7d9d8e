// The pieces of what is not filled: lines, points, and the edges and corners of polygons that are drawn as lines or
// points (Vulkan specification, "Primitive Topologies", "Polygon Mode").
#pragma once

#include <vector>

#include "reference/exact/expectation.h"

namespace fillrule::exact {

// The lines or points of a draw that has such a topology, in submission order; `first_primitive` is the number of the
// first one, `draw_number` that of the draw.
std::vector<Piece> line_and_point_pieces(const Draw& draw, uint32_t draw_number, uint32_t first_primitive,
                                         const Latitude& latitude);

// The edges or corners of a polygon, and, where it has to be clipped, what clipping may make of it. Its facing and
// culling are theirs.
std::vector<Piece> outline_of(const Draw& draw, const Piece& polygon);

// The exact values of a line or a point; as values_of().
std::unique_ptr<PieceValues> outline_values(const Case& test_case, const Piece& piece);

}  // namespace fillrule::exact
