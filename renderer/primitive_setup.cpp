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

std::optional<SetupPrimitive> setup_triangle(const SetupState& state, uint32_t primitive,
                                             const std::array<ClipPosition, 3>& positions_clip,
                                             const std::array<WindowVertex, 3>& window_vertices,
                                             const ClipDistances& clip_distances,
                                             std::vector<FixedPosition>& polygon_vertices) {
  const auto& [v0, v1, v2] = window_vertices;
  const uint32_t outside_of_any = v0.clip_code | v1.clip_code | v2.clip_code;
  const uint32_t outside_of_all = v0.clip_code & v1.clip_code & v2.clip_code;
  const uint32_t is_culled = v0.cull_code & v1.cull_code & v2.cull_code;
  if ((outside_of_any & kClipNotFinite) != 0 || outside_of_all != 0 || is_culled != 0) {
    return std::nullopt;
  }
  SetupPrimitive triangle{.vertices = {v0.position, v1.position, v2.position}, .primitive = primitive};
  FixedPolygon polygon;
  std::span<const FixedPosition> outline = triangle.vertices;
  if (outside_of_any != 0) {
    polygon = clip_triangle(state.transform, positions_clip, window_vertices, clip_distances);
    if (polygon.count == 0) {
      return std::nullopt;
    }
    outline = polygon.span();
  }

  const PixelRect bounds = intersection(bounding_pixels(state, outline), state.clip_pixels);
  if (bounds.empty()) {
    return std::nullopt;
  }
  const Area outline_area = area(outline);
  if (!outline_area.has_pieces) {
    return std::nullopt;
  }
  triangle.front_facing = is_front_facing(outline_area.doubled, state.front_face);
  const VkCullModeFlags face = triangle.front_facing ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_BACK_BIT;
  if ((state.cull_mode & face) != 0) {
    return std::nullopt;
  }

  triangle.left = static_cast<uint16_t>(bounds.left);
  triangle.top = static_cast<uint16_t>(bounds.top);
  triangle.right = static_cast<uint16_t>(bounds.right);
  triangle.bottom = static_cast<uint16_t>(bounds.bottom);
  if (outside_of_any != 0) {
    triangle.polygon_offset = static_cast<uint32_t>(polygon_vertices.size());
    triangle.polygon_count = static_cast<uint8_t>(outline.size());
    polygon_vertices.insert(polygon_vertices.end(), outline.begin(), outline.end());
  }
  return triangle;
}

}  // namespace fillrule::renderer
