// The part of the attachments that one tile owns, block by block, while it is drawn.
//
// Rows of a wide attachment are so far apart that those of one tile fall on the same few lines of a cache. So a
// block's values are copied out when it is first touched and back when the tile is done; in between they lie side by
// side, and no row of lanes can reach beyond the target.
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
  // A block's values: (y * kBlockSize + x) * samples + sample, from its first pixel. Only of attachments in use.
  struct Block {
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
    const size_t values = size_t{kTileSize} * kTileSize * input_.samples;
    if (uses_depth_ && storage.depths.size() < values) {
      storage.depths.resize(values);
    }
    if (!input_.color.values.empty() && storage.colors.size() < values) {
      storage.colors.resize(values);
    }
    depths_ = storage.depths.data();
    colors_ = storage.colors.data();
  }

  [[gnu::always_inline]] Block block(int32_t x, int32_t y) {
    const auto number = static_cast<uint32_t>((y - top_) / kBlockSize * kBlocksInRow + (x - left_) / kBlockSize);
    const size_t first = size_t{number} * kBlockSize * kBlockSize * input_.samples;
    const Block block = block_from(first);
    if ((loaded_ >> number & 1U) == 0) {
      loaded_ |= uint64_t{1} << number;
      copy<false>(x, y, block);
    }
    return block;
  }

  // What was drawn, to the attachments.
  void store() {
    for (uint64_t rest = loaded_; rest != 0; rest &= rest - 1) {
      const int32_t number = std::countr_zero(rest);
      const size_t first = static_cast<size_t>(number) * kBlockSize * kBlockSize * input_.samples;
      copy<true>(left_ + number % kBlocksInRow * kBlockSize, top_ + number / kBlocksInRow * kBlockSize,
                 block_from(first));
    }
  }

 private:
  static constexpr int32_t kBlocksInRow = kTileSize / kBlockSize;

  [[nodiscard]] Block block_from(size_t first) const {
    return {depths_ == nullptr ? nullptr : depths_ + first, colors_ == nullptr ? nullptr : colors_ + first};
  }

  // A block's pixels that are in the target; to the attachments or from them.
  template <bool kStore>
  void copy(int32_t x, int32_t y, const Block& block) const {
    if (uses_depth_) {
      copy_rows<kStore>(x, y, block.depths, input_.depth.values);
    }
    if (!input_.color.values.empty()) {
      copy_rows<kStore>(x, y, block.colors, input_.color.values);
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
    for (size_t row = 0; row < rows; ++row, values += width * samples, block += kBlockSize * samples) {
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
