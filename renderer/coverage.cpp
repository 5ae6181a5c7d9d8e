#include "renderer/coverage.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "renderer/bresenham_line.h"
#include "renderer/clip.h"
#include "renderer/edge_function.h"
#include "renderer/scanline.h"

namespace fillrule::renderer {
namespace {

constexpr uint64_t kFullMask = ~uint64_t{0};

// The edges of one triangle of the fan that are not settled yet; a pixel is inside of all of them or of none.
struct Piece {
  std::array<EdgeFunction, 3> edges;
  uint32_t count = 0;
};

struct Pieces {
  std::array<Piece, kMaxPolygonVertices - 2> pieces;
  uint32_t count = 0;
};

// The least and the greatest value of an edge function over a rectangle of pixels: at two of its corners.
struct Range {
  int64_t least;
  int64_t greatest;
};

Range range_over(const EdgeFunction& edge, int64_t at_top_left, int32_t width, int32_t height) {
  const int64_t across = int64_t{edge.step_x} * (width - 1);
  const int64_t down = int64_t{edge.step_y} * (height - 1);
  return {at_top_left + (across < 0 ? across : 0) + (down < 0 ? down : 0),
          at_top_left + (across > 0 ? across : 0) + (down > 0 ? down : 0)};
}

std::array<EdgeFunction, 3> edges_of(const FixedPosition& a, const FixedPosition& b, const FixedPosition& c,
                                     const FixedPosition& sample_fixed, uint32_t subpixel_bits) {
  return {edge_function(a, b, sample_fixed, subpixel_bits), edge_function(b, c, sample_fixed, subpixel_bits),
          edge_function(c, a, sample_fixed, subpixel_bits)};
}

// Drops the edges that all of the rectangle is inside of; false if all of it is outside of one.
bool settle(const PixelRect& rect, const std::array<EdgeFunction, 3>& edges, Piece& piece) {
  piece.count = 0;
  for (const EdgeFunction& edge : edges) {
    const Range range = range_over(edge, edge.at(rect.left, rect.top), rect.width(), rect.height());
    if (range.greatest < 0) {
      return false;
    }
    if (range.least < 0) {
      piece.edges[piece.count++] = edge;
    }
  }
  return true;
}

// The pixels of a block that are inside of an edge which crosses it, for edges too steep for int32.
uint64_t steep_edge_mask(int64_t at_top_left, const EdgeFunction& edge) {
  uint64_t mask = 0;
  for (uint32_t row = 0; row < kBlockSize; ++row) {
    for (uint32_t column = 0; column < kBlockSize; ++column) {
      const int64_t value = at_top_left + int64_t{edge.step_x} * column + int64_t{edge.step_y} * row;
      mask |= static_cast<uint64_t>(value >= 0) << (row * kBlockSize + column);
    }
  }
  return mask;
}

// The edges of a piece that cross a block, by their values at its top left pixel; the others are 0 throughout. Within
// the block |value| is at most 7 * (|step_x| + |step_y|), since both signs occur, and one step more is taken.
struct CrossingEdges {
  std::array<int32_t, 3> at_top_left{};
  std::array<int32_t, 3> step_x{};
  std::array<int32_t, 3> step_y{};
};

// The pixels inside of all these edges: lanes are rows, one column after the other.
template <typename L>
[[gnu::always_inline]] inline uint64_t crossing_mask(const CrossingEdges& edges) {
  uint64_t outside = 0;
  for (int32_t row = 0; row < kBlockSize; row += static_cast<int32_t>(L::kWidth)) {
    const typename L::Int rows = L::numbers() + row;
    typename L::Int value0 = rows * edges.step_y[0] + edges.at_top_left[0];
    typename L::Int value1 = rows * edges.step_y[1] + edges.at_top_left[1];
    typename L::Int value2 = rows * edges.step_y[2] + edges.at_top_left[2];
    typename L::Int outside_rows = L::numbers() & 0;
    for (int32_t column = 0; column < kBlockSize; ++column) {
      outside_rows = outside_rows | (((value0 | value1 | value2) >> 31) & (1 << column));
      value0 = value0 + edges.step_x[0];
      value1 = value1 + edges.step_x[1];
      value2 = value2 + edges.step_x[2];
    }
    outside |= L::low_bytes(outside_rows) << static_cast<uint32_t>(row * kBlockSize);
  }
  return ~outside;
}

template <typename L>
[[gnu::always_inline]] inline uint64_t block_mask(const Piece& piece, int32_t x, int32_t y) {
  uint64_t mask = kFullMask;
  CrossingEdges crossing;
  bool crosses = false;
  for (uint32_t i = 0; i < piece.count; ++i) {
    const EdgeFunction& edge = piece.edges[i];
    const int64_t at_top_left = edge.at(x, y);
    const Range range = range_over(edge, at_top_left, kBlockSize, kBlockSize);
    if (range.greatest < 0) {
      return 0;
    }
    if (range.least < 0) {
      constexpr int64_t kNarrow = int64_t{1} << 27;
      if (std::abs(int64_t{edge.step_x}) + std::abs(int64_t{edge.step_y}) >= kNarrow) {
        mask &= steep_edge_mask(at_top_left, edge);
      } else {
        crossing.at_top_left[i] = static_cast<int32_t>(at_top_left);
        crossing.step_x[i] = edge.step_x;
        crossing.step_y[i] = edge.step_y;
        crosses = true;
      }
    }
  }
  return crosses ? mask & crossing_mask<L>(crossing) : mask;
}

// The pixels of the 8x8 block at (x, y) that are in the rectangle, which may be anywhere.
uint64_t rect_mask(const PixelRect& rect, int32_t x, int32_t y) {
  if (x >= rect.left && y >= rect.top && x + kBlockSize <= rect.right && y + kBlockSize <= rect.bottom) {
    return kFullMask;
  }
  // Bits [low, high) of 8: the columns, or the rows, of the block between two coordinates.
  const auto range_mask = [](int32_t begin, int32_t end, int32_t origin) {
    const auto low = static_cast<uint32_t>(std::clamp(begin - origin, 0, kBlockSize));
    const auto high = static_cast<uint32_t>(std::clamp(end - origin, 0, kBlockSize));
    const uint64_t mask = ((1U << high) - 1U) & ~((1U << low) - 1U);
    return mask;
  };
  constexpr uint64_t kFirstColumn = 0x0101010101010101U;
  const uint64_t columns = range_mask(rect.left, rect.right, x) * kFirstColumn;
  uint64_t mask = 0;
  for (uint64_t rows = range_mask(rect.top, rect.bottom, y); rows != 0; rows &= rows - 1) {
    mask |= uint64_t{0xFF} << (static_cast<uint32_t>(std::countr_zero(rows)) * kBlockSize);
  }
  return mask & columns;
}

// One triangle over a rectangle of at most 8x8 pixels, pixel by pixel.
uint64_t small_mask(const std::array<EdgeFunction, 3>& edges, const PixelRect& rect) {
  uint64_t mask = 0;
  int64_t row0 = edges[0].at(rect.left, rect.top);
  int64_t row1 = edges[1].at(rect.left, rect.top);
  int64_t row2 = edges[2].at(rect.left, rect.top);
  for (int32_t row = 0; row < rect.height(); ++row) {
    int64_t value0 = row0;
    int64_t value1 = row1;
    int64_t value2 = row2;
    for (int32_t column = 0; column < rect.width(); ++column) {
      const bool is_inside = (value0 | value1 | value2) >= 0;
      mask |= static_cast<uint64_t>(is_inside) << static_cast<uint32_t>(row * kBlockSize + column);
      value0 += edges[0].step_x;
      value1 += edges[1].step_x;
      value2 += edges[2].step_x;
    }
    row0 += edges[0].step_y;
    row1 += edges[1].step_y;
    row2 += edges[2].step_y;
  }
  return mask;
}

// Calls visit(edges) for each triangle of the fan that has an area, positively oriented.
template <typename Visit>
void for_each_piece(std::span<const FixedPosition> outline, const FixedPosition& sample_fixed, uint32_t subpixel_bits,
                    const Visit& visit) {
  for (size_t i = 2; i < outline.size(); ++i) {
    const FixedPosition& a = outline[0];
    FixedPosition b = outline[i - 1];
    FixedPosition c = outline[i];
    const int64_t area = doubled_area(a, b, c);
    if (area == 0) {
      continue;
    }
    if (area < 0) {
      std::swap(b, c);
    }
    visit(edges_of(a, b, c, sample_fixed, subpixel_bits));
  }
}

}  // namespace

void cover(std::span<const FixedPosition> outline, const FixedPosition& sample_fixed, uint32_t subpixel_bits,
           const PixelRect& rect, TileCoverage& coverage, Isa isa) {
  coverage.count = 0;
  const int32_t block_x = rect.left & ~(kBlockSize - 1);
  const int32_t block_y = rect.top & ~(kBlockSize - 1);
  if (rect.right <= block_x + kBlockSize && rect.bottom <= block_y + kBlockSize) {
    uint64_t mask = 0;
    for_each_piece(outline, sample_fixed, subpixel_bits, [&](const auto& edges) { mask ^= small_mask(edges, rect); });
    mask <<= static_cast<uint32_t>((rect.top - block_y) * kBlockSize + rect.left - block_x);
    if (mask != 0) {
      coverage.blocks[coverage.count++] = {block_x, block_y, mask};
    }
    return;
  }

  // Step 1: settle what the whole rectangle answers alike. Blocks at its border reach beyond it, within the tile.
  const PixelRect blocks{rect.left & ~(kBlockSize - 1), rect.top & ~(kBlockSize - 1),
                         (rect.right + kBlockSize - 1) & ~(kBlockSize - 1),
                         (rect.bottom + kBlockSize - 1) & ~(kBlockSize - 1)};
  Pieces active;
  for_each_piece(outline, sample_fixed, subpixel_bits, [&](const auto& edges) {
    if (settle(blocks, edges, active.pieces[active.count])) {
      ++active.count;
    }
  });
  if (active.count == 0) {
    return;
  }

  // Step 2: block by block.
  dispatch(
      isa, [&]<typename L>() __attribute__((always_inline)) {
        for (int32_t y = blocks.top; y < blocks.bottom; y += kBlockSize) {
          for (int32_t x = blocks.left; x < blocks.right; x += kBlockSize) {
            uint64_t mask = 0;
            for (uint32_t i = 0; i < active.count; ++i) {
              mask ^= block_mask<L>(active.pieces[i], x, y);
            }
            mask &= rect_mask(rect, x, y);
            if (mask != 0) {
              coverage.blocks[coverage.count++] = {x, y, mask};
            }
          }
        }
      });
}

uint32_t SampledBlock::samples_at(uint32_t bit) const {
  uint32_t samples = 0;
  for (uint32_t i = 0; i < kMaxSamples; ++i) {
    samples |= static_cast<uint32_t>(masks[i] >> bit & 1U) << i;
  }
  return samples;
}

void cover(const CoverageRule& rule, std::span<const FixedPosition> outline, const FixedPosition& sample_fixed,
           const PixelRect& rect, TileCoverage& coverage) {
  if (outline.size() == 2) {
    const BresenhamLine line{outline[0], outline[1], rule.bresenham_width};
    cover_by_diamond_exit(line, rule.subpixel_bits, rect, coverage);
  } else if (rule.fill == Fill::kScanline) {
    cover_by_scanlines(outline, sample_fixed, rule.subpixel_bits, rect, coverage);
  } else {
    cover(outline, sample_fixed, rule.subpixel_bits, rect, coverage, rule.isa);
  }
}

void cover_samples(const CoverageRule& rule, std::span<const FixedPosition> outline,
                   std::span<const SampleArea> samples, const PixelRect& rect, SampledTileCoverage& coverage) {
  coverage.count = 0;
  // Which entry the block of a tile's row and column has: all samples' blocks lie alike.
  constexpr uint8_t kNone = 0xFF;
  std::array<uint8_t, TileCoverage::kMaxBlocks> entries;
  entries.fill(kNone);
  TileCoverage one;
  for (uint32_t i = 0; i < samples.size(); ++i) {
    cover(rule, outline, samples[i].sample_fixed, rect, one);
    for (uint32_t k = 0; k < one.count; ++k) {
      const auto& [x, y, mask] = one.blocks[k];
      constexpr int32_t kBlocksInRow = kTileSize / kBlockSize;
      uint8_t& entry = entries[static_cast<uint32_t>((y & (kTileSize - 1)) / kBlockSize * kBlocksInRow +
                                                     (x & (kTileSize - 1)) / kBlockSize)];
      if (entry == kNone) {
        entry = static_cast<uint8_t>(coverage.count);
        coverage.blocks[coverage.count++] = {.x = x, .y = y};
      }
      SampledBlock& block = coverage.blocks[entry];
      block.masks[i] = mask & rect_mask(samples[i].pixels, x, y);
      block.any |= block.masks[i];
    }
  }
}

}  // namespace fillrule::renderer
