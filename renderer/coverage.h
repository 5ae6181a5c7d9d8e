// Coverage masks: which pixel centres of a tile a snapped outline covers (Vulkan, "Basic Polygon Rasterization").
//
// An outline is a closed polygon; it is cut into a fan of triangles from its first vertex, and its coverage is the
// parity (XOR) of theirs. Snapping may turn a piece of a clipped polygon over; with the parity, inner edges cancel
// all the same, no sample is covered twice, and neighbours along an edge of the outline stay watertight.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "renderer/fixed_point.h"

namespace fillrule::renderer {

inline constexpr int32_t kTileSize = 64;  // pixels
inline constexpr int32_t kBlockSize = 8;  // pixels; one bit of a 64-bit mask each

// Bit 8 * row + column is the pixel (x + column, y + row).
struct CoverageBlock {
  int32_t x = 0;
  int32_t y = 0;
  uint64_t mask = 0;
};

struct TileCoverage {
  static constexpr uint32_t kMaxBlocks = (kTileSize / kBlockSize) * (kTileSize / kBlockSize);
  std::array<CoverageBlock, kMaxBlocks> blocks;
  uint32_t count = 0;  // of blocks with a pixel in them
};

// The pixels of `rect`, which must lie within one tile, that the outline of at most kMaxPolygonVertices covers.
void cover(std::span<const FixedPosition> outline, uint32_t subpixel_bits, const PixelRect& rect,
           TileCoverage& coverage);

}  // namespace fillrule::renderer
