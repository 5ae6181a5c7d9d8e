// Coverage masks by edge functions: a triangle in a rectangle of blocks, for all samples of a pixel at once.
//
// Blocks are classed first, as many side by side as there are lanes, by the corners that decide (accept and reject);
// only what an edge cuts is asked pixel by pixel.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "renderer/coverage.h"
#include "renderer/edge_function.h"

namespace fillrule::renderer::internal {

inline constexpr uint64_t kFullMask = ~uint64_t{0};

// The pixels of the 8x8 block at (x, y) that are in a rectangle which reaches into it.
// Seldom asked for, so it is kept out of the way.
[[gnu::noinline]] inline uint64_t rect_mask(const PixelRect& rect, int32_t x, int32_t y) {
  const auto low = [](int32_t begin) { return static_cast<uint32_t>(std::max(begin, 0)); };
  const auto high = [](int32_t end) { return static_cast<uint32_t>(kBlockSize - std::min(end, kBlockSize)); };
  constexpr uint64_t kFirstColumn = 0x0101010101010101U;
  const uint64_t columns = (0xFFU << low(rect.left - x)) & (0xFFU >> high(rect.right - x));
  const uint64_t rows =
      (kFullMask << low(rect.top - y) * kBlockSize) & (kFullMask >> high(rect.bottom - y) * kBlockSize);
  return columns * kFirstColumn & rows;
}

inline bool contains_block(const PixelRect& rect, int32_t x, int32_t y) {
  return x >= rect.left && y >= rect.top && x + kBlockSize <= rect.right && y + kBlockSize <= rect.bottom;
}

inline bool reaches_into_block(const PixelRect& rect, int32_t x, int32_t y) {
  return x < rect.right && y < rect.bottom && x + kBlockSize > rect.left && y + kBlockSize > rect.top;
}

// The blocks that a rectangle touches; those at its border reach beyond it.
[[gnu::always_inline]] inline PixelRect touched_blocks(const PixelRect& rect) {
  return {rect.left & ~(kBlockSize - 1), rect.top & ~(kBlockSize - 1),
          (rect.right + kBlockSize - 1) & ~(kBlockSize - 1), (rect.bottom + kBlockSize - 1) & ~(kBlockSize - 1)};
}

// One edge at up to kSamples samples of the first pixel of a rectangle of blocks within a tile: what is inside is not
// negative.
template <size_t kSamples>
struct PieceEdge {
  int32_t step_x;  // a pixel
  int32_t step_y;
  std::array<int64_t, kSamples> at;
  int64_t least;  // of those of all samples
  int64_t greatest;

