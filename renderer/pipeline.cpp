#include "renderer/pipeline.h"

#include <algorithm>
#include <cmath>

#include "renderer/depth_bias.h"

namespace fillrule::renderer {

void build_chunk(const PreparedDraw& draw, const TileGrid& grid, const std::vector<ClipPosition>& positions_clip,
                 const std::vector<WindowVertex>& window_vertices, uint32_t first, uint32_t end,
                 PrimitiveChunk& chunk) {
  chunk.clear();
  const VertexDistances& distances = draw.input.clip_distances;
  for (uint32_t primitive = first; primitive < end; ++primitive) {
    const auto [a, b, c] = draw.assembly.triangle(primitive);
    const ClipDistances clip_distances =
        distances.count == 0 ? ClipDistances{} : ClipDistances{distances.of(a), distances.of(b), distances.of(c)};
    const auto triangle = setup_triangle(
        draw.setup, primitive, {positions_clip[a], positions_clip[b], positions_clip[c]},
        {window_vertices[a], window_vertices[b], window_vertices[c]}, clip_distances, chunk.polygon_vertices());
    if (triangle) {
      chunk.add(*triangle);
    }
  }
  chunk.sort_into(grid);
}

namespace {

// The greatest |depth| of the part of a triangle that the near and far planes leave.
double greatest_depth(const PreparedDraw& draw, const std::array<ClipPosition, 3>& positions_clip,
                      std::span<const FixedPosition> outline, const PrimitiveInterpolation& interpolation) {
  const RasterState& state = draw.input.state;
  const DepthTransform transform = depth_transform(state);
  const auto& [least, greatest] = std::minmax(state.viewport.minDepth, state.viewport.maxDepth);
  double result = 0;
  const auto include = [&, low = double{least}, high = double{greatest}](double depth) {
    const double limited = state.depth_clip ? std::clamp(depth, low, high) : depth;
    // To float32: the last bit of a double must not decide about the exponent.
    result = std::max(result, double{std::abs(static_cast<float>(limited))});
  };
  if (std::all_of(positions_clip.begin(), positions_clip.end(), [](const auto& one) { return one[3] > 0; })) {
    for (const ClipPosition& position : positions_clip) {
      include(double{position[2]} / double{position[3]} * transform.scale + transform.offset);
    }
    return result;
  }
  const double pixel = 1U << draw.subpixel_bits;
  for (const FixedPosition& vertex : outline) {
    include(interpolation.depth_framebuffer.at(vertex.x_fixed / pixel - 0.5 - interpolation.anchor_x,
                                               vertex.y_fixed / pixel - 0.5 - interpolation.anchor_y));
  }
  return result;
}

}  // namespace

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
  const RasterState& state = draw.input.state;
  const std::array<ClipPosition, 3> positions{positions_clip[vertices[0]], positions_clip[vertices[1]],
                                              positions_clip[vertices[2]]};
  PrimitiveInterpolation interpolation =
      make_interpolation(state.viewport, depth_transform(state), positions, anchor_x, anchor_y);
  if (state.depth_bias) {
    interpolation.depth_framebuffer.at_anchor +=
        depth_bias(*state.depth_bias, interpolation.depth_framebuffer, max_depth_code(draw.input.depth.format),
                   greatest_depth(draw, positions, outline, interpolation));
  }
  return interpolation;
}

}  // namespace fillrule::renderer
