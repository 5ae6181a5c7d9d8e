#include "reference/exact/clip_edges.h"

namespace fillrule::exact {

// What is within the reach of a boundary is what a latitude as large as the reach leaves in doubt.
Classification ClipEdges::classify(double x, double y, const Latitude& latitude, DoubtBits /*undecided*/) const {
  const Classification filled = polygon_.classify(x, y, grown(latitude));
  const bool near_plane = filled.coverage == Coverage::kMay && (filled.doubt & ~kDoubtEdges) != 0;
  return near_plane ? Classification{.coverage = Coverage::kMay, .doubt = kDoubtShape} : Classification{};
}

BlockClassification ClipEdges::classify_block(const Block& block, const Latitude& latitude,
                                              DoubtBits /*undecided*/) const {
  const BlockClassification filled = polygon_.classify_block(block, grown(latitude));
  const bool nothing = filled.coverage != Coverage::kMay || (filled.undecided & ~kDoubtEdges) == 0;
  return {.coverage = nothing ? Coverage::kMustNot : Coverage::kMay};
}

std::array<double, 4> ClipEdges::bounds(const Latitude& latitude) const {
  return polygon_.bounds(grown(latitude));
}

}  // namespace fillrule::exact
