// The part of the attachments that one tile owns, block by block, while it is drawn.
//
// Rows of a wide attachment are so far apart that those of one tile fall on the same few lines of a cache. So a
// block's values are copied out when it is first touched and back when the tile is done; in between the tile's rows
// follow each other, and no row of lanes can reach beyond the target.
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

  TileAttachments(const PreparedDraw& draw, const PixelRect& tile_pixels, Storage& storage)
      : input_(draw.input), left_(tile_pixels.left), top_(tile_pixels.top), uses_depth_(draw.depth.tests()) {
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

  // A block's pixels that are in the target; to the attachments or from them.
  template <bool kStore>
  void copy(uint32_t number) const {
    const int32_t x = left_ + static_cast<int32_t>(number % kBlocksInRow) * kBlockSize;
    const int32_t y = top_ + static_cast<int32_t>(number / kBlocksInRow) * kBlockSize;
    const Values values = at(x, y);
    if (uses_depth_) {
      copy_rows<kStore>(x, y, values.depths, input_.depth.values);
    }
    if (!input_.color.values.empty()) {
      copy_rows<kStore>(x, y, values.colors, input_.color.values);
    }
  }

  template <bool kStore, typename T>
  void copy_rows(int32_t x, int32_t y, T* block, std::span<T> attachment) const {
    const auto column = static_cast<size_t>(x);
    const size_t samples = input_.samples;
    const size_t width = input_.target_width;
    const size_t rows = std::min<size_t>(kBlockSize, input_.target_height - static_cast<size_t>(y));
    const size_t count = std::min<size_t>(kBlockSize, width - column) * samples;
    T* values = attachment.data() + (static_cast<size_t>(y) * width + column) * samples;
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
  uint64_t loaded_ = 0;  // bit i: block i is here
  float* depths_;
  uint32_t* colors_;
};

}  // namespace fillrule::renderer::internal