  // The greatest and the least of an edge's steps within a block.
  [[nodiscard]] int64_t most_in_block() const { return 7 * (std::max<int64_t>(step_x, 0) + std::max(step_y, 0)); }
  [[nodiscard]] int64_t least_in_block() const { return 7 * (std::min<int64_t>(step_x, 0) + std::min(step_y, 0)); }
};

// One triangle of an outline's fan, positively oriented, in a rectangle of blocks.
template <size_t kSamples>
using Piece = std::array<PieceEdge<kSamples>, 3>;

// Further away than `far` an edge keeps its sign all over a tile.
template <size_t kSamples>
[[gnu::always_inline]] inline PieceEdge<kSamples> make_edge(const FixedPosition& from, const FixedPosition& to,
                                                            std::span<const SampleArea> samples,
                                                            uint32_t subpixel_bits, const PixelRect& blocks,
                                                            int64_t far) {
  const auto value = [&](size_t sample) __attribute__((always_inline)) {
    const EdgeFunction edge = edge_function(from, to, samples[sample].sample_fixed, subpixel_bits);
    return std::min(std::max(edge.at(blocks.left, blocks.top), -far), far);
  };
  const int64_t first = value(0);
  PieceEdge<kSamples> edge;
  edge.step_x = from.y_fixed - to.y_fixed;
  edge.step_y = to.x_fixed - from.x_fixed;
  edge.least = edge.greatest = edge.at[0] = first;
  if constexpr (kSamples > 1) {
    for (size_t sample = 1; sample < samples.size(); ++sample) {
      edge.at[sample] = value(sample);
      edge.least = std::min(edge.least, edge.at[sample]);
      edge.greatest = std::max(edge.greatest, edge.at[sample]);
    }
  }
  return edge;
}

template <size_t kSamples>
[[gnu::always_inline]] inline Piece<kSamples> make_piece(const FixedPosition& a, const FixedPosition& b,
                                                         const FixedPosition& c, std::span<const SampleArea> samples,
                                                         uint32_t subpixel_bits, const PixelRect& blocks,
                                                         int64_t far) {
  return {make_edge<kSamples>(a, b, samples, subpixel_bits, blocks, far),
          make_edge<kSamples>(b, c, samples, subpixel_bits, blocks, far),
          make_edge<kSamples>(c, a, samples, subpixel_bits, blocks, far)};
}

// A triangle is narrow if int32 holds its edges all over a tile: 126 steps of less than 2^22 are less than 2^29, and
// what is as far as 2^30 away keeps its sign.
inline constexpr int64_t kNarrowFar = int64_t{1} << 30;
[[gnu::always_inline]] inline bool is_narrow(const FixedPosition& a, const FixedPosition& b, const FixedPosition& c) {
  constexpr int32_t kNarrowStep = 1 << 22;
  const auto extent = [](int32_t p, int32_t q, int32_t r) {
    return std::max(std::max(p, q), r) - std::min(std::min(p, q), r);
  };
  return std::max(extent(a.x_fixed, b.x_fixed, c.x_fixed), extent(a.y_fixed, b.y_fixed, c.y_fixed)) < kNarrowStep;
}

// Blocks side by side, bit by bit: which of them are outside, and which are cut by an edge.
struct BlockClasses {
  uint32_t outside = 0;
  uint32_t cut = 0;
};

// The edges of a narrow triangle, in int32 lanes side by side.
template <typename L, size_t kSamples>
struct NarrowEdges {
  const Piece<kSamples>& piece;
  // The steps to the right, lane by lane.
  typename L::Int columns0;
  typename L::Int columns1;
  typename L::Int columns2;

  [[gnu::always_inline]] explicit NarrowEdges(const Piece<kSamples>& the_piece)
      : piece(the_piece),
        columns0(L::numbers() * the_piece[0].step_x),
        columns1(L::numbers() * the_piece[1].step_x),
        columns2(L::numbers() * the_piece[2].step_x) {}

  // The pixels whose sample is inside, of the block whose first pixel is at (x, y) from that of the rectangle.
  [[nodiscard, gnu::always_inline]] uint64_t mask(size_t sample, int32_t x, int32_t y) const {
    const auto start = [&](const PieceEdge<kSamples>& edge, int32_t column) __attribute__((always_inline)) {
      return static_cast<int32_t>(edge.at[sample]) + (x + column) * edge.step_x + y * edge.step_y;
    };
    uint64_t outside = 0;
    for (int32_t column = 0; column < kBlockSize; column += static_cast<int32_t>(L::kWidth)) {
      typename L::Int value0 = columns0 + start(piece[0], column);
      typename L::Int value1 = columns1 + start(piece[1], column);
      typename L::Int value2 = columns2 + start(piece[2], column);
      for (int32_t row = 0; row < kBlockSize; ++row) {
        outside |= uint64_t{L::sign_bits(value0 | value1 | value2)} << (row * kBlockSize + column);
        value0 = value0 + piece[0].step_y;
        value1 = value1 + piece[1].step_y;
        value2 = value2 + piece[2].step_y;
      }
    }
    return ~outside;
  }

