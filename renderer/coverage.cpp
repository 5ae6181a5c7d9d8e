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

// The pixels of the 8x8 block at (x, y) that are in a rectangle which reaches into it.
uint64_t rect_mask(const PixelRect& rect, int32_t x, int32_t y) {
  const auto low = [](int32_t begin) { return static_cast<uint32_t>(std::max(begin, 0)); };
  const auto high = [](int32_t end) { return static_cast<uint32_t>(kBlockSize - std::min(end, kBlockSize)); };
  constexpr uint64_t kFirstColumn = 0x0101010101010101U;
  const uint64_t columns = (0xFFU << low(rect.left - x)) & (0xFFU >> high(rect.right - x));
  const uint64_t rows =
      (kFullMask << low(rect.top - y) * kBlockSize) & (kFullMask >> high(rect.bottom - y) * kBlockSize);
  return columns * kFirstColumn & rows;
}

bool contains_block(const PixelRect& rect, int32_t x, int32_t y) {
  return x >= rect.left && y >= rect.top && x + kBlockSize <= rect.right && y + kBlockSize <= rect.bottom;
}

bool reaches_into_block(const PixelRect& rect, int32_t x, int32_t y) {
  return x < rect.right && y < rect.bottom && x + kBlockSize > rect.left && y + kBlockSize > rect.top;
}

// One edge at all samples, from the first pixel of a rectangle of blocks within a tile: what is inside is not
// negative.
struct PieceEdge {
  int32_t step_x = 0;  // a pixel
  int32_t step_y = 0;
  std::array<int64_t, kMaxSamples> at;
  int64_t least = 0;  // of those of all samples
  int64_t greatest = 0;

  // The greatest and the least of an edge's steps within a block.
  [[nodiscard]] int64_t most_in_block() const { return 7 * (std::max<int64_t>(step_x, 0) + std::max(step_y, 0)); }
  [[nodiscard]] int64_t least_in_block() const { return 7 * (std::min<int64_t>(step_x, 0) + std::min(step_y, 0)); }
};

// Further away than this an edge keeps its sign all over a tile: 126 steps of less than 2^30 are less than 2^37, and
// of less than 2^22 less than 2^29.
constexpr int64_t kFar = int64_t{1} << 40;
constexpr int64_t kNarrowFar = int64_t{1} << 30;
constexpr int32_t kNarrowStep = 1 << 22;

// One triangle of the fan, positively oriented, in a rectangle of blocks.
struct Piece {
  std::array<PieceEdge, 3> edges;
  bool is_narrow = true;  // int32 holds its edges all over the tile

  Piece(const FixedPosition& a, const FixedPosition& b, const FixedPosition& c, std::span<const SampleArea> samples,
        uint32_t subpixel_bits, const PixelRect& blocks) {
    const std::array<const FixedPosition*, 4> corners{&a, &b, &c, &a};
    for (size_t i = 0; i < 3; ++i) {
      PieceEdge& edge = edges[i];
      for (size_t sample = 0; sample < samples.size(); ++sample) {
        const EdgeFunction function =
            edge_function(*corners[i], *corners[i + 1], samples[sample].sample_fixed, subpixel_bits);
        const int64_t at = function.at(blocks.left, blocks.top);
        edge.step_x = function.step_x;
        edge.step_y = function.step_y;
        edge.at[sample] = at;
        edge.least = sample == 0 ? at : std::min(edge.least, at);
        edge.greatest = sample == 0 ? at : std::max(edge.greatest, at);
      }
      is_narrow = is_narrow && std::max(std::abs(edge.step_x), std::abs(edge.step_y)) < kNarrowStep;
    }
    const int64_t far = is_narrow ? kNarrowFar : kFar;
    for (PieceEdge& edge : edges) {
      edge.least = std::clamp(edge.least, -far, far);
      edge.greatest = std::clamp(edge.greatest, -far, far);
      for (size_t sample = 0; sample < samples.size(); ++sample) {
        edge.at[sample] = std::clamp(edge.at[sample], -far, far);
      }
    }
  }
};

