// The pixels of one tile as rows of bits: what is filled span by span.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "renderer/coverage.h"

namespace fillrule::renderer {

// Rows and columns are pixels of the framebuffer; all of `rect` must lie within one tile.
class RowMasks {
 public:
  explicit RowMasks(const PixelRect& rect)
      : rect_(rect), left_(rect.left & ~(kTileSize - 1)), top_(rect.top & ~(kTileSize - 1)) {}

  // Turns over the pixels [begin, end) of a row, as far as they are in the rectangle.
  void flip(int32_t row, int64_t begin, int64_t end) { rows_[index(row)] ^= span(begin, end); }

  // Sets them.
  void set(int32_t row, int64_t begin, int64_t end) { rows_[index(row)] |= span(begin, end); }

  // Adds the blocks that have a pixel in them.
  void to_blocks(TileCoverage& coverage) const {
    for (int32_t y = 0; y < kTileSize; y += kBlockSize) {
      for (int32_t x = 0; x < kTileSize; x += kBlockSize) {
        const uint64_t mask = block_mask(x, y);
        if (mask != 0) {
          coverage.blocks[coverage.count++] = {left_ + x, top_ + y, mask};
        }
      }
    }
  }

 private:
  static_assert(kTileSize == 64 && kBlockSize == 8, "a row of a tile is one word, a row of a block one byte");

  [[nodiscard]] size_t index(int32_t row) const { return static_cast<size_t>(row - top_); }

  [[nodiscard]] uint64_t span(int64_t begin, int64_t end) const {
    const int64_t first = std::max<int64_t>(begin, rect_.left) - left_;
    const int64_t last = std::min<int64_t>(end, rect_.right) - left_ - 1;
    if (first > last) {
      return 0;
    }
    return (~uint64_t{0} << static_cast<uint32_t>(first)) & (~uint64_t{0} >> static_cast<uint32_t>(63 - last));
  }

  [[nodiscard]] uint64_t block_mask(int32_t x, int32_t y) const {
    uint64_t mask = 0;
    for (uint32_t row = 0; row < kBlockSize; ++row) {
      const uint64_t bits = rows_[static_cast<size_t>(y) + row] >> static_cast<uint32_t>(x) & 0xFFU;
      mask |= bits << (row * kBlockSize);
    }
    return mask;
  }

  PixelRect rect_;
  int32_t left_;  // the tile's corner
  int32_t top_;
  std::array<uint64_t, kTileSize> rows_{};
};

}  // namespace fillrule::renderer
