#include "reference/exact/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/exact/assembly.h"
#include "reference/exact/bresenham.h"
#include "reference/exact/clip_edges.h"
#include "reference/exact/line.h"
#include "reference/exact/line_values.h"
#include "reference/exact/point.h"
#include "reference/exact/point_values.h"
#include "reference/exact/value_bound.h"

namespace fillrule::exact {
namespace {

std::span<const float> clip_distances_of(const Draw& draw, uint32_t vertex) {
  const size_t count = draw.clip_distance_count;
  return std::span(draw.clip_distances).subspan(size_t{vertex} * count, count);
}

float point_size_of(const Draw& draw, uint32_t vertex) {
  return draw.point_sizes.empty() ? 1 : draw.point_sizes[vertex];
}

void make_line(Piece& piece, const Draw& draw, uint32_t a, uint32_t b) {
  const Segment segment({draw.positions[a], draw.positions[b]},
                        {clip_distances_of(draw, a), clip_distances_of(draw, b)}, draw.state);
  piece.vertices = {a, b, b};
  const bool bresenham = draw.state.line_mode == VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT;
  piece.kind = bresenham ? Piece::Kind::kBresenhamLine : Piece::Kind::kLine;
  const bool visible = !segment.undefined() && segment.unbounded();
  piece.thin = !visible || segment.moves(piece.latitude).any_direction;
  if (bresenham) {
    piece.shape = std::make_unique<BresenhamLine>(segment, draw.state.line_width);
  } else {
    piece.shape = std::make_unique<Line>(segment, draw.state.line_width);
  }
}

void make_point(Piece& piece, const Draw& draw, uint32_t vertex, const SizeRange& size) {
  auto point = std::make_unique<Point>(draw.positions[vertex], size, clip_distances_of(draw, vertex), draw.state);
  piece.vertices = {vertex, vertex, vertex};
  piece.kind = Piece::Kind::kPoint;
  piece.thin = !point->inside_volume();
  piece.shape = std::move(point);
}

// A polygon's corners may be points of size 1, whatever the vertex says (polygonModePointSize).
SizeRange corner_size(const Draw& draw, uint32_t vertex) {
  const SizeRange size = point_size_range(point_size_of(draw, vertex));
  return {.least = std::min(size.least, 1.0), .most = std::max(size.most, 1.0)};
}

// What a polygon's pieces have in common.
Piece part_of(const Piece& polygon) {
  Piece part;
  part.owner = polygon.owner;
  part.draw = polygon.draw;
  part.provoking = polygon.provoking;
  part.latitude = polygon.latitude;
  part.front_facing = polygon.front_facing;
  part.facing_in_doubt = polygon.facing_in_doubt;
  part.culled = polygon.culled;
  part.of_polygon = true;
  part.polygon = polygon.vertices;
  return part;
}

double outline_reach(const Draw& draw, const Piece& polygon) {
  if (draw.state.polygon_mode == VK_POLYGON_MODE_LINE) {
    // A Bresenham line's fragments may be two pixels away besides.
    const double more = draw.state.line_mode == VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT ? 2 : 0;
    return std::min(line_width_range(draw.state.line_width).most, double{kMaxTargetSize}) / 2 + more;
  }
  double most = 1;
  for (const uint32_t vertex : polygon.vertices) most = std::max(most, corner_size(draw, vertex).most);
  return std::min(most, double{kMaxTargetSize}) / 2;
}

// Edges and corners have the bias of their polygon.
BiasRange polygon_bias(const Case& test_case, const Piece& part) {
  const Draw& draw = test_case.draws[part.draw];
  const Triangle polygon = triangle_of(draw, part.polygon);
  if (polygon.undefined() || polygon.orientation() == 0) {
    return {.tolerance = std::numeric_limits<double>::infinity()};
  }
  TriangleValues values(polygon, part.latitude);
  values.set_depth_bias(*draw.state.depth_bias, test_case.target.depth_format);
  return values.depth_bias();
}

// The planes of the clip volume that cut the polygon.
uint32_t cutting_planes(const Draw& draw, const Piece& polygon) {
  const RasterState& state = draw.state;
  const auto cuts = [&](const auto& is_outside) {
    return std::any_of(polygon.vertices.begin(), polygon.vertices.end(), is_outside) ? 1U : 0U;
  };
  uint32_t count = 0;
  for (const size_t axis : {size_t{0}, size_t{1}}) {
    count += cuts([&](uint32_t v) { return draw.positions[v][axis] > draw.positions[v][3]; });
    count += cuts([&](uint32_t v) { return draw.positions[v][axis] < -draw.positions[v][3]; });
  }
  if (state.depth_clip) {
    count += cuts([&](uint32_t v) { return draw.positions[v][2] > draw.positions[v][3]; });
    count += cuts(
        [&](uint32_t v) { return draw.positions[v][2] < (state.negative_one_to_one ? -draw.positions[v][3] : 0); });
  }
  for (size_t i = 0; i < draw.clip_distance_count; ++i) {
    count += cuts([&](uint32_t v) { return clip_distances_of(draw, v)[i] < 0; });
  }
  return count;
}

}  // namespace

std::vector<Piece> line_and_point_pieces(const Draw& draw, uint32_t draw_number, uint32_t first_primitive,
                                         const Latitude& latitude) {
  const auto vertex = [&draw](uint32_t element) { return vertex_of_element(draw, element); };
  const bool is_point = draw.topology == VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
  const uint32_t step = draw.topology == VK_PRIMITIVE_TOPOLOGY_LINE_LIST ? 2 : 1;
  const bool last_provokes = draw.state.provoking_vertex == VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
  std::vector<Piece> pieces;
  for (const ElementRun& run : element_runs(draw)) {
    for (uint32_t i = 0; i < primitives_in_run(draw.topology, run.count); ++i) {
      const uint32_t a = vertex(run.first + i * step);
      const uint32_t b = is_point ? a : vertex(run.first + i * step + 1);
      const std::array<uint32_t, 2> ends{a, b};
      Piece piece;
      piece.owner = first_primitive + static_cast<uint32_t>(pieces.size());
      piece.draw = draw_number;
      piece.provoking = last_provokes ? b : a;
      piece.latitude = latitude;
      piece.front_facing = true;
      const CullDistances distances = cull_distances_of(draw, ends);
      piece.culled = distances == CullDistances::kDrop;
      piece.open = distances == CullDistances::kEither;
      if (is_point) {
        make_point(piece, draw, a, point_size_range(point_size_of(draw, a)));
      } else {
        make_line(piece, draw, a, b);
      }
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

std::vector<Piece> outline_of(const Draw& draw, const Piece& polygon) {
  const Triangle& triangle = *polygon.triangle();
  std::vector<Piece> pieces;
  for (size_t i = 0; i < 3; ++i) {
    Piece piece = part_of(polygon);
    // A polygon that may round to nothing, or that is undefined, may be dropped; and what may be culled.
    const bool may_be_culled = polygon.facing_in_doubt && draw.state.cull_mode != VK_CULL_MODE_NONE;
    piece.open = polygon.open || triangle.undefined() || may_be_culled ||
                 (triangle.in_front() && polygon.facing_in_doubt) || triangle.orientation() == 0;
    if (draw.state.polygon_mode == VK_POLYGON_MODE_LINE) {
      make_line(piece, draw, polygon.vertices[i], polygon.vertices[(i + 1) % 3]);
    } else {
      make_point(piece, draw, polygon.vertices[i], corner_size(draw, polygon.vertices[i]));
    }
    pieces.push_back(std::move(piece));
  }
  // Each plane that cuts adds at most an edge and two corners, all of which may be drawn over each other.
  const uint32_t added = cutting_planes(draw, polygon) * (draw.state.polygon_mode == VK_POLYGON_MODE_POINT ? 2 : 1);
  for (uint32_t i = 0; i < added; ++i) {
    Piece piece = part_of(polygon);
    piece.vertices = polygon.vertices;
    piece.kind = Piece::Kind::kClipEdges;
    piece.thin = true;
    piece.shape = std::make_unique<ClipEdges>(triangle, outline_reach(draw, polygon));
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::unique_ptr<PieceValues> outline_values(const Case& test_case, const Piece& piece) {
  const Draw& draw = test_case.draws[piece.draw];
  const uint32_t stride = vertex_component_count(test_case.varyings);
  const auto value = [&](uint32_t vertex, uint32_t component) {
    return draw.varyings[size_t{vertex} * stride + component];
  };
  std::unique_ptr<LineValues> line;
  std::unique_ptr<PointValues> point;
  if (piece.kind == Piece::Kind::kPoint) {
    point = std::make_unique<PointValues>(static_cast<const Point&>(*piece.shape), piece.latitude,
                                          draw.state.negative_one_to_one);
  } else if (piece.kind == Piece::Kind::kLine) {
    line = std::make_unique<LineValues>(static_cast<const Line&>(*piece.shape).segment(), piece.latitude,
                                        LineValues::Rule::kProjected);
  } else {
    const auto& shape = static_cast<const BresenhamLine&>(*piece.shape);
    line = std::make_unique<LineValues>(
        shape.segment(), piece.latitude,
        shape.width() > 1 ? LineValues::Rule::kWideBresenham : LineValues::Rule::kBresenham);
  }
  if (draw.state.depth_bias) {
    const BiasRange bias = piece.of_polygon
                               ? polygon_bias(test_case, piece)
                               : optional_bias_range(*draw.state.depth_bias, test_case.target.depth_format,
                                                     point ? point->depths() : line->depths());
    if (point) {
      point->set_depth_bias(bias);
    } else {
      line->set_depth_bias(bias);
    }
  }
  uint32_t component = 0;
  for (const Varying& varying : test_case.varyings) {
    if (varying.source != VaryingSource::kVertices) continue;
    for (uint32_t c = 0; c < varying.components; ++c, ++component) {
      // A polygon's corner has its own varyings, but for flat ones.
      const bool flat = varying.interpolation == Interpolation::kFlat;
      const float provoking = value(piece.provoking, component);
      if (point) point->add_component(flat ? provoking : value(piece.vertices[0], component));
      if (line) {
        line->add_component(varying.interpolation,
                            {value(piece.vertices[0], component), value(piece.vertices[1], component)}, provoking);
      }
    }
  }
  if (point) return point;
  return line;
}

}  // namespace fillrule::exact
