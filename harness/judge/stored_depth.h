// What becomes of a piece's depth on its way into the depth attachment: clamped, then rounded to the format (Vulkan
// specification, "Depth Clamping and Range Adjustment", "Depth Test").
#pragma once

#include "cases/model/case.h"
#include "reference/exact/depth_format.h"
#include "reference/exact/piece_values.h"

namespace fillrule::judge {

// What depths are clamped to: the viewport's depth range under depth clamp, else [0, 1].
exact::DepthRange depth_limits(const RasterState& state);

// True where the specification leaves open what is stored: a depth beyond [0, 1] without depth clamp, in a format
// that can hold it.
bool leaves_range(const RasterState& state, VkFormat format, const exact::Expected& depth);

// What should be stored, with all that may be as spread. `depth` is the piece's, as PieceValues gives it.
exact::Expected expected_in(VkFormat format, const RasterState& state, const exact::Expected& depth);

// All that may be stored.
exact::DepthRange range_in(VkFormat format, const RasterState& state, const exact::Expected& depth);

// Whether depths are stored as they are interpolated, clamped to [0, 1] at most.
bool has_plain_depth(const RasterState& state, VkFormat format);

}  // namespace fillrule::judge
