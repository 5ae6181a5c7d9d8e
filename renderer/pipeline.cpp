#include "renderer/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fillrule::renderer {
namespace {

// Vulkan's required limits, and those of the reference drivers: maxViewportDimensions, viewportBoundsRange.
constexpr float kMaxViewportSize = 16384;
constexpr float kMinViewportBound = -32768;
constexpr float kMaxViewportBound = 32767;

Result<void> check_viewport(const VkViewport& viewport) {
  const float height = std::abs(viewport.height);
  if (!(viewport.width > 0 && viewport.width <= kMaxViewportSize && height > 0 && height <= kMaxViewportSize)) {
    return failure(fmt::format("viewport of {} x {} pixels", viewport.width, viewport.height),
                   fmt::format("width above 0, height not 0, both at most {}", kMaxViewportSize));
  }
  const auto is_bound = [](float bound) { return bound >= kMinViewportBound && bound <= kMaxViewportBound; };
  if (!is_bound(viewport.x) || !is_bound(viewport.y) || !is_bound(viewport.x + viewport.width) ||
      !is_bound(viewport.y + viewport.height)) {
    return failure(fmt::format("viewport from ({}, {})", viewport.x, viewport.y),
                   fmt::format("all of it within {} to {}", kMinViewportBound, kMaxViewportBound));
  }
  const auto is_depth = [](float depth) { return depth >= 0 && depth <= 1; };
  if (!is_depth(viewport.minDepth) || !is_depth(viewport.maxDepth)) {
    return failure(fmt::format("viewport depth range {} to {}", viewport.minDepth, viewport.maxDepth),
                   "both within 0 to 1");
  }
  return {};
}

Result<void> check_vertices(const DrawInput& input) {
  switch (input.topology) {
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST:
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP:
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN:
      break;
    default:
      return failure(fmt::format("topology {}", static_cast<int>(input.topology)), "triangle list, strip or fan");
  }
  if (input.indices) {
    const auto last = std::max_element(input.indices->begin(), input.indices->end());
    if (last != input.indices->end() && *last >= input.vertex_count) {
      return failure(fmt::format("index {} in a draw of {} vertices", *last, input.vertex_count));
    }
  }
  return {};
}

Result<void> check(const DrawInput& input, const Options& options) {
  if (options.subpixel_bits < kMinSubpixelBits || options.subpixel_bits > kMaxSubpixelBits) {
    return failure(fmt::format("{} subpixel bits", options.subpixel_bits),
                   fmt::format("{} to {}", kMinSubpixelBits, kMaxSubpixelBits));
  }
  if (input.target_width == 0 || input.target_width > kMaxTargetSize || input.target_height == 0 ||
      input.target_height > kMaxTargetSize) {
    return failure(fmt::format("target of {} x {} pixels", input.target_width, input.target_height),
                   fmt::format("1 to {}", kMaxTargetSize));
  }
  const size_t depth_values = input.depth.values.size();
  if (depth_values != 0 && depth_values != size_t{input.target_width} * input.target_height) {
    return failure(fmt::format("a depth buffer of {} values for a target of {} x {} pixels", depth_values,
                               input.target_width, input.target_height));
  }
  return check_viewport(input.state.viewport).and_then([&] { return check_vertices(input); });
}

// The scissor's part of the target; its end may be beyond 2^31.
PixelRect scissor_pixels(const VkRect2D& scissor, uint32_t width, uint32_t height) {
  const auto clamped = [](int64_t value, uint32_t limit) {
    return static_cast<int32_t>(std::clamp<int64_t>(value, 0, limit));
  };
  return {clamped(scissor.offset.x, width), clamped(scissor.offset.y, height),
          clamped(int64_t{scissor.offset.x} + scissor.extent.width, width),
          clamped(int64_t{scissor.offset.y} + scissor.extent.height, height)};
}

}  // namespace

Result<PreparedDraw> prepare_draw(const DrawInput& input, const Options& options) {
  if (const Result<void> checked = check(input, options); !checked) {
    return tl::unexpected(checked.error());
  }
  const RasterState& state = input.state;
  const WindowTransform transform(state.viewport, options.subpixel_bits);
  const PixelRect viewport_pixels = transform.viewport_pixels();
  const uint32_t elements = input.indices ? static_cast<uint32_t>(input.indices->size()) : input.vertex_count;
  PreparedDraw prepared{
      .input = input,
      .subpixel_bits = options.subpixel_bits,
      .primitive_count = triangle_count(input.topology, elements),
      .viewport_pixels = viewport_pixels,
      .setup = {.transform = transform,
                .cull_mode = state.cull_mode,
                .front_face = state.front_face,
                .clip_pixels = intersection(viewport_pixels,
                                            scissor_pixels(state.scissor, input.target_width, input.target_height))}};
  // Without a depth attachment the depth test passes (Vulkan, "Depth Test").
  prepared.input.state.depth_test = state.depth_test && !input.depth.values.empty();
  return prepared;
}

void build_chunk(const PreparedDraw& draw, const TileGrid& grid, const std::vector<ClipPosition>& positions_clip,
                 const std::vector<WindowVertex>& window_vertices, uint32_t first, uint32_t end,
                 TriangleChunk& chunk) {
  chunk.clear();
  for (uint32_t primitive = first; primitive < end; ++primitive) {
    const auto [a, b, c] = triangle_vertices(draw.input.topology, draw.input.indices, primitive);
    const auto triangle =
        setup_triangle(draw.setup, primitive, {positions_clip[a], positions_clip[b], positions_clip[c]},
                       {window_vertices[a], window_vertices[b], window_vertices[c]}, chunk.polygon_vertices());
    if (triangle) {
      chunk.add(*triangle);
    }
  }
  chunk.sort_into(grid);
}

TriangleInterpolation make_interpolation(const PreparedDraw& draw, const std::array<uint32_t, 3>& vertices,
                                         const std::vector<ClipPosition>& positions_clip,
                                         std::span<const FixedPosition> outline) {
  // The anchor must not depend on what does not belong to the triangle: not on scissor, target or tile.
  FixedPosition corner = outline[0];
  for (const FixedPosition& vertex : outline) {
    corner.x_fixed = std::min(corner.x_fixed, vertex.x_fixed);
    corner.y_fixed = std::min(corner.y_fixed, vertex.y_fixed);
  }
  const PixelRect& limits = draw.viewport_pixels;
  const int32_t anchor_x = std::clamp(corner.x_fixed >> draw.subpixel_bits, limits.left, limits.right);
  const int32_t anchor_y = std::clamp(corner.y_fixed >> draw.subpixel_bits, limits.top, limits.bottom);
  return make_interpolation(draw.input.state.viewport,
                            {positions_clip[vertices[0]], positions_clip[vertices[1]], positions_clip[vertices[2]]},
                            anchor_x, anchor_y);
}

}  // namespace fillrule::renderer
