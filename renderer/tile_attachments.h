// The part of the attachments that one tile owns, block by block, while it is drawn.
//
// Rows of a wide attachment are so far apart that those of one tile fall on the same few lines of a cache. So a
// block's values are copied out when it is first touched and back when the tile is done; in between the tile's rows
// follow each other, and no row of lanes can reach beyond the target.
//
// An attachment that is to be cleared is so on the way: what was in its blocks is not read, and the clear value is
// written by whoever draws the tile, where nothing was drawn too.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "renderer/coverage.h"
#include "renderer/prepared_draw.h"

namespace fillrule::renderer::internal {

// Asks for values that are soon written: rows of a tile with one sample are too short for the processor to foresee
// the next.
template <typename T>
[[gnu::always_inline]] inline void prefetch_row(std::span<T> values, size_t first, size_t count) {
  constexpr size_t kCacheLine = 64 / sizeof(T);
  if (count > kTileSize || first + count > values.size()) {
    return;
  }
  for (size_t i = 0; i < count; i += kCacheLine) {
    __builtin_prefetch(&values[first + i], 1);
  }
}

// Sets the pixels of the rectangle that are in the target to the attachment's clear value, if it has one.
template <typename Buffer>
void clear_rows(const DrawInput& input, const PixelRect& pixels, const Buffer& attachment) {
  if (!attachment.clear || attachment.values.empty()) {
    return;
  }
  const size_t width = input.target_width;
  const size_t left = std::min(static_cast<size_t>(pixels.left), width);
  const size_t columns = std::min(static_cast<size_t>(pixels.right), width) - left;
  const size_t bottom = std::min<size_t>(static_cast<size_t>(pixels.bottom), input.target_height);
  const size_t count = columns * input.samples;
  for (auto row = static_cast<size_t>(pixels.top); row < bottom; ++row) {
    prefetch_row(attachment.values, ((row + kBlockSize) * width + left) * input.samples, count);
    std::fill_n(attachment.values.begin() + static_cast<ptrdiff_t>((row * width + left) * input.samples), count,
                *attachment.clear);
  }
}

// The same of both attachments.
inline void clear_attachments(const DrawInput& input, const PixelRect& pixels) {
  clear_rows(input, pixels, input.depth);
  clear_rows(input, pixels, input.color);
}

class TileAttachments {
 public:
  // The values from some pixel of the tile on: (y * kTileSize + x) * samples + sample. Only of attachments in use.
  struct Values {
    float* depths;
    uint32_t* colors;
  };

  // Of a thread, for one tile after the other.
  struct Storage {
    std::vector<float> depths;
    std::vector<uint32_t> colors;
  };

  // is_first: the tile is drawn for the first time in this draw.
  TileAttachments(const PreparedDraw& draw, const PixelRect& tile_pixels, bool is_first, Storage& storage)
      : input_(draw.input),
        left_(tile_pixels.left),
        top_(tile_pixels.top),
        uses_depth_(draw.depth.tests()),
        clears_(is_first && draw.input.clears()) {
    // A run of pixels may begin in the tile's last one.
    const size_t values = (size_t{kTileSize} * kTileSize + kBlockSize) * input_.samples;
    if (uses_depth_ && storage.depths.size() < values) {
      storage.depths.resize(values);
    }
    if (!input_.color.values.empty() && storage.colors.size() < values) {
      storage.colors.resize(values);
    }
    depths_ = storage.depths.data();
    colors_ = storage.colors.data();
    depth_limits_.fill(std::numeric_limits<float>::infinity());
  }

  // From a pixel whose block was loaded.
  [[nodiscard, gnu::always_inline]] Values at(int32_t x, int32_t y) const {
    const int32_t pixel = (y - top_) * kTileSize + (x - left_);
    const size_t first = static_cast<size_t>(pixel) * input_.samples;
    return {depths_ == nullptr ? nullptr : depths_ + first, colors_ == nullptr ? nullptr : colors_ + first};
  }

  // The same for loops that write: a copy, which no compiler has to read again after what was written.
  template <uint32_t kSamples>
  struct Pixels {
    int32_t left;
    int32_t top;
    float* depths;
    uint32_t* colors;