// What a sample's pixels of a block are covered by, in int32 lanes side by side.
template <typename L>
struct NarrowEdges {
  std::array<typename L::Int, 3> columns;  // the steps to the right, lane by lane
  const Piece& piece;

  [[gnu::always_inline]] explicit NarrowEdges(const Piece& the_piece) : piece(the_piece) {
    columns[0] = L::numbers() * piece.edges[0].step_x;
    columns[1] = L::numbers() * piece.edges[1].step_x;
    columns[2] = L::numbers() * piece.edges[2].step_x;
  }

  // Of the block whose first pixel is at (x, y) from that of the rectangle.
  [[gnu::always_inline]] uint64_t mask(size_t sample, int32_t x, int32_t y) const {
    const auto& [edge0, edge1, edge2] = piece.edges;
    uint64_t outside = 0;
    for (int32_t column = 0; column < kBlockSize; column += static_cast<int32_t>(L::kWidth)) {
      typename L::Int value0 = columns[0] + start(edge0, sample, x + column, y);
      typename L::Int value1 = columns[1] + start(edge1, sample, x + column, y);
      typename L::Int value2 = columns[2] + start(edge2, sample, x + column, y);
      for (int32_t row = 0; row < kBlockSize; ++row) {
        outside |= uint64_t{L::sign_bits(value0 | value1 | value2)} << (row * kBlockSize + column);
        value0 = value0 + edge0.step_y;
        value1 = value1 + edge1.step_y;
        value2 = value2 + edge2.step_y;
      }
    }
    return ~outside;
  }

  // The blocks of a row from (x, y) on, as many as there are lanes: which of them are outside, bit by bit, and which
  // are cut by an edge.
  struct Classes {
    uint32_t outside;
    uint32_t cut;
  };
  [[gnu::always_inline]] Classes classes(int32_t x, int32_t y) const {
    typename L::Int outside = L::numbers() & 0;
    typename L::Int cut = outside;
    for (size_t i = 0; i < 3; ++i) {
      const PieceEdge& edge = piece.edges[i];
      const typename L::Int steps = columns[i] * kBlockSize;
      const auto from_first = static_cast<int32_t>(x * edge.step_x + y * edge.step_y);
      outside = outside | (steps + (static_cast<int32_t>(edge.greatest + edge.most_in_block()) + from_first));
      cut = cut | (steps + (static_cast<int32_t>(edge.least + edge.least_in_block()) + from_first));
    }
    return {L::sign_bits(outside), L::sign_bits(cut)};
  }

 private:
  [[gnu::always_inline]] static int32_t start(const PieceEdge& edge, size_t sample, int32_t x, int32_t y) {
    return static_cast<int32_t>(edge.at[sample]) + x * edge.step_x + y * edge.step_y;
  }
};

// The same for steps that int32 has no room for: doubles hold them exactly.
template <typename L>
struct WideEdges {
  const Piece& piece;

  [[gnu::always_inline]] explicit WideEdges(const Piece& the_piece) : piece(the_piece) {}

