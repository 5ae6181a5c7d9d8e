// A batch of triangles on its way through a draw: each in a cell of its own, the cells side by side in one large
// target, so that a million of them are one draw.
//
// Target sizes are powers of two: then a clip-space coordinate, k * 2 / (target_size * grid) - 1 with k grid steps
// from the target's corner, is exact in float32, and so is its way back to the framebuffer. The outermost ring of
// cells stays empty, so that what leaves its cell shows wherever the cell is.
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <vector>

#include "harness/exhaust/world.h"
#include "reference/exact/small_world.h"

namespace fillrule::exhaust {

struct Pixel {
  uint32_t x = 0;
  uint32_t y = 0;
};

// Clip space, (x, y); z is 0.5 and w is 1.
using PlanePosition = std::array<float, 2>;

class CellLayout {
 public:
  // `target_size` is a power of two, large enough for a cell within its ring.
  CellLayout(const World& world, uint32_t target_size);

  // The target that holds about a million cells.
  static uint32_t default_target_size(uint32_t cell_size);

  [[nodiscard]] uint32_t target_size() const { return target_size_; }
  [[nodiscard]] uint32_t cell_size() const { return cell_size_; }
  // Without the ring.
  [[nodiscard]] uint32_t cells_in_row() const { return cells_in_row_; }
  [[nodiscard]] uint32_t capacity() const { return cells_in_row_ * cells_in_row_; }
  [[nodiscard]] Pixel origin(uint32_t cell) const {
    return {(cell % cells_in_row_ + 1) * cell_size_, (cell / cells_in_row_ + 1) * cell_size_};
  }
  // The pixel's corner, and so many grid steps further.
  [[nodiscard]] PlanePosition position(const Pixel& pixel, const exact::GridPosition& at) const {
    const auto clip_from = [this](uint32_t pixels, uint32_t steps) {
      return static_cast<float>(pixels * grid_ + steps) * scale_ - 1.0F;
    };
    return {clip_from(pixel.x, at.x), clip_from(pixel.y, at.y)};
  }

 private:
  uint32_t grid_;
  uint32_t cell_size_;
  uint32_t target_size_;
  uint32_t cells_in_row_;
  float scale_;  // clip-space units in a grid step
};

// The bytes of a cell, row by row: hits in the low four bits, those of front faces in the high four.
using CellHits = std::array<uint8_t, size_t{exact::kMaxCellSize} * exact::kMaxCellSize>;

// What the oracle says of a triangle: one hit for each covered pixel, a counter-clockwise triangle being in front,
// nothing where it is culled.
CellHits expected_hits(const exact::WoundCoverage& coverage, uint32_t cell_size, VkCullModeFlags cull_mode);

struct Batch {
  uint64_t first = 0;  // number of the first triple
  uint32_t triangles = 0;
  uint32_t covering = 0;                      // triangles that cover a pixel
  std::vector<PlanePosition> positions_clip;  // three for each triangle
  std::vector<uint8_t> expected;              // the target's bytes, row by row
};

// Fills the batch with the triangles [first, first + triangles), at most layout.capacity() of them.
void fill(const World& world, const exact::SmallWorld& oracle, const CellLayout& layout, VkCullModeFlags cull_mode,
          uint64_t first, uint32_t triangles, Batch& batch);

}  // namespace fillrule::exhaust
