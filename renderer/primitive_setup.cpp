#include "renderer/primitive_setup.h"

#include <algorithm>

#include "renderer/edge_function.h"

namespace fillrule::renderer {
namespace {

struct Area {
  int64_t doubled = 0;      // of the whole outline
  bool has_pieces = false;  // some triangle of the fan has an area
};

Area area(std::span<const FixedPosition> outline) {
  Area sum;
  for (size_t i = 2; i < outline.size(); ++i) {
    const int64_t piece = doubled_area(outline[0], outline[i - 1], outline[i]);
    sum.doubled += piece;
    sum.has_pieces = sum.has_pieces || piece != 0;
  }
  return sum;
}

// Nothing if an outline of this area is culled.
std::optional<bool> facing(const SetupState& state, int64_t doubled_area_fixed) {
  const bool front_facing = is_front_facing(doubled_area_fixed, state.front_face);
  const VkCullModeFlags face = front_facing ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_BACK_BIT;
  if ((state.cull_mode & face) != 0) {
    return std::nullopt;
  }
  return front_facing;
}

}  // namespace

PixelRect bounding_pixels(const SetupState& state, std::span<const FixedPosition> outline) {
  const auto [x_min, x_max] = std::minmax_element(outline.begin(), outline.end(),
                                                  [](const auto& a, const auto& b) { return a.x_fixed < b.x_fixed; });
  const auto [y_min, y_max] = std::minmax_element(outline.begin(), outline.end(),
                                                  [](const auto& a, const auto& b) { return a.y_fixed < b.y_fixed; });
  const uint32_t bits = state.transform.subpixel_bits();
  return {first_pixel(x_min->x_fixed, state.greatest_sample.x_fixed, bits),
          first_pixel(y_min->y_fixed, state.greatest_sample.y_fixed, bits),
          first_pixel(x_max->x_fixed, state.least_sample.x_fixed, bits),
          first_pixel(y_max->y_fixed, state.least_sample.y_fixed, bits)};
}

bool is_front_facing(int64_t doubled_area_fixed, VkFrontFace front_face) {
  return front_face == VK_FRONT_FACE_COUNTER_CLOCKWISE ? doubled_area_fixed < 0 : doubled_area_fixed > 0;
}

std::optional<VisiblePolygon> visible_polygon(const SetupState& state, const AssembledPrimitive& triangle) {
  const auto& [v0, v1, v2] = triangle.window_vertices;
  const uint32_t outside_of_any = v0.clip_code | v1.clip_code | v2.clip_code;
  const uint32_t outside_of_all = v0.clip_code & v1.clip_code & v2.clip_code;
  if ((outside_of_any & kClipNotFinite) != 0 || outside_of_all != 0 || triangle.is_culled_by_distance()) {
    return std::nullopt;
  }
  VisiblePolygon polygon{.vertices = {v0.position, v1.position, v2.position}};
  if (outside_of_any != 0) {
    polygon.clipped =
        clip_triangle(state.transform, triangle.positions_clip, triangle.window_vertices, triangle.clip_distances);
    if (polygon.clipped.count == 0) {
      return std::nullopt;
    }
  }
  return polygon;
}

std::optional<bool> facing(const SetupState& state, const VisiblePolygon& polygon) {
  return facing(state, area(polygon.outline()).doubled);
}

std::optional<SetupPrimitive> setup_triangle(const SetupState& state, const AssembledPrimitive& triangle,
                                             std::vector<FixedPosition>& polygon_vertices) {
  const std::optional<VisiblePolygon> polygon = visible_polygon(state, triangle);
  if (!polygon) {
    return std::nullopt;
  }
  if (polygon->clipped.count == 0) {
    SetupPrimitive whole{.vertices = polygon->vertices, .indices = triangle.indices, .primitive = triangle.number};
    return setup_whole_triangle(state, whole) ? std::optional(whole) : std::nullopt;
  }
  const PixelRect bounds = intersection(bounding_pixels(state, polygon->outline()), state.clip_pixels);
  if (bounds.empty() || !area(polygon->outline()).has_pieces) {
    return std::nullopt;
  }
  const std::optional<bool> front_facing = facing(state, *polygon);
  if (!front_facing) {
    return std::nullopt;
  }
  SetupPrimitive filled{.vertices = polygon->vertices,
                        .indices = triangle.indices,
                        .primitive = triangle.number,
                        .front_facing = *front_facing};
  filled.set_bounds(bounds);
  filled.set_outline(polygon->clipped.span(), polygon_vertices);
  return filled;
}

bool setup_whole_triangle(const SetupState& state, SetupPrimitive& filled) {
  const auto& [a, b, c] = filled.vertices;
  const uint32_t bits = state.transform.subpixel_bits();
  const auto first = [bits](int32_t coordinate, int32_t sample) { return first_pixel(coordinate, sample, bits); };
  const PixelRect outline_pixels{
      first(std::min(std::min(a.x_fixed, b.x_fixed), c.x_fixed), state.greatest_sample.x_fixed),
      first(std::min(std::min(a.y_fixed, b.y_fixed), c.y_fixed), state.greatest_sample.y_fixed),
      first(std::max(std::max(a.x_fixed, b.x_fixed), c.x_fixed), state.least_sample.x_fixed),
      first(std::max(std::max(a.y_fixed, b.y_fixed), c.y_fixed), state.least_sample.y_fixed)};
  const PixelRect bounds = intersection(outline_pixels, state.clip_pixels);
  const int64_t doubled = doubled_area(a, b, c);
  const std::optional<bool> front_facing = facing(state, doubled);
  if (bounds.empty() || doubled == 0 || !front_facing) {
    return false;
  }
  filled.front_facing = *front_facing;
  filled.set_bounds(bounds);
  return true;
}

}  // namespace fillrule::renderer
