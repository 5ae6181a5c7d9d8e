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
#include <span>
#include <vector>

#include "renderer/coverage.h"
#include "renderer/prepared_draw.h"

namespace fillrule::renderer::internal {

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
  for (auto row = static_cast<size_t>(pixels.top); row < bottom; ++row) {
    std::fill_n(attachment.values.begin() + static_cast<ptrdiff_t>((row * width + left) * input.samples),
                columns * input.samples, *attachment.clear);
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
  }

  // From a pixel whose block was loaded.
  [[nodiscard, gnu::always_inline]] Values at(int32_t x, int32_t y) const {
    const auto pixel = static_cast<size_t>((y - top_) * kTileSize + (x - left_));
    const size_t first = pixel * input_.samples;
    return {depths_ == nullptr ? nullptr : depths_ + first, colors_ == nullptr ? nullptr : colors_ + first};
  }

  // From a block's first pixel, loaded.
  [[gnu::always_inline]] Values block(int32_t x, int32_t y) {
    load(uint64_t{1} << block_number(x, y));
    return at(x, y);
  }

  // The blocks that a rectangle touches.
  [[gnu::always_inline]] void load(const PixelRect& rect) {
    const auto first = block_number(rect.left, rect.top);
    const auto last = block_number(rect.right - 1, rect.bottom - 1);
    constexpr uint64_t kFirstColumn = 0x0101010101010101U;
    const uint64_t columns = (2U << last % kBlocksInRow) - (1U << first % kBlocksInRow);
    const uint64_t rows = (kFirstColumn << (first & ~(kBlocksInRow - 1))) & (~uint64_t{0} >> (63U - last));
    load(columns * rows);
  }

  // What was drawn, to the attachments.
  void store() {
    if (clears_) {
      clear_rest();
    }
    for (uint64_t rest = loaded_; rest != 0; rest &= rest - 1) {
      copy<true>(static_cast<uint32_t>(std::countr_zero(rest)));
    }
  }

 private:
  static constexpr uint32_t kBlocksInRow = kTileSize / kBlockSize;
  static_assert(kBlocksInRow == 8, "a tile's blocks are the bits of a word");

  [[nodiscard, gnu::always_inline]] uint32_t block_number(int32_t x, int32_t y) const {
    return static_cast<uint32_t>((y - top_) / kBlockSize) * kBlocksInRow +
           static_cast<uint32_t>((x - left_) / kBlockSize);
  }

  [[gnu::always_inline]] void load(uint64_t blocks) {
    if ((blocks & ~loaded_) != 0) {
      load_missing(blocks & ~loaded_);
    }
  }

  [[gnu::noinline]] void load_missing(uint64_t blocks) {
    loaded_ |= blocks;
    for (; blocks != 0; blocks &= blocks - 1) {
      copy<false>(static_cast<uint32_t>(std::countr_zero(blocks)));
    }
  }

  // The blocks in which nothing was drawn, row by row of them.
  void clear_rest() const {
    constexpr uint64_t kRow = 0xFF;
    for (uint32_t row = 0; row < kBlocksInRow; ++row) {
      const uint64_t loaded = loaded_ >> row * kBlocksInRow & kRow;
      const int32_t top = top_ + static_cast<int32_t>(row) * kBlockSize;
      for (uint64_t rest = loaded ^ kRow; rest != 0;) {
        const int32_t first = std::countr_zero(rest);
        const int32_t count = std::countr_one(rest >> static_cast<uint32_t>(first));
        rest &= ~uint64_t{0} << static_cast<uint32_t>(first + count);
        const int32_t left = left_ + first * kBlockSize;
        clear_attachments(input_, {left, top, left + count * kBlockSize, top + kBlockSize});
      }
    }
  }

  // A block's pixels that are in the target; to the attachments or from them.
  template <bool kStore>
  void copy(uint32_t number) const {
    const int32_t x = left_ + static_cast<int32_t>(number % kBlocksInRow) * kBlockSize;
    const int32_t y = top_ + static_cast<int32_t>(number / kBlocksInRow) * kBlockSize;
    const Values values = at(x, y);
    if (uses_depth_) {
      copy_rows<kStore>(x, y, values.depths, input_.depth);
    } else if (kStore && clears_) {
      clear_rows(input_, {x, y, x + kBlockSize, y + kBlockSize}, input_.depth);
    }
    if (!input_.color.values.empty()) {
      copy_rows<kStore>(x, y, values.colors, input_.color);
    }
  }

  template <bool kStore, typename T, typename Buffer>
  void copy_rows(int32_t x, int32_t y, T* block, const Buffer& attachment) const {
    if (!kStore && clears_ && attachment.clear) {
      for (int32_t row = 0; row < kBlockSize; ++row, block += kTileSize * input_.samples) {
        std::fill_n(block, kBlockSize * input_.samples, *attachment.clear);
      }
      return;
    }
    const auto column = static_cast<size_t>(x);
    const size_t samples = input_.samples;
    const size_t width = input_.target_width;
    const size_t rows = std::min<size_t>(kBlockSize, input_.target_height - static_cast<size_t>(y));
    const size_t count = std::min<size_t>(kBlockSize, width - column) * samples;
    T* values = attachment.values.data() + (static_cast<size_t>(y) * width + column) * samples;
    for (size_t row = 0; row < rows; ++row, values += width * samples, block += kTileSize * samples) {
      if (count == kBlockSize) {
        copy_values<kStore>(block, values, kBlockSize);  // of a size that the compiler knows
      } else {
        copy_values<kStore>(block, values, count);
      }
    }
  }

  template <bool kStore, typename T>
  [[gnu::always_inline]] static void copy_values(T* block, T* attachment, size_t count) {
    std::memcpy(kStore ? attachment : block, kStore ? block : attachment, count * sizeof(T));
  }

  const DrawInput& input_;
  int32_t left_;
  int32_t top_;
  bool uses_depth_;
  bool clears_;
  uint64_t loaded_ = 0;  // bit i: block i is here
  float* depths_;
  uint32_t* colors_;
};

}  // namespace fillrule::renderer::internal