    // Of a pixel by its number in the tile.
    [[nodiscard, gnu::always_inline]] float* depths_at(uint32_t pixel) const {
      return depths + size_t{pixel} * kSamples;
    }
    [[nodiscard, gnu::always_inline]] uint32_t* colors_at(uint32_t pixel) const {
      return colors + size_t{pixel} * kSamples;
    }
  };
  // kSamples: that of the draw.
  template <uint32_t kSamples>
  [[nodiscard, gnu::always_inline]] Pixels<kSamples> pixels() const {
    return {left_, top_, depths_, colors_};
  }

  // Of a block under the usual depth test, which lets depths only become less: none of its depths is greater.
  // Infinite where nobody has looked.
  [[nodiscard, gnu::always_inline]] float depth_limit(int32_t x, int32_t y) const {
    return depth_limits_[block_number(x, y)];
  }
  [[gnu::always_inline]] void set_depth_limit(int32_t x, int32_t y, float limit) {
    depth_limits_[block_number(x, y)] = limit;
    limited_ |= uint64_t{1} << block_number(x, y);
  }
  // Whether there is one of each block that a rectangle touches, and the greatest of those.
  [[nodiscard, gnu::always_inline]] bool has_depth_limit(const PixelRect& rect) const {
    return limited_ != 0 && (blocks_of(rect) & ~limited_) == 0;
  }
  [[nodiscard]] float depth_limit(const PixelRect& rect) const {
    float greatest = -std::numeric_limits<float>::infinity();
    for (uint64_t rest = blocks_of(rect); rest != 0; rest &= rest - 1) {
      greatest = std::max(greatest, depth_limits_[static_cast<size_t>(std::countr_zero(rest))]);
    }
    return greatest;
  }

  // From a block's first pixel, loaded.
  [[gnu::always_inline]] Values block(int32_t x, int32_t y) {
    load(uint64_t{1} << block_number(x, y));
    return at(x, y);
  }

  // The blocks that a rectangle touches.
  [[gnu::always_inline]] void load(const PixelRect& rect) {
    if (loaded_ != ~uint64_t{0}) {
      load(blocks_of(rect));
    }
  }

  // What was drawn, to the attachments.
  void store() const {
    if (clears_) {
      for_each_rect(~loaded_, [&](const PixelRect& pixels) { clear_attachments(input_, pixels); });
    }
    for_each_rect(loaded_, [&](const PixelRect& pixels) { store(pixels); });
  }

 private:
  static constexpr uint32_t kBlocksInRow = kTileSize / kBlockSize;
  static_assert(kBlocksInRow == 8, "a tile's blocks are the bits of a word");

  [[nodiscard, gnu::always_inline]] uint32_t block_number(int32_t x, int32_t y) const {
    constexpr auto kSize = static_cast<uint32_t>(kBlockSize);
    return static_cast<uint32_t>(y - top_) / kSize * kBlocksInRow + static_cast<uint32_t>(x - left_) / kSize;
  }

  // Those that a rectangle touches, bit by bit.
  [[nodiscard, gnu::always_inline]] uint64_t blocks_of(const PixelRect& rect) const {
    const auto first = block_number(rect.left, rect.top);
    const auto last = block_number(rect.right - 1, rect.bottom - 1);
    constexpr uint64_t kFirstColumn = 0x0101010101010101U;
    const uint64_t columns = (2U << last % kBlocksInRow) - (1U << first % kBlocksInRow);
    const uint64_t rows = (kFirstColumn << (first & ~(kBlocksInRow - 1))) & (~uint64_t{0} >> (63U - last));
    return columns * rows;
  }

  [[gnu::always_inline]] void load(uint64_t blocks) {
    if ((blocks & ~loaded_) != 0) {
      load_missing(blocks & ~loaded_);
    }
  }

  [[gnu::noinline]] void load_missing(uint64_t blocks) {
    loaded_ |= blocks;
    for (; blocks != 0; blocks &= blocks - 1) {
      load_block(static_cast<uint32_t>(std::countr_zero(blocks)));
    }
  }

