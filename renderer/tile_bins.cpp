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

PixelRect TileGrid::pixels() const {
  return {tiles_.left * kTileSize, tiles_.top * kTileSize, tiles_.right * kTileSize, tiles_.bottom * kTileSize};
}

void PrimitiveChunk::clear() {
  count_ = 0;
  polygon_vertices_.clear();
  bin_entries_.clear();
  large_.clear();
}

void PrimitiveChunk::append_to(std::vector<TileEntry>& entries, uint32_t tile) const {
  const auto append = [&](uint32_t index) { entries.push_back({&room_[index], &polygon_vertices_}); };
  auto next_large = large_.begin();
  for (uint32_t i = bin_begins_[tile]; i < bin_begins_[tile + 1]; ++i) {
    for (; next_large != large_.end() && *next_large < bin_entries_[i]; ++next_large) {
      append(*next_large);
    }
    append(bin_entries_[i]);
  }
  std::for_each(next_large, large_.end(), append);
}

void PrimitiveChunk::sort_into(const TileGrid& grid) {
  const auto for_each_tile = [&](const PixelRect& tiles, const auto& visit) {
    if (tiles.width() == 1 && tiles.height() == 1) {
      visit(grid.index(tiles.left, tiles.top));
      return;
    }
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
  constexpr size_t kCostOfPrimitive = 64;
  const std::span<const SetupPrimitive> primitives = this->primitives();
  cost_ = kCostOfPrimitive * primitives.size();
  bin_begins_.assign(grid.count() + 1, 0);
  for (uint32_t i = 0; i < primitives.size(); ++i) {
    const PixelRect bounds = primitives[i].bounds();
    cost_ += static_cast<size_t>(bounds.width()) * static_cast<size_t>(bounds.height());
    const PixelRect tiles = grid.tiles(bounds);
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
  for (auto i = static_cast<uint32_t>(primitives.size()); i-- > 0;) {
    const PixelRect tiles = grid.tiles(primitives[i].bounds());
    if (!is_large(tiles)) {
      for_each_tile(tiles, [&](uint32_t tile) { bin_entries_[--bin_begins_[tile]] = i; });
    }
  }
}

}  // namespace fillrule::renderer
