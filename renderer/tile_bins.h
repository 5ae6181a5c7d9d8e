// Bins: for each tile the primitives that may touch it, in the order of submission. A tile's pixels belong to whoever
// draws the tile, so any number of threads gives the same result.
#pragma once

#include <algorithm>
#include <cstdint>
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
  // In tiles from the grid's first one; `pixels` must be within the grid's and not be empty.
  [[nodiscard]] PixelRect tiles(const PixelRect& pixels) const;
  [[nodiscard]] uint32_t index(int32_t column, int32_t row) const {
    return static_cast<uint32_t>(row * tiles_.width() + column);
  }

 private:
  PixelRect tiles_;
};

// Goes through the primitives that may touch a tile, in the order of submission.
class TileEntries {
 public:
  TileEntries(std::span<const SetupPrimitive> primitives, std::span<const uint32_t> binned,
              std::span<const uint32_t> large)
      : primitives_(primitives.data()), binned_(binned), large_(large) {}

  // The one that many after the next, as far as bins tell; null if they do not.
  [[nodiscard]] const SetupPrimitive* ahead(size_t count) const {
    return count < binned_.size() ? primitives_ + binned_[count] : nullptr;
  }

  // Null after the last.
  const SetupPrimitive* next() {
    if (binned_.empty() && large_.empty()) {
      return nullptr;
    }
    std::span<const uint32_t>& list =
        large_.empty() || (!binned_.empty() && binned_.front() < large_.front()) ? binned_ : large_;
    const uint32_t first = list.front();
    list = list.subspan(1);
    return primitives_ + first;
  }

 private:
  const SetupPrimitive* primitives_;
  std::span<const uint32_t> binned_;
  std::span<const uint32_t> large_;
};

// A run of consecutive primitives, set up and sorted into tiles.
class PrimitiveChunk {
 public:
  void clear();

  // Room for outlines that are no triangles.
  [[nodiscard]] std::vector<FixedPosition>& polygon_vertices() { return polygon_vertices_; }
  [[nodiscard]] const std::vector<FixedPosition>& polygon_vertices() const { return polygon_vertices_; }

  void add(const SetupPrimitive& primitive) { primitives_.push_back(primitive); }
  void sort_into(const TileGrid& grid);

  // An estimate: the areas of the bounding boxes in pixels, some more for each primitive.
  [[nodiscard]] size_t cost() const;

  // The primitives that may touch the tile.
  [[nodiscard]] TileEntries entries(uint32_t tile) const {
    return {primitives_,
            std::span(bin_entries_).subspan(bin_begins_[tile], bin_begins_[tile + 1] - bin_begins_[tile]), large_};
  }

 private:
  // A primitive in more tiles than this is looked at by every tile; so bins stay small.
  static constexpr uint32_t kMaxTilesInBins = 16;

  std::vector<SetupPrimitive> primitives_;
  std::vector<FixedPosition> polygon_vertices_;
  std::vector<uint32_t> bin_begins_;   // tile by tile, and the end of the last
  std::vector<uint32_t> bin_entries_;  // indices of primitives_, ascending within a tile
  std::vector<uint32_t> large_;        // likewise, those in no bin
};

}  // namespace fillrule::renderer
