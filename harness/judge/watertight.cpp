#include "harness/judge/watertight.h"

#include <algorithm>
#include <vector>

namespace fillrule::judge {
namespace {

using exact::Coverage;
using exact::Entry;
using exact::Expectation;
using exact::Piece;

struct DirectedEdge {
  ClipPosition from{};
  ClipPosition to{};
  uint32_t draw = 0;
};

// The edge opposite of vertex i, in the direction that has the triangle on its positive side.
DirectedEdge directed_edge(const Piece& piece, size_t i) {
  const exact::Triangle& triangle = *piece.triangle();
  const auto& vertices = triangle.vertices();
  DirectedEdge edge{.from = vertices[(i + 1) % 3], .to = vertices[(i + 2) % 3], .draw = piece.draw};
  if (triangle.orientation() < 0) std::swap(edge.from, edge.to);
  return edge;
}

bool same_viewport(const Case& test_case, uint32_t a, uint32_t b) {
  const VkViewport& va = test_case.draws[a].state.viewport;
  const VkViewport& vb = test_case.draws[b].state.viewport;
  return a == b || (va.x == vb.x && va.y == vb.y && va.width == vb.width && va.height == vb.height);
}

// Every edge must have as many partners in its own direction (itself among them) as in the opposite one.
bool balanced(const Case& test_case, const std::vector<DirectedEdge>& edges) {
  return std::all_of(edges.begin(), edges.end(), [&](const DirectedEdge& edge) {
    int balance = 0;
    for (const DirectedEdge& other : edges) {
      if (!same_viewport(test_case, edge.draw, other.draw)) continue;
      if (other.from == edge.from && other.to == edge.to) ++balance;
      if (other.from == edge.to && other.to == edge.from) --balance;
    }
    return balance == 0;
  });
}

}  // namespace

WatertightHits watertight_hits(const Case& test_case, const Expectation& expectation, std::span<const Entry> entries,
                               double x, double y) {
  WatertightHits result;
  std::vector<DirectedEdge> edges;
  for (const Entry& entry : entries) {
    if (entry.coverage != Coverage::kMay) continue;
    const Piece& piece = expectation.pieces()[entry.piece];
    if ((entry.doubt & ~exact::kDoubtEdges) != 0 || piece.facing_in_doubt || piece.shape->undefined() ||
        piece.triangle() == nullptr) {
      return {};
    }
    for (size_t i = 0; i < 3; ++i) {
      if ((entry.doubt & (1U << i)) != 0) edges.push_back(directed_edge(piece, i));
    }
    ++result.primitives;
    if (piece.shape->owns(x, y)) ++result.hits;
  }
  if (!balanced(test_case, edges)) return {};
  return result;
}

}  // namespace fillrule::judge
