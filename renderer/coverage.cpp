#include "renderer/coverage.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "renderer/bresenham_line.h"
#include "renderer/clip.h"
#include "renderer/edge_fill.h"
#include "renderer/scanline.h"

namespace fillrule::renderer {
namespace {

using namespace internal;

// 126 steps of at most 2^30 are less than 2^37.
constexpr int64_t kWideFar = int64_t{1} << 40;

// The edges of a triangle whose steps int32 has no room for: doubles hold them exactly.
template <typename L, size_t kSamples>
struct WideEdges {
  const Piece<kSamples>& piece;

  [[gnu::always_inline]] uint64_t mask(size_t sample, int32_t x, int32_t y) const {
    uint64_t outside = 0;
    for (const PieceEdge<kSamples>& edge : piece) {
      for (int32_t column = 0; column < kBlockSize; column += static_cast<int32_t>(L::kWidth)) {
        const double start =
            static_cast<double>(edge.at[sample] + int64_t{x + column} * edge.step_x + int64_t{y} * edge.step_y);
        const auto values = L::all(start) + L::to_double(L::numbers()) * L::all(static_cast<double>(edge.step_x));
        for (int32_t row = 0; row < kBlockSize; ++row) {
          const auto value = values + L::all(static_cast<double>(edge.step_y) * row);
          outside |= uint64_t{L::sign_bits(L::bits_of(L::to_float(value)))} << (row * kBlockSize + column);
        }
      }
    }
    return ~outside;
  }

  [[gnu::always_inline]] BlockClasses classes(int32_t x, int32_t y) const {
    BlockClasses classes;
    for (uint32_t lane = 0; lane < L::kWidth; ++lane) {
      for (const PieceEdge<kSamples>& edge : piece) {
        const int64_t from_first =
            (x + static_cast<int32_t>(lane) * kBlockSize) * int64_t{edge.step_x} + y * int64_t{edge.step_y};
        classes.outside |= static_cast<uint32_t>(edge.greatest + edge.most_in_block() + from_first < 0) << lane;
        classes.cut |= static_cast<uint32_t>(edge.least + edge.least_in_block() + from_first < 0) << lane;
      }
    }
    return classes;
  }
};

// Calls visit(x, y, masks) for the blocks of each triangle of the fan that has an area.
template <typename L, size_t kSamples, typename Visit>
[[gnu::always_inline]] inline void for_each_piece(std::span<const FixedPosition> outline,
                                                  std::span<const SampleArea> samples, uint32_t subpixel_bits,
                                                  const PixelRect& blocks, const Visit& visit) {
  const FixedPosition& a = outline[0];
  for (size_t i = 2; i < outline.size(); ++i) {
    const int64_t area = doubled_area(a, outline[i - 1], outline[i]);
    const FixedPosition& b = area > 0 ? outline[i - 1] : outline[i];
    const FixedPosition& c = area > 0 ? outline[i] : outline[i - 1];
    if (area == 0) {
      continue;
    }
    if (is_narrow(a, b, c)) {
      fill_narrow<L, kSamples>(make_piece<kSamples>(a, b, c, samples, subpixel_bits, blocks, kNarrowFar), blocks,
                               samples, visit);
    } else {
      const Piece<kSamples> piece = make_piece<kSamples>(a, b, c, samples, subpixel_bits, blocks, kWideFar);
      for_each_block<L, kSamples>(WideEdges<L, kSamples>{piece}, blocks, samples, visit);
    }
  }
}

// The parity of the pieces of a polygon, block by block.
template <size_t kSamples>
struct PieceParity {
  PixelRect blocks;
  uint64_t touched = 0;  // bit i: block i, row by row
  std::array<SampleMasks<kSamples>, kMaxBlocks> masks;

  [[nodiscard]] int32_t columns() const { return blocks.width() / kBlockSize; }

  void flip(int32_t x, int32_t y, size_t samples, const SampleMasks<kSamples>& piece) {
    const auto block =
        static_cast<size_t>((y - blocks.top) / kBlockSize * columns() + (x - blocks.left) / kBlockSize);
    if ((touched >> block & 1U) == 0) {
      touched |= uint64_t{1} << block;
      masks[block] = {};
    }
    for (size_t i = 0; i < samples; ++i) {
      masks[block][i] ^= piece[i];
    }
  }
};

template <typename Coverage>
void cover_by_edges(std::span<const FixedPosition> outline, std::span<const SampleArea> samples,
                    uint32_t subpixel_bits, const PixelRect& rect, Isa isa, Coverage& coverage) {
  constexpr size_t kSamples = kSamplesOf<Coverage>;
  PieceParity<kSamples> parity{.blocks = touched_blocks(rect)};
  dispatch(
      isa, [&]<typename L>() __attribute__((always_inline)) {
        for_each_piece<L, kSamples>(outline, samples, subpixel_bits, parity.blocks,
                                    [&](int32_t x, int32_t y, const SampleMasks<kSamples>& masks) {
                                      parity.flip(x, y, count_of<kSamples>(samples), masks);
                                    });
      });
  for (uint64_t rest = parity.touched; rest != 0; rest &= rest - 1) {
    const int32_t block = std::countr_zero(rest);
    add_block(parity.blocks.left + block % parity.columns() * kBlockSize,
              parity.blocks.top + block / parity.columns() * kBlockSize, parity.masks[static_cast<size_t>(block)],
              rect, samples, coverage);
  }
}

}  // namespace

void cover(std::span<const FixedPosition> outline, const FixedPosition& sample_fixed, uint32_t subpixel_bits,
           const PixelRect& rect, TileCoverage& coverage, Isa isa) {
  const SampleArea sample{sample_fixed, rect};
  cover_by_edges(outline, {&sample, 1}, subpixel_bits, rect, isa, coverage);
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
  if (outline.size() > 2 && rule.fill == Fill::kEdgeFunction) {
    cover_by_edges(outline, samples, rule.subpixel_bits, rect, rule.isa, coverage);
    return;
  }
  // Which entry the block of a tile's row and column has: all samples' blocks lie alike.
  constexpr uint8_t kNone = 0xFF;
  std::array<uint8_t, kMaxBlocks> entries;
  entries.fill(kNone);
  TileCoverage one;
  for (uint32_t i = 0; i < samples.size(); ++i) {
    one.count = 0;
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
      const PixelRect& pixels = samples[i].pixels;
      block.masks[i] = reaches_into_block(pixels, x, y) ? mask & rect_mask(pixels, x, y) : 0;
      block.any |= block.masks[i];
    }
  }
}

}  // namespace fillrule::renderer
