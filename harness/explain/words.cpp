// Names of primitives, and where a sample lies from them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/explain/internal.h"

namespace fillrule::explain {

using exact::Coverage;

const PrimitiveFacts* find_primitive(const View& view, uint32_t number) {
  const PrimitiveFacts* best = nullptr;
  for (const PrimitiveFacts& primitive : view.primitives) {
    if (primitive.number != number) continue;
    const auto distance = [](const PrimitiveFacts& facts) {
      return facts.deciding() == nullptr ? -HUGE_VAL : facts.deciding()->distance;
    };
    const bool better = best == nullptr || primitive.answer > best->answer ||
                        (primitive.answer == best->answer && distance(primitive) > distance(*best));
    if (better) best = &primitive;
  }
  return best;
}

std::string place_text(const PrimitiveFacts& primitive, const Boundary& boundary) {
  const std::string name = fmt::format("{} of {}", boundary.name, name_of(primitive));
  if (boundary.value == 0) return "exactly on " + name;
  return fmt::format("{} {} {}", subpixels(std::abs(boundary.distance)), boundary.distance < 0 ? "outside" : "inside",
                     name);
}

const Boundary* doubtful_boundary(const PrimitiveFacts& primitive) {
  const Boundary* nearest = nullptr;
  for (const Boundary& boundary : primitive.boundaries) {
    if (boundary.answer != Coverage::kMay) continue;
    if (nearest == nullptr || std::abs(boundary.distance) < std::abs(nearest->distance)) nearest = &boundary;
  }
  return nearest;
}

std::string excluded_text(const PrimitiveFacts& primitive) {
  const std::string name = name_of(primitive);
  switch (primitive.exclusion) {
    case Exclusion::kCulledByFacing:
      return fmt::format("draws {}, which is culled", name);
    case Exclusion::kCulledByDistances:
      return fmt::format("draws {}, which its cull distances drop", name);
    case Exclusion::kOutsideVolume:
      return fmt::format("draws {}, whose vertex is outside of the clip volume", name);
    case Exclusion::kScissored:
      return fmt::format("draws {} outside of the scissor", name);
    case Exclusion::kMasked:
      return fmt::format("draws {} at a sample that the sample mask takes away", name);
    case Exclusion::kNone:
      break;
  }
  return fmt::format("draws {}", name);
}

std::string name_of(const PrimitiveFacts& primitive) {
  std::string whole = fmt::format("primitive {}", primitive.number);
  // Which of the polygon's vertices the i-th one is.
  const auto corner = [&](size_t i) {
    return std::ranges::find(primitive.polygon, primitive.vertices[i]) - primitive.polygon.begin();
  };
  const bool part = !primitive.polygon.empty();
  switch (primitive.kind) {
    case exact::Piece::Kind::kTriangle:
      return whole;
    case exact::Piece::Kind::kLine:
    case exact::Piece::Kind::kBresenhamLine:
      return part ? fmt::format("the line v{}-v{} of {}", corner(0), corner(1), whole)
                  : fmt::format("line {}", primitive.number);
    case exact::Piece::Kind::kPoint:
      return part ? fmt::format("the corner v{} of {}", corner(0), whole) : fmt::format("point {}", primitive.number);
    case exact::Piece::Kind::kClipEdges:
      return fmt::format("what clipping adds to {}", whole);
  }
  return whole;
}

std::string subpixels(double distance) {
  const std::string number = std::abs(distance) >= 1e6   ? fmt::format("{:.3g}", distance)
                             : std::abs(distance) >= 100 ? fmt::format("{:.0f}", distance)
                                                         : fmt::format("{:.3g}", distance);
  return number + (number == "1" ? " subpixel" : " subpixels");
}

}  // namespace fillrule::explain
