#include "cases/format/space.h"

namespace fillrule::format {

Position clip_from(PositionSpace space, const Position& position, const RasterState& state) {
  if (space == PositionSpace::kClip) return position;
  auto [x, y, z, w] = position;
  if (space == PositionSpace::kFramebuffer) {
    const VkViewport& viewport = state.viewport;
    x = 2.0 * (x - double{viewport.x}) / double{viewport.width} - 1.0;
    y = 2.0 * (y - double{viewport.y}) / double{viewport.height} - 1.0;
    const double depth_range = double{viewport.maxDepth} - double{viewport.minDepth};
    const double fraction = (z - double{viewport.minDepth}) / depth_range;
    z = state.negative_one_to_one ? 2.0 * fraction - 1.0 : fraction;
    if (depth_range == 0.0) z = 0.5;
  }
  return {x * w, y * w, z * w, w};
}

}  // namespace fillrule::format
