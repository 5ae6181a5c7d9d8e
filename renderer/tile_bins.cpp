#include "renderer/tile_bins.h"

namespace fillrule::renderer {
namespace {

constexpr uint32_t kRowsOfBand = 2;

}  // namespace

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

uint32_t TileGrid::thread_of_row(int32_t y, uint32_t threads) const {
  const int32_t row = std::clamp(y / kTileSize - tiles_.top, 0, tiles_.height() - 1);
  return static_cast<uint32_t>(row) / kRowsOfBand % threads;
}

uint32_t TileGrid::in_bands(uint32_t number, uint32_t threads) const {
  const auto columns = static_cast<uint32_t>(tiles_.width());
  const auto rows = static_cast<uint32_t>(tiles_.height());
  const uint32_t rows_of_all = kRowsOfBand * threads;
  if (number >= rows / rows_of_all * rows_of_all * columns) {
    return number;  // below the last bands of all threads, row by row
  }
  const uint32_t of_thread = number / threads;
  const uint32_t band = of_thread / (kRowsOfBand * columns) * threads + number % threads;
  const uint32_t in_band = of_thread % (kRowsOfBand * columns);
  return (band * kRowsOfBand + in_band % kRowsOfBand) * columns + in_band / kRowsOfBand;
}

void PrimitiveChunk::clear() {
  count_ = 0;
  polygon_vertices_.clear();
  bin_entries_.clear();
  large_.clear();
}

TileEntry* PrimitiveChunk::write_entries(uint32_t tile, TileEntry* entries) const {
  const auto write = [&](uint32_t index) { *entries++ = {&room_[index], &polygon_vertices_}; };
  auto next_large = large_.begin();
  for (uint32_t i = bin_begins_[tile]; i < bin_begins_[tile + 1]; ++i) {
    for (; next_large != large_.end() && *next_large < bin_entries_[i]; ++next_large) {
      write(*next_large);
    }
    write(bin_entries_[i]);
  }
  std::for_each(next_large, large_.end(), write);
  return entries;
}

void PrimitiveChunk::sort_into(const TileGrid& grid) {
  // Step 1: the size of each bin. What touches one tile, as most do, is not asked again.
  constexpr size_t kCostOfPrimitive = 64;
  const std::span<const SetupPrimitive> primitives = this->primitives();
  cost_ = kCostOfPrimitive * primitives.size();
  bin_begins_.assign(grid.count() + 1, 0);
  static thread_local std::vector<uint32_t> only_tiles;  // of each primitive; or kSeveralTiles, kNoBin
  only_tiles.resize(primitives.size());
  for (uint32_t i = 0; i < primitives.size(); ++i) {
    const PixelRect bounds = primitives[i].bounds();
    cost_ += static_cast<size_t>(bounds.width()) * static_cast<size_t>(bounds.height());
    const PixelRect tiles = grid.tiles(bounds);
    const auto count = static_cast<uint32_t>(tiles.width() * tiles.height());
    if (count == 1) {
      only_tiles[i] = grid.index(tiles.left, tiles.top);
      ++bin_begins_[only_tiles[i]];
    } else if (count > kMaxTilesInBins) {
      only_tiles[i] = kNoBin;
      large_.push_back(i);
    } else {
      only_tiles[i] = kSeveralTiles;
      grid.for_each(tiles, [&](uint32_t tile) { ++bin_begins_[tile]; });
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
    const auto put = [&](uint32_t tile) { bin_entries_[--bin_begins_[tile]] = i; };
    if (only_tiles[i] == kSeveralTiles) {
      grid.for_each(grid.tiles(primitives[i].bounds()), put);
    } else if (only_tiles[i] != kNoBin) {
      put(only_tiles[i]);
    }
  }
}

}  // namespace fillrule::renderer
