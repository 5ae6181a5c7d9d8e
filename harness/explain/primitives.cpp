// Which primitives matter at a sample, and what becomes of them.
#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/explain/internal.h"
#include "harness/explain/oracle.h"
#include "reference/exact/assembly.h"

namespace fillrule::explain {
namespace {

using exact::Coverage;
using exact::Piece;

// Primitives further away than this do not matter to the sample.
constexpr double kNearPixels = 1;

bool contains(const VkRect2D& scissor, const exact::Position& position) {
  const double left = scissor.offset.x;
  const double top = scissor.offset.y;
  return position.x > left && position.x < left + static_cast<double>(scissor.extent.width) && position.y > top &&
         position.y < top + static_cast<double>(scissor.extent.height);
}

// Why nothing of the piece lands at the sample, whatever its shape covers.
Exclusion exclusion_of(const Case& test_case, const Piece& piece, const exact::SamplePlace& place) {
  const Draw& draw = test_case.draws[piece.draw];
  const auto& corners = piece.of_polygon ? piece.polygon : piece.vertices;
  if (exact::cull_distances_of(draw, corners) == exact::CullDistances::kDrop) return Exclusion::kCulledByDistances;
  if (piece.culled && !piece.facing_in_doubt) return Exclusion::kCulledByFacing;
  if (piece.kind == Piece::Kind::kPoint && !piece.shape->undefined() && !piece.shape->inside_volume()) {
    return Exclusion::kOutsideVolume;
  }
  if (!contains(draw.state.scissor, place.position)) return Exclusion::kScissored;
  if ((draw.state.sample_mask >> place.sample & 1U) == 0) return Exclusion::kMasked;
  return Exclusion::kNone;
}

std::vector<uint32_t> vertices_of(const Piece& piece) {
  const size_t count = piece.kind == Piece::Kind::kPoint                                               ? 1
                       : piece.kind == Piece::Kind::kLine || piece.kind == Piece::Kind::kBresenhamLine ? 2
                                                                                                       : 3;
  return {piece.vertices.begin(), piece.vertices.begin() + static_cast<std::ptrdiff_t>(count)};
}

// Everything but PrimitiveFacts::answer.
PrimitiveFacts facts_of(const Case& test_case, const Piece& piece, const exact::SamplePlace& place,
                        uint32_t subpixel_bits) {
  const auto [x, y] = place.position;
  PrimitiveFacts facts{.number = piece.owner,
                       .draw = piece.draw,
                       .kind = piece.kind,
                       .vertices = vertices_of(piece),
                       .orientation = piece.triangle() != nullptr ? piece.triangle()->orientation() : 0,
                       .front_facing = piece.front_facing,
                       .facing_in_doubt = piece.facing_in_doubt,
                       .undefined = piece.shape->undefined(),
                       .thin = piece.thin,
                       .clipped = !piece.shape->inside_volume(),
                       .open = piece.open,
                       .exclusion = exclusion_of(test_case, piece, place)};
  if (piece.of_polygon) facts.polygon.assign(piece.polygon.begin(), piece.polygon.end());
  facts.coverage = piece.shape->classify(x, y, piece.latitude);
  add_boundaries(test_case, piece, x, y, subpixel_bits, facts);
  return facts;
}

// Triangles that their cull distances drop are no pieces of the oracle's.
std::vector<Piece> dropped_triangles(const Case& test_case, const exact::Expectation& expectation) {
  std::vector<Piece> dropped;
  uint32_t first = 0;
  for (uint32_t number = 0; number < test_case.draws.size(); ++number) {
    const Draw& draw = test_case.draws[number];
    uint32_t owner = first;
    first += primitive_count(draw);
    if (draw.cull_distance_count == 0 || !exact::draws_polygons(draw)) continue;
    for (const exact::AssembledTriangle& triangle : exact::assemble(draw)) {
      Piece piece;
      piece.owner = owner++;
      if (std::ranges::find(expectation.pieces(), piece.owner, &Piece::owner) != expectation.pieces().end()) continue;
      piece.draw = number;
      piece.vertices = triangle.vertices;
      piece.shape = std::make_unique<exact::Triangle>(exact::triangle_of(draw, triangle.vertices));
      dropped.push_back(std::move(piece));
    }
  }
  return dropped;
}

// Whether the sample is more than a pixel outside of its bounds, which is quickly told.
bool is_far(const Piece& piece, const exact::Position& at) {
  const auto [left, top, right, bottom] = piece.shape->bounds(piece.latitude);
  return at.x < left - kNearPixels || at.y < top - kNearPixels || at.x > right + kNearPixels ||
         at.y > bottom + kNearPixels;
}

// Whether it comes within a pixel of the sample.
bool is_near(const PrimitiveFacts& facts, uint32_t subpixel_bits) {
  if (facts.undefined || facts.coverage.coverage != Coverage::kMustNot) return true;
  const auto of_shape = [](const Boundary& boundary) {
    return boundary.kind != Boundary::Kind::kViewport && boundary.kind != Boundary::Kind::kScissor;
  };
  if (std::ranges::none_of(facts.boundaries, of_shape)) return false;
  return facts.deciding()->distance >= -kNearPixels * std::ldexp(1.0, static_cast<int>(subpixel_bits));
}

}  // namespace

std::vector<PrimitiveFacts> primitives_of(const Case& test_case, const exact::Expectation& expectation, size_t index,
                                          uint32_t subpixel_bits, const std::vector<uint32_t>& shown) {
  const exact::SamplePlace place = exact::sample_place(test_case.target, index);
  std::vector<exact::Entry> entries;
  expectation.collect(index, entries);
  std::vector<PrimitiveFacts> primitives;
  const auto add = [&](const Piece& piece, Coverage answer) {
    const bool is_shown = std::ranges::find(shown, piece.owner) != shown.end();
    if (!is_shown && is_far(piece, place.position)) return;
    PrimitiveFacts facts = facts_of(test_case, piece, place, subpixel_bits);
    facts.answer = answer;
    if (is_shown || is_near(facts, subpixel_bits)) primitives.push_back(std::move(facts));
  };
  for (uint32_t number = 0; number < expectation.pieces().size(); ++number) {
    const auto entry = std::ranges::find(entries, number, &exact::Entry::piece);
    add(expectation.pieces()[number], entry == entries.end() ? Coverage::kMustNot : entry->coverage);
  }
  for (const Piece& piece : dropped_triangles(test_case, expectation)) add(piece, Coverage::kMustNot);
  std::ranges::stable_sort(primitives, {}, &PrimitiveFacts::number);
  return primitives;
}

}  // namespace fillrule::explain
