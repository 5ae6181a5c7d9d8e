#include "renderer/line_point_setup.h"

#include "renderer/bresenham_line.h"
#include "renderer/line_clip.h"
#include "renderer/outlines.h"

namespace fillrule::renderer {
namespace {

// The planes of the view volume, its sides and near and far where those clip, and the user's half-spaces.
struct ClipVolume {
  std::array<EndDistances, kClipPlanes + kMaxClipAndCullDistances> planes;
  uint32_t count = 0;

  void add(const DoubleDouble& distance_from, const DoubleDouble& distance_to) {
    planes[count++] = {distance_from, distance_to};
  }
  [[nodiscard]] std::span<const EndDistances> span() const { return {planes.data(), count}; }
};

void add_view_volume(const WindowTransform& transform, const ClipPosition& from, const ClipPosition& to,
                     ClipVolume& volume) {
  for (const size_t axis : {0U, 1U}) {
    for (const float side : {-1.0F, 1.0F}) {
      const auto distance = [&](const ClipPosition& p) { return DoubleDouble(p[3]) + DoubleDouble(side * p[axis]); };
      volume.add(distance(from), distance(to));
    }
  }
  for (uint32_t plane = transform.first_plane(); plane <= static_cast<uint32_t>(ClipPlane::kFar); ++plane) {
    const auto distance = [&](const ClipPosition& p) {
      return transform.distance(static_cast<ClipPlane>(plane),
                                HomogeneousPosition<DoubleDouble>{p[0], p[1], p[2], p[3]});
    };
    volume.add(distance(from), distance(to));
  }
}

ClipVolume clip_volume(const WindowTransform& transform, const AssembledPrimitive& primitive, const LineEnds& ends) {
  ClipVolume volume;
  add_view_volume(transform, primitive.positions_clip[ends.from], primitive.positions_clip[ends.to], volume);
  const std::span<const float> from = primitive.clip_distances[ends.from];
  const std::span<const float> to = primitive.clip_distances[ends.to];
  for (size_t i = 0; i < from.size(); ++i) {
    volume.add(from[i], to[i]);
  }
  return volume;
}

FramebufferPosition framebuffer(const WindowTransform& transform, const SegmentEnd& end,
                                const ClipPosition& vertex_clip) {
  return end.is_vertex ? transform.vertex_framebuffer(vertex_clip) : transform.framebuffer(end.position);
}

// The primitive with this outline, if that reaches one of clip_pixels.
std::optional<SetupPrimitive> with_outline(const SetupState& state, const AssembledPrimitive& primitive,
                                           const LineEnds& ends, std::span<const FixedPosition> outline,
                                           const PixelRect& outline_pixels,
                                           std::vector<FixedPosition>& polygon_vertices) {
  const PixelRect bounds = intersection(outline_pixels, state.clip_pixels);
  if (bounds.empty()) {
    return std::nullopt;
  }
  SetupPrimitive part{.indices = primitive.indices, .primitive = primitive.number, .ends = ends};
  part.set_bounds(bounds);
  part.set_outline(outline, polygon_vertices);
  return part;
}

}  // namespace

std::optional<SetupPrimitive> setup_line(const SetupState& state, const AssembledPrimitive& primitive,
                                         const LineEnds& ends, std::vector<FixedPosition>& polygon_vertices) {
  const ClipPosition& from_clip = primitive.positions_clip[ends.from];
  const ClipPosition& to_clip = primitive.positions_clip[ends.to];
  const uint32_t outside_of_any =
      primitive.window_vertices[ends.from].clip_code | primitive.window_vertices[ends.to].clip_code;
  if ((outside_of_any & kClipNotFinite) != 0) {
    return std::nullopt;
  }
  const auto visible = clip_segment(from_clip, to_clip, clip_volume(state.transform, primitive, ends).span());
  if (!visible) {
    return std::nullopt;
  }
  const FramebufferPosition from = framebuffer(state.transform, visible->from, from_clip);
  const FramebufferPosition to = framebuffer(state.transform, visible->to, to_clip);
  const uint32_t bits = state.transform.subpixel_bits();
  if (state.line_mode == VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT) {
    const BresenhamLine line{snapped_end(from, bits), snapped_end(to, bits), bresenham_width(state.line_width)};
    return with_outline(state, primitive, ends, std::array{line.a, line.b}, bounding_pixels(line, bits),
                        polygon_vertices);
  }
  const std::optional<FixedQuad> outline = line_outline(from, to, state.line_width, bits);
  if (!outline) {
    return std::nullopt;
  }
  return with_outline(state, primitive, ends, *outline, bounding_pixels(state, *outline), polygon_vertices);
}

std::optional<SetupPrimitive> setup_point(const SetupState& state, const AssembledPrimitive& primitive,
                                          uint8_t vertex, float point_size,
                                          std::vector<FixedPosition>& polygon_vertices) {
  const ClipPosition& position_clip = primitive.positions_clip[vertex];
  // The code knows of all planes but the sides of the viewport; without any it is finite.
  if (primitive.window_vertices[vertex].clip_code != 0 || !state.transform.is_inside_clip_volume(position_clip)) {
    return std::nullopt;
  }
  const FixedQuad outline = point_outline(state.transform.vertex_framebuffer(position_clip),
                                          effective_point_size(point_size), state.transform.subpixel_bits());
  return with_outline(state, primitive, {vertex, vertex}, outline, bounding_pixels(state, outline), polygon_vertices);
}

}  // namespace fillrule::renderer