  [[gnu::always_inline]] uint64_t mask(size_t sample, int32_t x, int32_t y) const {
    uint64_t outside = 0;
    for (const PieceEdge& edge : piece.edges) {
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

  using Classes = typename NarrowEdges<L>::Classes;
  [[gnu::always_inline]] Classes classes(int32_t x, int32_t y) const {
    Classes classes{};
    for (uint32_t lane = 0; lane < L::kWidth; ++lane) {
      for (const PieceEdge& edge : piece.edges) {
        const int64_t from_first =
            (x + static_cast<int32_t>(lane) * kBlockSize) * int64_t{edge.step_x} + y * int64_t{edge.step_y};
        classes.outside |= static_cast<uint32_t>(edge.greatest + edge.most_in_block() + from_first < 0) << lane;
        classes.cut |= static_cast<uint32_t>(edge.least + edge.least_in_block() + from_first < 0) << lane;
      }
    }
    return classes;
  }
};

// Calls visit(x, y, masks) for the blocks that the edges leave something of, row by row.
template <typename L, typename Edges, typename Visit>
[[gnu::always_inline]] inline void for_each_block(const Edges& edges, const PixelRect& blocks, size_t samples,
                                                  const Visit& visit) {
  std::array<uint64_t, kMaxSamples> masks;
  constexpr uint32_t kAllLanes = (1U << L::kWidth) - 1;
  for (int32_t y = 0; y < blocks.height(); y += kBlockSize) {
    for (int32_t first = 0; first < blocks.width(); first += kBlockSize * static_cast<int32_t>(L::kWidth)) {
      const auto [outside, cut] = edges.classes(first, y);
      const auto columns = static_cast<uint32_t>((blocks.width() - first) / kBlockSize);
      const uint32_t in_rect = columns >= L::kWidth ? kAllLanes : (1U << columns) - 1;
      for (uint32_t rest = ~outside & in_rect; rest != 0; rest &= rest - 1) {
        const int32_t lane = std::countr_zero(rest);
        const int32_t x = first + lane * kBlockSize;
        for (size_t sample = 0; sample < samples; ++sample) {
          masks[sample] = (cut >> lane & 1U) != 0 ? edges.mask(sample, x, y) : kFullMask;
        }
        visit(blocks.left + x, blocks.top + y, masks);
      }
    }
  }
}

// The same of one block.
template <typename L, typename Edges, typename Visit>
[[gnu::always_inline]] inline void visit_block(const Edges& edges, const PixelRect& block, size_t samples,
                                               const Visit& visit) {
  std::array<uint64_t, kMaxSamples> masks;
  for (size_t sample = 0; sample < samples; ++sample) {
    masks[sample] = edges.mask(sample, 0, 0);
  }
  visit(block.left, block.top, masks);
}

template <typename L, typename Visit>
[[gnu::always_inline]] inline void fill(const Piece& piece, const PixelRect& blocks, size_t samples,
                                        const Visit& visit) {
  const bool is_one = blocks.width() == kBlockSize && blocks.height() == kBlockSize;
  if (!piece.is_narrow) {
    for_each_block<L>(WideEdges<L>(piece), blocks, samples, visit);
  } else if (is_one) {
    visit_block<L>(NarrowEdges<L>(piece), blocks, samples, visit);
  } else {
    for_each_block<L>(NarrowEdges<L>(piece), blocks, samples, visit);
  }
}

// Calls visit(a, b, c) for each triangle of the fan that has an area, positively oriented.
template <typename Visit>
[[gnu::always_inline]] inline void for_each_piece(std::span<const FixedPosition> outline, const Visit& visit) {
  for (size_t i = 2; i < outline.size(); ++i) {
    const int64_t area = doubled_area(outline[0], outline[i - 1], outline[i]);
    if (area > 0) {
      visit(outline[0], outline[i - 1], outline[i]);
    } else if (area < 0) {
      visit(outline[0], outline[i], outline[i - 1]);
    }
  }
}

// Where the blocks of a draw with one sample a pixel go.
struct OneSample {
  TileCoverage& coverage;

  [[gnu::always_inline]] void add(int32_t x, int32_t y, const std::array<uint64_t, kMaxSamples>& masks,
                                  uint64_t in_rect, std::span<const SampleArea> /*samples*/) const {
    const uint64_t mask = masks[0] & in_rect;
    coverage.blocks[coverage.count] = {x, y, mask};
    coverage.count += mask != 0 ? 1 : 0;
  }
};

// And with several.
struct SeveralSamples {
  SampledTileCoverage& coverage;

  [[gnu::always_inline]] void add(int32_t x, int32_t y, const std::array<uint64_t, kMaxSamples>& masks,
                                  uint64_t in_rect, std::span<const SampleArea> samples) const {
    SampledBlock& block = coverage.blocks[coverage.count];
    block = {.x = x, .y = y};
    for (size_t i = 0; i < samples.size(); ++i) {
      uint64_t mask = masks[i] & in_rect;
      if (!contains_block(samples[i].pixels, x, y)) {
        mask = reaches_into_block(samples[i].pixels, x, y) ? mask & rect_mask(samples[i].pixels, x, y) : 0;
      }
      block.masks[i] = mask;
      block.any |= mask;
    }
    coverage.count += block.any != 0 ? 1 : 0;
  }
};

// The pieces of a polygon, block by block.
struct PieceParity {
  uint64_t touched = 0;  // bit i: block i, row by row from the rectangle's first
  std::array<std::array<uint64_t, kMaxSamples>, kMaxBlocks> masks;

  void flip(size_t block, size_t samples, const std::array<uint64_t, kMaxSamples>& piece) {
    if ((touched >> block & 1U) == 0) {
      touched |= uint64_t{1} << block;
      masks[block] = {};
    }
    for (size_t i = 0; i < samples; ++i) {
      masks[block][i] ^= piece[i];
    }
  }
};

template <typename Target>
void cover_by_edges(std::span<const FixedPosition> outline, std::span<const SampleArea> samples,
                    uint32_t subpixel_bits, const PixelRect& rect, Isa isa, const Target& target) {
  // Blocks at the rectangle's border reach beyond it, within the tile.
  const PixelRect blocks{rect.left & ~(kBlockSize - 1), rect.top & ~(kBlockSize - 1),
                         (rect.right + kBlockSize - 1) & ~(kBlockSize - 1),
                         (rect.bottom + kBlockSize - 1) & ~(kBlockSize - 1)};
  const auto add = [&](int32_t x, int32_t y, const std::array<uint64_t, kMaxSamples>& masks)
      __attribute__((always_inline)) {
    target.add(x, y, masks, contains_block(rect, x, y) ? kFullMask : rect_mask(rect, x, y), samples);
  };
  dispatch(
      isa, [&]<typename L>() __attribute__((always_inline)) {
        if (outline.size() == 3) {
          for_each_piece(
              outline, [&](const auto& a, const auto& b, const auto& c) __attribute__((always_inline)) {
                fill<L>(Piece(a, b, c, samples, subpixel_bits, blocks), blocks, samples.size(), add);
              });
          return;
        }
        PieceParity parity;
        const auto number = [&](int32_t x, int32_t y) {
          return static_cast<size_t>((y - blocks.top) / kBlockSize * (blocks.width() / kBlockSize) +
                                     (x - blocks.left) / kBlockSize);
        };
        for_each_piece(
            outline, [&](const auto& a, const auto& b, const auto& c) __attribute__((always_inline)) {
              fill<L>(
                  Piece(a, b, c, samples, subpixel_bits, blocks), blocks, samples.size(),
                  [&](int32_t x, int32_t y, const auto& masks) { parity.flip(number(x, y), samples.size(), masks); });
            });
        for (uint64_t rest = parity.touched; rest != 0; rest &= rest - 1) {
          const int32_t block = std::countr_zero(rest);
          const int32_t columns = blocks.width() / kBlockSize;
          add(blocks.left + block % columns * kBlockSize, blocks.top + block / columns * kBlockSize,
              parity.masks[static_cast<size_t>(block)]);
        }
      });
}

}  // namespace

void cover(std::span<const FixedPosition> outline, const FixedPosition& sample_fixed, uint32_t subpixel_bits,
           const PixelRect& rect, TileCoverage& coverage, Isa isa) {
  const SampleArea sample{sample_fixed, rect};
  cover_by_edges(outline, {&sample, 1}, subpixel_bits, rect, isa, OneSample{coverage});
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
    cover_by_edges(outline, samples, rule.subpixel_bits, rect, rule.isa, SeveralSamples{coverage});
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
