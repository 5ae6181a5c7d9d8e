#include "renderer/tile_bins.h"

namespace fillrule::renderer {

TileGrid::TileGrid(const PixelRect& pixels)
    : tiles_{pixels.left / kTileSize, pixels.top / kTileSize, (pixels.right + kTileSize - 1) / kTileSize,
             (pixels.bottom + kTileSize - 1) / kTileSize} {}

PixelRect TileGrid::pixels(uint32_t tile) const {
  const int32_t columns = tiles_.width();
  const int32_t left = (tiles_.left + static_cast<int32_t>(tile) % columns) * kTileSize;
  const int32_t top = (tiles_.top + static_cast<int32_t>(tile) / columns) * kTileSize;
  return {left, top, left + kTileSize, top + kTileSize};
}

PixelRect TileGrid::tiles(const PixelRect& pixels) const {
  return {pixels.left / kTileSize - tiles_.left, pixels.top / kTileSize - tiles_.top,
          (pixels.right - 1) / kTileSize + 1 - tiles_.left, (pixels.bottom - 1) / kTileSize + 1 - tiles_.top};
}

void PrimitiveChunk::clear() {
  primitives_.clear();
  polygon_vertices_.clear();
  bin_entries_.clear();
  large_.clear();
}

size_t PrimitiveChunk::cost() const {
  constexpr size_t kCostOfPrimitive = 64;
  size_t sum = 0;
  for (const SetupPrimitive& primitive : primitives_) {
    const PixelRect bounds = primitive.bounds();
    sum += static_cast<size_t>(bounds.width()) * static_cast<size_t>(bounds.height()) + kCostOfPrimitive;
  }
  return sum;
}

void PrimitiveChunk::sort_into(const TileGrid& grid) {
  const auto for_each_tile = [&](const PixelRect& tiles, const auto& visit) {
    for (int32_t row = tiles.top; row < tiles.bottom; ++row) {
      for (int32_t column = tiles.left; column < tiles.right; ++column) {
        visit(grid.index(column, row));
      }
    }
  };
  const auto is_large = [](const PixelRect& tiles) {
    return static_cast<uint32_t>(tiles.width() * tiles.height()) > kMaxTilesInBins;
  };

  // Step 1: the size of each bin.
  bin_begins_.assign(grid.count() + 1, 0);
  for (uint32_t i = 0; i < primitives_.size(); ++i) {
    const PixelRect tiles = grid.tiles(primitives_[i].bounds());
    if (is_large(tiles)) {
      large_.push_back(i);
    } else {
      for_each_tile(tiles, [&](uint32_t tile) { ++bin_begins_[tile]; });
    }
  }
  // Step 2: the end of each bin; filling it from the last primitive to the first turns it into its beginning.
  uint32_t sum = 0;
  for (uint32_t& begin : bin_begins_) {
    sum += begin;
    begin = sum;
  }
  bin_entries_.resize(sum);
  for (auto i = static_cast<uint32_t>(primitives_.size()); i-- > 0;) {
    const PixelRect tiles = grid.tiles(primitives_[i].bounds());
    if (!is_large(tiles)) {
      for_each_tile(tiles, [&](uint32_t tile) { bin_entries_[--bin_begins_[tile]] = i; });
    }
  }
}

}  // namespace fillrule::renderer
