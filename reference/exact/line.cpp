#include "reference/exact/line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fillrule::exact {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kWidestRequired = 8;
constexpr double kLargestRequired = 64;
constexpr double kLargestWidth = 0x1p20;  // no target is larger
// Doubles decide what is further from a boundary than this, which is far above their rounding within a viewport and
// far below the latitude; closer, the specification leaves open what happens anyway.
constexpr double kSlack = 0x1p-30;

SizeRange size_range(float size, double largest_required) {
  if (!(size > 0)) return {.least = 0, .most = kInfinity};
  const double exact{size};
  return {.least = std::min(exact, largest_required), .most = std::max(exact, 1.0)};
}

// How far `inside` is inside, against a margin.
Coverage compare(double inside, double margin) {
  if (inside > margin) return Coverage::kMust;
  return inside < -margin ? Coverage::kMustNot : Coverage::kMay;
}

}  // namespace

SizeRange line_width_range(float width) {
  return size_range(width, kWidestRequired);
}

SizeRange point_size_range(float size) {
  return size_range(size, kLargestRequired);
}

Coverage classify_viewport(const VkViewport& viewport, double x, double y, const Latitude& latitude) {
  const double half_width = double{viewport.width} / 2;
  const double half_height = double{viewport.height} / 2;
  const double dx = std::abs(x - (double{viewport.x} + half_width));
  const double dy = std::abs(y - (double{viewport.y} + half_height));
  return std::min(compare(half_width - dx, latitude.x + kSlack),
                  compare(std::abs(half_height) - dy, latitude.y + kSlack));
}

Line::Line(const Segment& segment, float width) : segment_(segment), width_(line_width_range(width)) {}

// README.md, "Lines": both the end and the half width are rounded, and turning the line moves its corners.
Line::Margins Line::margins(const SegmentPart& part, double dx, double dy, const SegmentMoves& moves) const {
  const double cap = 2 * moves.along + width_.most / 2 * moves.turn + segment_.along_error(dx, dy) + kSlack;
  return {.side = side_margin(moves) + segment_.distance_error(dx, dy) + kSlack,
          .begin = cap + part.begin.slop + part.begin.error,
          .end = cap + part.end.slop + part.end.error};
}

Coverage Line::classify_caps(const SegmentPart& part, double dx, double dy, const SegmentMoves& moves) const {
  const double along = segment_.along(dx, dy);
  const Margins margin = margins(part, dx, dy, moves);
  return std::min(compare(along - part.begin.along, margin.begin), compare(part.end.along - along, margin.end));
}

double Line::side_margin(const SegmentMoves& moves) const {
  return 2 * moves.across + moves.slop + width_.most / 2 * moves.turn * moves.turn / 2;
}

Coverage Line::classify_sides(double dx, double dy, const SegmentMoves& moves) const {
  const double distance = std::abs(segment_.distance(dx, dy));
  const double margin = side_margin(moves) + segment_.distance_error(dx, dy) + kSlack;
  if (width_.least / 2 - distance > margin) return Coverage::kMust;
  return width_.most / 2 - distance < -margin ? Coverage::kMustNot : Coverage::kMay;
}

// Without a direction: a rectangle of any direction around the rounded ends.
Coverage Line::classify_point(double dx, double dy, const Latitude& latitude, const SegmentMoves& moves) const {
  const SegmentPart& part = *segment_.unbounded();
  const double reach = width_.most / 2 + 2 * (latitude.x + latitude.y) + moves.slop + kSlack;
  const auto outside = [reach](double position, double a, double b) {
    return position < std::min(a, b) - reach || position > std::max(a, b) + reach;
  };
  const bool far = outside(dx, part.begin.x, part.end.x) || outside(dy, part.begin.y, part.end.y);
  return far ? Coverage::kMustNot : Coverage::kMay;
}

Classification Line::classify(double x, double y, const Latitude& latitude, DoubtBits /*undecided*/) const {
  const auto answer = [](Coverage coverage) {
    const DoubtBits doubt = coverage == Coverage::kMay ? kDoubtShape : 0;
    return Classification{.coverage = coverage, .doubt = doubt};
  };
  const Coverage viewport = classify_viewport(segment_.viewport(), x, y, latitude);
  if (undefined()) return answer(std::min(viewport, Coverage::kMay));
  if (!segment_.unbounded()) return answer(Coverage::kMustNot);
  const double dx = x - segment_.centre_x();
  const double dy = y - segment_.centre_y();
  const SegmentMoves moves = segment_.moves(latitude);
  const auto& clipped = segment_.clipped();
  if (moves.any_direction) {
    const Coverage near = classify_point(dx, dy, latitude, moves);
    return answer(clipped ? near : std::min(viewport, near));
  }
  const Coverage sides = classify_sides(dx, dy, moves);
  // The rectangle of the clipped centre line may stick out of the viewport, that of the unclipped one may not.
  const Coverage narrow = clipped ? std::min(sides, classify_caps(*clipped, dx, dy, moves)) : Coverage::kMustNot;
  const Coverage wide = std::min({sides, viewport, classify_caps(*segment_.unbounded(), dx, dy, moves)});
  if (narrow == Coverage::kMust && wide == Coverage::kMust) return answer(Coverage::kMust);
  return answer(std::min(std::max(narrow, wide), Coverage::kMay));
}

BlockClassification Line::classify_block(const Block& block, const Latitude& latitude,
                                         DoubtBits /*undecided*/) const {
  if (undefined()) return {};
  if (!segment_.unbounded()) return {.coverage = Coverage::kMustNot};
  const SegmentMoves moves = segment_.moves(latitude);
  if (moves.any_direction) return {};
  const double dx = block.x - segment_.centre_x();
  const double dy = block.y - segment_.centre_y();
  const double radius =
      std::abs(segment_.direction_y()) * block.half_width + std::abs(segment_.direction_x()) * block.half_height;
  // A thousandth of a pixel covers the rounding of these few operations.
  const double reach = width_.most / 2 + radius + side_margin(moves) + segment_.distance_error(dx, dy) + 0x1p-10;
  if (std::abs(segment_.distance(dx, dy)) > reach) return {.coverage = Coverage::kMustNot};
  return {};
}

std::array<double, 4> Line::bounds(const Latitude& latitude) const {
  const double half_width = double{segment_.viewport().width} / 2;
  const double half_height = std::abs(double{segment_.viewport().height}) / 2;
  const double round = 2 * (latitude.x + latitude.y) + 1;
  const double reach = std::min(width_.most, kLargestWidth) + round;
  std::array<double, 4> box{-half_width - reach, -half_height - reach, half_width + reach, half_height + reach};
  const auto& part = segment_.unbounded();
  if (part && std::isfinite(part->length())) {
    const double grow = reach + part->begin.slop + part->end.slop + part->begin.error + part->end.error;
    box = {std::max(box[0], std::min(part->begin.x, part->end.x) - grow),
           std::max(box[1], std::min(part->begin.y, part->end.y) - grow),
           std::min(box[2], std::max(part->begin.x, part->end.x) + grow),
           std::min(box[3], std::max(part->begin.y, part->end.y) + grow)};
  }
  return {box[0] + segment_.centre_x(), box[1] + segment_.centre_y(), box[2] + segment_.centre_x(),
          box[3] + segment_.centre_y()};
}

}  // namespace fillrule::exact
