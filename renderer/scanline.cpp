#include "renderer/scanline.h"

#include <algorithm>
#include <utility>

#include "renderer/row_masks.h"
#include "renderer/stepped_quotient.h"

namespace fillrule::renderer {
namespace {

struct SampleGrid {
  FixedPosition sample_fixed;
  uint32_t subpixel_bits;
};

// The first row whose samples are at or below y.
int32_t first_row(const SampleGrid& grid, int32_t y_fixed) {
  return first_pixel(y_fixed, grid.sample_fixed.y_fixed, grid.subpixel_bits);
}

// Row by row from `row`, the first column whose sample is at or to the right of the edge from `upper` to `lower`. The
// edge must go down. With the pixel P and the sample s
//   column = ceil((x_edge - s.x) / P) = ceil(N / (dy * P)),  N = (upper.x - s.x) * dy + (row * P + s.y - upper.y) *
//   dx
// and since N steps by dx * P, ceil(ceil(N / P) / dy) is the same and has numbers a P smaller. |N| < 2^61.
SteppedQuotient edge_columns(const SampleGrid& grid, const FixedPosition& upper, const FixedPosition& lower,
                             int32_t row) {
  const int64_t dx = int64_t{lower.x_fixed} - upper.x_fixed;
  const int64_t dy = int64_t{lower.y_fixed} - upper.y_fixed;
  const int64_t pixel = int64_t{1} << grid.subpixel_bits;
  const int64_t y_from_upper = row * pixel + grid.sample_fixed.y_fixed - upper.y_fixed;
  const int64_t numerator = (int64_t{upper.x_fixed} - grid.sample_fixed.x_fixed) * dy + y_from_upper * dx;
  const int64_t in_pixels = (numerator + pixel - 1) >> grid.subpixel_bits;
  return {in_pixels + dy - 1, dx, dy};
}

// The part of a triangle between the heights of two of its vertices, which a short edge joins; `top` and `bottom` are
// the ends of its long edge.
void fill_part(const SampleGrid& grid, const FixedPosition& top, const FixedPosition& bottom,
               const FixedPosition& upper, const FixedPosition& lower, const PixelRect& rect, RowMasks& masks) {
  const int32_t first = std::max(first_row(grid, upper.y_fixed), rect.top);
  const int32_t end = std::min(first_row(grid, lower.y_fixed), rect.bottom);
  if (first >= end) {
    return;
  }
  SteppedQuotient long_edge = edge_columns(grid, top, bottom, first);
  SteppedQuotient short_edge = edge_columns(grid, upper, lower, first);
  for (int32_t row = first; row < end; ++row) {
    const auto [left, right] = std::minmax({long_edge.value(), short_edge.value()});
    masks.flip(row, left, right);
    long_edge.step();
    short_edge.step();
  }
}

void fill_triangle(const SampleGrid& grid, std::array<FixedPosition, 3> triangle, const PixelRect& rect,
                   RowMasks& masks) {
  std::sort(triangle.begin(), triangle.end(), [](const auto& a, const auto& b) { return a.y_fixed < b.y_fixed; });
  const auto& [top, middle, bottom] = triangle;
  fill_part(grid, top, bottom, top, middle, rect, masks);     // with a flat bottom
  fill_part(grid, top, bottom, middle, bottom, rect, masks);  // with a flat top
}

}  // namespace

void cover_by_scanlines(std::span<const FixedPosition> outline, const FixedPosition& sample_fixed,
                        uint32_t subpixel_bits, const PixelRect& rect, TileCoverage& coverage) {
  const SampleGrid grid{sample_fixed, subpixel_bits};
  RowMasks masks(rect);
  for (size_t i = 2; i < outline.size(); ++i) {
    fill_triangle(grid, {outline[0], outline[i - 1], outline[i]}, rect, masks);
  }
  masks.to_blocks(coverage);
}

}  // namespace fillrule::renderer
