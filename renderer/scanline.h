// Scanline fill: the same coverage as cover() of coverage.h, found row by row instead of by edge functions.
//
// Each triangle of the outline's fan is split at the height of its middle vertex into a part with a flat bottom and
// one with a flat top. A part lies between the triangle's long edge and one short edge; both are stepped down the
// rows in exact integers, and the pixels between them are one span. The samples of a part are those with
//   upper y <= y_sample < lower y      and      left x <= x_sample < right x
// which is the top-left rule: left and top edges belong to the triangle, right and bottom ones do not.
#pragma once

#include <cstdint>
#include <span>

#include "renderer/coverage.h"
#include "renderer/fixed_point.h"

namespace fillrule::renderer {

// The pixels of `rect`, which must lie within one tile, whose sample at `sample_fixed` (subpixels from the pixel's
// left top corner) the outline covers by the parity of its fan's triangles.
void cover_by_scanlines(std::span<const FixedPosition> outline, const FixedPosition& sample_fixed,
                        uint32_t subpixel_bits, const PixelRect& rect, TileCoverage& coverage);

}  // namespace fillrule::renderer
