#include "renderer/pipeline.h"

#include <algorithm>

namespace fillrule::renderer {

void build_chunk(const PreparedDraw& draw, const TileGrid& grid, const std::vector<ClipPosition>& positions_clip,
                 const std::vector<WindowVertex>& window_vertices, uint32_t first, uint32_t end,
                 PrimitiveChunk& chunk) {
  chunk.clear();
  for (uint32_t primitive = first; primitive < end; ++primitive) {
    const auto [a, b, c] = draw.assembly.triangle(primitive);
    const auto triangle =
        setup_triangle(draw.setup, primitive, {positions_clip[a], positions_clip[b], positions_clip[c]},
                       {window_vertices[a], window_vertices[b], window_vertices[c]}, chunk.polygon_vertices());
    if (triangle) {
      chunk.add(*triangle);
    }
  }
  chunk.sort_into(grid);
}

PrimitiveInterpolation make_interpolation(const PreparedDraw& draw, const std::array<uint32_t, 3>& vertices,
                                          const std::vector<ClipPosition>& positions_clip,
                                          std::span<const FixedPosition> outline) {
  // The anchor must not depend on what does not belong to the primitive: not on scissor, target or tile.
  FixedPosition corner = outline[0];
  for (const FixedPosition& vertex : outline) {
    corner.x_fixed = std::min(corner.x_fixed, vertex.x_fixed);
    corner.y_fixed = std::min(corner.y_fixed, vertex.y_fixed);
  }
  const PixelRect& limits = draw.viewport_pixels;
  const int32_t anchor_x = std::clamp(corner.x_fixed >> draw.subpixel_bits, limits.left, limits.right);
  const int32_t anchor_y = std::clamp(corner.y_fixed >> draw.subpixel_bits, limits.top, limits.bottom);
  return make_interpolation(draw.input.state.viewport, depth_transform(draw.input.state),
                            {positions_clip[vertices[0]], positions_clip[vertices[1]], positions_clip[vertices[2]]},
                            anchor_x, anchor_y);
}

}  // namespace fillrule::renderer
