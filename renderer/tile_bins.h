// Bins: for each tile the primitives that may touch it, in the order of submission. A tile's pixels belong to whoever
// draws the tile, so any number of threads gives the same result.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "renderer/coverage.h"
#include "renderer/fixed_point.h"
#include "renderer/primitive_setup.h"

namespace fillrule::renderer {

// The tiles that a rectangle of pixels touches, row by row.
class TileGrid {
 public:
  explicit TileGrid(const PixelRect& pixels);
  [[nodiscard]] uint32_t count() const { return static_cast<uint32_t>(tiles_.width() * tiles_.height()); }
  [[nodiscard]] PixelRect pixels(uint32_t tile) const;
  // Of all tiles, which may reach beyond the target.
  [[nodiscard]] PixelRect pixels() const;
  // In tiles from the grid's first one; `pixels` must be within the grid's and not be empty.
  [[nodiscard]] PixelRect tiles(const PixelRect& pixels) const {
    const auto tile = [](int32_t pixel) { return static_cast<int32_t>(static_cast<uint32_t>(pixel) / kTileSize); };
    return {tile(pixels.left) - tiles_.left, tile(pixels.top) - tiles_.top, tile(pixels.right - 1) + 1 - tiles_.left,
            tile(pixels.bottom - 1) + 1 - tiles_.top};
  }
  [[nodiscard]] uint32_t index(int32_t column, int32_t row) const {
    return static_cast<uint32_t>(row * tiles_.width() + column);
  }
  // The tiles in another order, each number below count() being one, for threads that take every threads-th of them
  // (worker_pool.h): a thread then gets bands of two rows, and goes along them. What touches several tiles is mostly
  // still in its processor's cache when the next one needs it.
  [[nodiscard]] uint32_t in_bands(uint32_t number, uint32_t threads) const;
  // The thread whose band a row of pixels is in, where all threads have bands.
  [[nodiscard]] uint32_t thread_of_row(int32_t y, uint32_t threads) const;
  // Of such a rectangle of tiles.
  template <typename Visit>
  void for_each(const PixelRect& tiles, const Visit& visit) const {
    for (int32_t row = tiles.top; row < tiles.bottom; ++row) {
      for (int32_t column = tiles.left; column < tiles.right; ++column) {
        visit(index(column, row));
      }
    }
  }

 private:
  PixelRect tiles_;
};

// A primitive of a chunk that may touch a tile.
struct TileEntry {
  const SetupPrimitive* primitive;
  const std::vector<FixedPosition>* polygon_vertices;  // of its chunk
};

// A run of consecutive primitives, set up and sorted into tiles.
class PrimitiveChunk {
 public:
  // `room`: for all primitives that it will hold at once.
  explicit PrimitiveChunk(std::span<SetupPrimitive> room) : room_(room) {}

  void clear();

  // Room for outlines that are no triangles.
  [[nodiscard]] std::vector<FixedPosition>& polygon_vertices() { return polygon_vertices_; }
  [[nodiscard]] const std::vector<FixedPosition>& polygon_vertices() const { return polygon_vertices_; }

  SetupPrimitive& append() { return room_[count_++] = {}; }
  void sort_into(const TileGrid& grid);

  // An estimate, once it is sorted: the areas of the bounding boxes in pixels, some more for each primitive.
  [[nodiscard]] size_t cost() const { return cost_; }

  // Asks for where a tile's bin begins, and for what is in it once that has arrived.
  void prefetch_bin(uint32_t tile) const { __builtin_prefetch(&bin_begins_[tile]); }
  void prefetch_entries(uint32_t tile) const { __builtin_prefetch(bin_entries_.data() + bin_begins_[tile]); }

  // The primitives that may touch the tile, in the order of submission: how many, and to where there is room for
  // them; behind the last.
  [[nodiscard]] size_t entry_count(uint32_t tile) const {
    return bin_begins_[tile + 1] - bin_begins_[tile] + large_.size();
  }
  TileEntry* write_entries(uint32_t tile, TileEntry* entries) const;

 private:
  // A primitive in more tiles than this is looked at by every tile; so bins stay small.
  static constexpr uint32_t kMaxTilesInBins = 16;
  // What sorting notes in place of a tile.
  static constexpr uint32_t kSeveralTiles = std::numeric_limits<uint32_t>::max();
  static constexpr uint32_t kNoBin = kSeveralTiles - 1;

  [[nodiscard]] std::span<const SetupPrimitive> primitives() const { return room_.first(count_); }

  std::span<SetupPrimitive> room_;
  uint32_t count_ = 0;
  std::vector<FixedPosition> polygon_vertices_;
  std::vector<uint32_t> bin_begins_;   // tile by tile, and the end of the last
  std::vector<uint32_t> bin_entries_;  // indices of primitives, ascending within a tile
  std::vector<uint32_t> large_;        // likewise, those in no bin
  size_t cost_ = 0;
};

}  // namespace fillrule::renderer
