#include "cases/format/space.h"

namespace fillrule::format {

Position clip_from(PositionSpace space, const Position& position, const VkViewport& viewport) {
  if (space == PositionSpace::kClip) return position;
  auto [x, y, z, w] = position;
  if (space == PositionSpace::kFramebuffer) {
    x = 2.0 * (x - double{viewport.x}) / double{viewport.width} - 1.0;
    y = 2.0 * (y - double{viewport.y}) / double{viewport.height} - 1.0;
    const double depth_range = double{viewport.maxDepth} - double{viewport.minDepth};
    z = depth_range == 0.0 ? 0.5 : (z - double{viewport.minDepth}) / depth_range;
  }
  return {x * w, y * w, z * w, w};
}

}  // namespace fillrule::format