  // As many blocks as there are lanes, from the one at (x, y) on.
  [[nodiscard, gnu::always_inline]] BlockClasses classes(int32_t x, int32_t y) const {
    const auto at_corner = [&](const PieceEdge<kSamples>& edge, int64_t corner) __attribute__((always_inline)) {
      return static_cast<int32_t>(corner) + x * edge.step_x + y * edge.step_y;
    };
    const auto most = [&](const PieceEdge<kSamples>& edge) __attribute__((always_inline)) {
      return at_corner(edge, edge.greatest + edge.most_in_block());
    };
    const auto least = [&](const PieceEdge<kSamples>& edge) __attribute__((always_inline)) {
      return at_corner(edge, edge.least + edge.least_in_block());
    };
    const typename L::Int blocks0 = columns0 * kBlockSize;
    const typename L::Int blocks1 = columns1 * kBlockSize;
    const typename L::Int blocks2 = columns2 * kBlockSize;
    return {L::sign_bits((blocks0 + most(piece[0])) | (blocks1 + most(piece[1])) | (blocks2 + most(piece[2]))),
            L::sign_bits((blocks0 + least(piece[0])) | (blocks1 + least(piece[1])) | (blocks2 + least(piece[2])))};
  }
};

// One mask for each sample that there is.
template <size_t kSamples>
using SampleMasks = std::array<uint64_t, kSamples>;

// As many as there are; the compiler knows where that is one.
template <size_t kSamples>
constexpr size_t count_of(std::span<const SampleArea> samples) {
  return kSamples == 1 ? 1 : samples.size();
}

// Calls visit(x, y, masks) for the blocks that the edges leave something of, row by row.
template <typename L, size_t kSamples, typename Edges, typename Visit>
[[gnu::always_inline]] inline void for_each_block(const Edges& edges, const PixelRect& blocks,
                                                  std::span<const SampleArea> samples, const Visit& visit) {
  SampleMasks<kSamples> masks;
  constexpr uint32_t kAllLanes = (1U << L::kWidth) - 1;
  for (int32_t y = 0; y < blocks.height(); y += kBlockSize) {
    for (int32_t first = 0; first < blocks.width(); first += kBlockSize * static_cast<int32_t>(L::kWidth)) {
      const BlockClasses classes = edges.classes(first, y);
      const auto columns = static_cast<uint32_t>((blocks.width() - first) / kBlockSize);
      const uint32_t in_rect = columns >= L::kWidth ? kAllLanes : (1U << columns) - 1;
      for (uint32_t rest = ~classes.outside & in_rect; rest != 0; rest &= rest - 1) {
        const int32_t lane = std::countr_zero(rest);
        const int32_t x = first + lane * kBlockSize;
        for (size_t sample = 0; sample < count_of<kSamples>(samples); ++sample) {
          masks[sample] = (classes.cut >> lane & 1U) != 0 ? edges.mask(sample, x, y) : kFullMask;
        }
        visit(blocks.left + x, blocks.top + y, masks);
      }
    }
  }
}

// The same of a triangle; a single block is not classed.
template <typename L, size_t kSamples, typename Visit>
[[gnu::always_inline]] inline void fill_narrow(const Piece<kSamples>& piece, const PixelRect& blocks,
                                               std::span<const SampleArea> samples, const Visit& visit) {
  const NarrowEdges<L, kSamples> edges(piece);
  if (blocks.width() > kBlockSize || blocks.height() > kBlockSize) {
    for_each_block<L, kSamples>(edges, blocks, samples, visit);
    return;
  }
  SampleMasks<kSamples> masks;
  for (size_t sample = 0; sample < count_of<kSamples>(samples); ++sample) {
    masks[sample] = edges.mask(sample, 0, 0);
  }
  visit(blocks.left, blocks.top, masks);
}

// Adds a block to the coverage of draws with one sample a pixel, or with several.
[[gnu::always_inline]] inline void add_block(int32_t x, int32_t y, const SampleMasks<1>& masks, const PixelRect& rect,
                                             std::span<const SampleArea> /*samples*/, TileCoverage& coverage) {
  const uint64_t mask = contains_block(rect, x, y) ? masks[0] : masks[0] & rect_mask(rect, x, y);
  coverage.blocks[coverage.count] = {x, y, mask};
  coverage.count += mask != 0 ? 1 : 0;
}

[[gnu::always_inline]] inline void add_block(int32_t x, int32_t y, const SampleMasks<kMaxSamples>& masks,
                                             const PixelRect& rect, std::span<const SampleArea> samples,
                                             SampledTileCoverage& coverage) {
  const uint64_t in_rect = contains_block(rect, x, y) ? kFullMask : rect_mask(rect, x, y);
  SampledBlock& block = coverage.blocks[coverage.count];
  block.x = x;
  block.y = y;
  block.any = 0;
  for (size_t i = 0; i < samples.size(); ++i) {
    const PixelRect& pixels = samples[i].pixels;
    uint64_t mask = masks[i] & in_rect;
    if (!contains_block(pixels, x, y)) {
      mask = reaches_into_block(pixels, x, y) ? mask & rect_mask(pixels, x, y) : 0;
    }
    block.masks[i] = mask;
    block.any |= mask;
  }
  coverage.count += block.any != 0 ? 1 : 0;
}

// Whether all samples of all pixels of the rectangle of blocks are inside of the edges.
template <size_t kSamples>
[[gnu::always_inline]] inline bool is_all_inside(const Piece<kSamples>& piece, const PixelRect& blocks) {
  return std::all_of(piece.begin(), piece.end(), [&](const PieceEdge<kSamples>& edge) {
    const int64_t least_step_x = int64_t{std::min(edge.step_x, 0)} * (blocks.width() - 1);
    const int64_t least_step_y = int64_t{std::min(edge.step_y, 0)} * (blocks.height() - 1);
    return edge.least + least_step_x + least_step_y >= 0;
  });
}

// Whether a fragment may land on every sample of the rectangle.
[[gnu::always_inline]] inline bool contain(std::span<const SampleArea> samples, const PixelRect& rect) {
  return std::all_of(samples.begin(), samples.end(),
                     [&](const SampleArea& sample) { return intersection(sample.pixels, rect) == rect; });
}

template <typename Coverage>
inline constexpr size_t kSamplesOf = std::is_same_v<Coverage, TileCoverage> ? 1 : kMaxSamples;

// What became of a triangle.
enum class NarrowCover : uint8_t {
  kNotNarrow,  // and nothing was done
  kBlocks,
  kWholeTile,  // all of its samples; no block was added
};

// cover() of coverage.h of a triangle, if it is narrow. `rect` is the part of the bounding box that lies in `limits`
// and in the tile: no sample outside of the box is inside of the edges.
template <typename L, typename Coverage>
[[gnu::always_inline]] inline NarrowCover cover_narrow(const std::array<FixedPosition, 3>& triangle,
                                                       std::span<const SampleArea> samples, uint32_t subpixel_bits,
                                                       const PixelRect& rect, const PixelRect& limits,
                                                       Coverage& coverage) {
  constexpr size_t kSamples = kSamplesOf<Coverage>;
  const FixedPosition a = triangle[0];
  FixedPosition b = triangle[1];
  FixedPosition c = triangle[2];
  if (!is_narrow(a, b, c)) {
    return NarrowCover::kNotNarrow;
  }
  const int64_t area = doubled_area(a, b, c);
  if (area < 0) {
    std::swap(b, c);
  }
  if (area == 0) {
    return NarrowCover::kBlocks;
  }
  const PixelRect blocks = touched_blocks(rect);
  const Piece<kSamples> piece = make_piece<kSamples>(a, b, c, samples, subpixel_bits, blocks, kNarrowFar);
  if (rect.width() == kTileSize && rect.height() == kTileSize && is_all_inside(piece, rect) &&
      contain(samples, rect)) {
    return NarrowCover::kWholeTile;
  }
  fill_narrow<L, kSamples>(
      piece, blocks,
      samples, [&](int32_t x, int32_t y, const SampleMasks<kSamples>& masks) __attribute__((always_inline)) {
        add_block(x, y, masks, limits, samples, coverage);
      });
  return NarrowCover::kBlocks;
}

}  // namespace fillrule::renderer::internal