  // Blocks side by side are one rectangle: of long rows whole lines of the cache are written at once.
  template <typename Visit>
  void for_each_rect(uint64_t blocks, const Visit& visit) const {
    constexpr uint64_t kRow = 0xFF;
    for (uint32_t row = 0; row < kBlocksInRow; ++row) {
      const int32_t top = top_ + static_cast<int32_t>(row) * kBlockSize;
      for (uint64_t rest = blocks >> row * kBlocksInRow & kRow; rest != 0;) {
        const int32_t first = std::countr_zero(rest);
        const int32_t count = std::countr_one(rest >> static_cast<uint32_t>(first));
        rest &= ~uint64_t{0} << static_cast<uint32_t>(first + count);
        const int32_t left = left_ + first * kBlockSize;
        visit(PixelRect{left, top, left + count * kBlockSize, top + kBlockSize});
      }
    }
  }

  void load_block(uint32_t number) const {
    const int32_t x = left_ + static_cast<int32_t>(number % kBlocksInRow) * kBlockSize;
    const int32_t y = top_ + static_cast<int32_t>(number / kBlocksInRow) * kBlockSize;
    const PixelRect pixels{x, y, x + kBlockSize, y + kBlockSize};
    const Values values = at(x, y);
    if (uses_depth_) {
      load_rows(pixels, values.depths, input_.depth);
    }
    if (!input_.color.values.empty()) {
      load_rows(pixels, values.colors, input_.color);
    }
  }

  void store(const PixelRect& pixels) const {
    const Values values = at(pixels.left, pixels.top);
    if (uses_depth_) {
      copy_rows<true>(pixels, values.depths, input_.depth);
    } else if (clears_) {
      clear_rows(input_, pixels, input_.depth);
    }
    if (!input_.color.values.empty()) {
      copy_rows<true>(pixels, values.colors, input_.color);
    }
  }

  template <typename T, typename Buffer>
  void load_rows(const PixelRect& block, T* values, const Buffer& attachment) const {
    if (!clears_ || !attachment.clear) {
      copy_rows<false>(block, values, attachment);
      return;
    }
    for (int32_t row = 0; row < kBlockSize; ++row, values += kTileSize * input_.samples) {
      std::fill_n(values, kBlockSize * input_.samples, *attachment.clear);
    }
  }

  // Those of the pixels that are in the target; to the attachment or from it.
  template <bool kStore, typename T, typename Buffer>
  void copy_rows(const PixelRect& pixels, T* own, const Buffer& attachment) const {
    const auto column = static_cast<size_t>(pixels.left);
    const auto first_row = static_cast<size_t>(pixels.top);
    const size_t samples = input_.samples;
    const size_t width = input_.target_width;
    const size_t rows = std::min<size_t>(kBlockSize, input_.target_height - first_row);
    const size_t count = std::min(static_cast<size_t>(pixels.width()), width - column) * samples;
    T* values = attachment.values.data() + (first_row * width + column) * samples;
    for (size_t row = 0; row < rows; ++row, values += width * samples, own += kTileSize * samples) {
      if constexpr (kStore) {
        prefetch_row(attachment.values, ((first_row + kBlockSize + row) * width + column) * samples, count);
      }
      if (count == kBlockSize) {
        copy_values<kStore>(own, values, kBlockSize);  // of sizes that the compiler knows
      } else if (count == kTileSize) {
        copy_values<kStore>(own, values, kTileSize);
      } else {
        copy_values<kStore>(own, values, count);
      }
    }
  }

  template <bool kStore, typename T>
  [[gnu::always_inline]] static void copy_values(T* own, T* attachment, size_t count) {
    std::memcpy(kStore ? attachment : own, kStore ? own : attachment, count * sizeof(T));
  }

  const DrawInput& input_;
  int32_t left_;
  int32_t top_;
  bool uses_depth_;
  bool clears_;
  uint64_t loaded_ = 0;   // bit i: block i is here
  uint64_t limited_ = 0;  // bit i: block i has a limit of its depths
  float* depths_;
  uint32_t* colors_;
  std::array<float, kMaxBlocks> depth_limits_;
};

}  // namespace fillrule::renderer::internal
