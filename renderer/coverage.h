// Coverage masks: which samples of a tile a snapped outline covers (Vulkan, "Basic Polygon Rasterization").
//
// An outline is a closed polygon; it is cut into a fan of triangles from its first vertex, and its coverage is the
// parity (XOR) of theirs. Snapping may turn a piece of a clipped polygon over; with the parity, inner edges cancel
// all the same, no sample is covered twice, and neighbours along an edge of the outline stay watertight.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "cases/model/case.h"
#include "renderer/fixed_point.h"
#include "renderer/isa.h"

namespace fillrule::renderer {

inline constexpr int32_t kTileSize = 64;  // pixels
inline constexpr int32_t kBlockSize = 8;  // pixels; one bit of a 64-bit mask each

// Bit 8 * row + column is the pixel (x + column, y + row).
struct CoverageBlock {
  int32_t x;
  int32_t y;
  uint64_t mask;
};

inline constexpr uint32_t kMaxBlocks = (kTileSize / kBlockSize) * (kTileSize / kBlockSize);  // of a tile

// The blocks with a pixel in them, of one outline after the other: at most kMaxBlocks of each.
struct TileCoverage {
  std::array<CoverageBlock, size_t{2} * kMaxBlocks> blocks;  // not cleared: many, for a tile with few
  uint32_t count = 0;
};

// Adds the pixels of `rect`, which must lie within one tile, whose sample at `sample_fixed` the outline covers. The
// outline has at most kMaxPolygonVertices: a triangle, what clipping left of one, a line's rectangle, a point's
// square.
void cover(std::span<const FixedPosition> outline, const FixedPosition& sample_fixed, uint32_t subpixel_bits,
           const PixelRect& rect, TileCoverage& coverage, Isa isa = Isa::kScalar);

// Two ways to the same coverage.
enum class Fill : uint8_t {
  kEdgeFunction,  // cover()
  kScanline,      // cover_by_scanlines() of scanline.h
};

// How the outlines of a draw are covered.
struct CoverageRule {
  Fill fill = Fill::kEdgeFunction;
  uint32_t subpixel_bits = kMaxSubpixelBits;
  uint32_t bresenham_width = 1;  // pixels
  Isa isa = Isa::kScalar;        // of kEdgeFunction
};

// By the chosen fill. An outline of two vertices is a Bresenham line from the first to the second, whose pixels are
// covered wherever their samples are.
void cover(const CoverageRule& rule, std::span<const FixedPosition> outline, const FixedPosition& sample_fixed,
           const PixelRect& rect, TileCoverage& coverage);

// The same for pixels of several samples, a mask for each sample.
struct SampledBlock {
  int32_t x = 0;
  int32_t y = 0;
  uint64_t any = 0;  // the pixels with a covered sample
  std::array<uint64_t, kMaxSamples> masks{};

  // Bit i: the block's pixel number `bit` has its sample i covered.
  [[nodiscard]] uint32_t samples_at(uint32_t bit) const;
};

struct SampledTileCoverage {
  std::array<SampledBlock, size_t{2} * kMaxBlocks> blocks;
  uint32_t count = 0;
};

// One of a pixel's samples: where it is, and the pixels in which a fragment may land on it (not quite the same for
// all samples where a border of the viewport runs through pixels).
struct SampleArea {
  FixedPosition sample_fixed;
  PixelRect pixels;
};

// Lane by lane a sample within a row of pixels, for row_spans.h: that of lane i is sample i % n of a pixel's n
// samples, i / n rows down.
struct SpanSamples {
  std::array<int32_t, kBlockSize> x_fixed{};
  std::array<int32_t, kBlockSize> y_fixed{};
};

void cover_samples(const CoverageRule& rule, std::span<const FixedPosition> outline,
                   std::span<const SampleArea> samples, const PixelRect& rect, SampledTileCoverage& coverage);

}  // namespace fillrule::renderer
