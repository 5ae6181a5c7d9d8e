// What bounds a line or a point at a sample.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/explain/internal.h"
#include "reference/exact/line.h"
#include "reference/exact/point.h"

namespace fillrule::explain {
namespace {

using exact::Piece;
using exact::Segment;
using exact::SegmentEnd;
using exact::SegmentPart;
using exact::SizeRange;

// Half of what the width or size may be more or less than the one asked for, on one side: pixels.
double half_of_range(const SizeRange& size, double asked) {
  return std::max(asked - size.least, size.most - asked) / 2;
}

Boundary boundary_at(Boundary::Kind kind, std::string name, const std::array<double, 3>& form, double dx, double dy,
                     double latitude, double scale) {
  Boundary boundary{.kind = kind, .name = std::move(name), .form = form};
  boundary.value = form[0] * dx + form[1] * dy + form[2];
  boundary.distance = boundary.value * scale;
  boundary.latitude = latitude * scale;
  boundary.answer = answer_of(boundary.distance, boundary.latitude);
  return boundary;
}

// "the end at v0", or where something of the line is cut off there "the end that clipping makes near v0".
std::string end_name(const Segment& segment, size_t vertex, const SegmentEnd& end) {
  const double w = segment.w(vertex);
  const double at = w > 0 ? segment.along(segment.u(vertex) / w, segment.v(vertex) / w) : HUGE_VAL;
  // Far more than doubles err, far less than anything is rounded to.
  const bool is_vertex = std::abs(at - end.along) <= end.error + 0x1p-20;
  return fmt::format("{} v{}", is_vertex ? "the end at" : "the clipped end near", vertex);
}

void add_rectangle(const Piece& piece, float width, double x, double y, double scale, PrimitiveFacts& facts) {
  const auto& line = static_cast<const exact::Line&>(*piece.shape);
  const Segment& segment = line.segment();
  if (!segment.unbounded() || segment.is_point()) return;
  const SegmentPart& part = segment.clipped() ? *segment.clipped() : *segment.unbounded();
  const exact::SegmentMoves moves = segment.moves(piece.latitude);
  if (moves.any_direction) return;
  const double dx = x - segment.centre_x();
  const double dy = y - segment.centre_y();
  const exact::Line::Margins margins = line.margins(part, dx, dy, moves);
  const double direction_x = segment.direction_x();
  const double direction_y = segment.direction_y();
  const double half = double{width} / 2;
  // The distance from the centre line, positive to the right of its direction (y points down).
  const double constant = segment.distance(0, 0);
  const double side = margins.side + half_of_range(line.width(), double{width});
  facts.boundaries.push_back(boundary_at(Boundary::Kind::kSide, "the right side",
                                         {direction_y, -direction_x, half - constant}, dx, dy, side, scale));
  facts.boundaries.push_back(boundary_at(Boundary::Kind::kSide, "the left side",
                                         {-direction_y, direction_x, half + constant}, dx, dy, side, scale));
  if (std::isfinite(part.begin.along)) {
    facts.boundaries.push_back(boundary_at(Boundary::Kind::kEnd, end_name(segment, 0, part.begin),
                                           {direction_x, direction_y, -part.begin.along}, dx, dy, margins.begin,
                                           scale));
  }
  if (std::isfinite(part.end.along)) {
    facts.boundaries.push_back(boundary_at(Boundary::Kind::kEnd, end_name(segment, 1, part.end),
                                           {-direction_x, -direction_y, part.end.along}, dx, dy, margins.end, scale));
  }
}

void add_square(const Piece& piece, double asked, double x, double y, double scale, PrimitiveFacts& facts) {
  const auto& point = static_cast<const exact::Point&>(*piece.shape);
  if (!point.inside_volume()) return;
  const VkViewport& viewport = point.viewport();
  const double centre_x = double{viewport.x} + double{viewport.width} / 2;
  const double centre_y = double{viewport.y} + double{viewport.height} / 2;
  const exact::Latitude margin = point.margin(piece.latitude);
  const SizeRange& size = point.size();
  const auto add = [&](const char* name, double a, double b, double vertex, double latitude) {
    facts.boundaries.push_back(boundary_at(Boundary::Kind::kSide, name, {a, b, asked / 2 - (a + b) * vertex},
                                           x - centre_x, y - centre_y, latitude + half_of_range(size, asked), scale));
  };
  add("the left side", 1, 0, point.x() - centre_x, margin.x);
  add("the right side", -1, 0, point.x() - centre_x, margin.x);
  add("the top", 0, 1, point.y() - centre_y, margin.y);
  add("the bottom", 0, -1, point.y() - centre_y, margin.y);
}

// A pixel may be covered within one pixel of a fragment, which is in a column that the line reaches and in the row
// where it crosses that column's centre (README.md of the oracle, "Bresenham lines").
void add_fragments(const Piece& piece, double x, double y, uint32_t subpixel_bits, double scale,
                   PrimitiveFacts& facts) {
  const auto& line = static_cast<const exact::BresenhamLine&>(*piece.shape);
  const Segment& segment = line.segment();
  if (!segment.unbounded() || segment.is_point()) return;
  const double centre_x = std::floor(x) + 0.5;
  const double centre_y = std::floor(y) + 0.5;
  const bool x_major = line.x_major();
  const double distance = segment.distance(centre_x - segment.centre_x(), centre_y - segment.centre_y());
  BresenhamFacts bresenham{.x_major = x_major, .width = line.width()};
  bresenham.distance = distance / std::abs(x_major ? segment.direction_x() : segment.direction_y());
  if (line.has_rules(piece.latitude)) bresenham.columns = line.columns(piece.latitude);
  if (line.on_grid(subpixel_bits)) bresenham.diamond_exit = line.owns(centre_x, centre_y);
  facts.bresenham = bresenham;
  const double reach = 1.5 + static_cast<double>(line.width() - 1) / 2;
  Boundary across{.kind = Boundary::Kind::kFragments, .name = "the pixels beside its fragments"};
  across.value = reach - std::abs(bresenham.distance);
  across.distance = across.value * scale;
  across.latitude = (x_major ? piece.latitude.y : piece.latitude.x) * scale;
  across.answer = facts.coverage.coverage;
  facts.boundaries.push_back(std::move(across));
  const SegmentPart& part = segment.clipped() ? *segment.clipped() : *segment.unbounded();
  if (!std::isfinite(part.length())) return;
  const double begin = x_major ? part.begin.x + segment.centre_x() : part.begin.y + segment.centre_y();
  const double end = x_major ? part.end.x + segment.centre_x() : part.end.y + segment.centre_y();
  const double at = x_major ? centre_x : centre_y;
  const double first = std::floor(std::min(begin, end)) - 1;
  const double last = std::floor(std::max(begin, end)) + 2;
  Boundary along{.kind = Boundary::Kind::kFragments, .name = "the pixels beyond its ends"};
  along.value = std::min(at - first, last - at);
  along.distance = along.value * scale;
  along.latitude = (x_major ? piece.latitude.x : piece.latitude.y) * scale;
  along.answer = facts.coverage.coverage;
  facts.boundaries.push_back(std::move(along));
}

}  // namespace

void add_shape_boundaries(const Case& test_case, const Piece& piece, double x, double y, uint32_t subpixel_bits,
                          PrimitiveFacts& facts) {
  const double scale = std::ldexp(1.0, static_cast<int>(subpixel_bits));
  const Draw& draw = test_case.draws[piece.draw];
  switch (piece.kind) {
    case Piece::Kind::kLine:
      return add_rectangle(piece, draw.state.line_width, x, y, scale, facts);
    case Piece::Kind::kBresenhamLine:
      return add_fragments(piece, x, y, subpixel_bits, scale, facts);
    case Piece::Kind::kPoint:
      return add_square(piece, draw.point_sizes.empty() ? 1 : double{draw.point_sizes[piece.vertices[0]]}, x, y,
                        scale, facts);
    case Piece::Kind::kTriangle:
    case Piece::Kind::kClipEdges:
      return;
  }
}

}  // namespace fillrule::explain
