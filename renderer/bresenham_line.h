// Bresenham lines (Vulkan, "Bresenham Line Segment Rasterization"): the diamond-exit rule, exactly.
//
// A pixel belongs to the line from a to b if the segment meets its diamond |x - x_centre| + |y - y_centre| < 1/2, and
// b is not within the diamond. Both ends are moved by (-e, -e^2), e infinitely small, first: so no end and no
// crossing lies on a border, and segments that share an end neither share nor lose a pixel there. All in exact
// integers.
//
// A line of width w is moved by (w - 1) / 2 px to the left or up, in its minor direction, and each of its pixels is
// the first of w in that direction.
#pragma once

#include <cstdint>

#include "renderer/coverage.h"
#include "renderer/fixed_point.h"

namespace fillrule::renderer {

// Snapped; at most 2^15 px from the origin, hence 2^23 subpixels and products below 2^50.
struct BresenhamLine {
  FixedPosition a;
  FixedPosition b;
  uint32_t width = 1;  // pixels
};

// The width that is drawn: the given one rounded to the nearest whole number, at least 1.
uint32_t bresenham_width(float line_width);

// Slopes from -1 to 1.
bool is_x_major(const BresenhamLine& line);

// A rectangle that holds all of the line's pixels.
PixelRect bounding_pixels(const BresenhamLine& line, uint32_t subpixel_bits);

// The pixels of `rect`, which must lie within one tile, that belong to the line.
void cover_by_diamond_exit(const BresenhamLine& line, uint32_t subpixel_bits, const PixelRect& rect,
                           TileCoverage& coverage);

}  // namespace fillrule::renderer
