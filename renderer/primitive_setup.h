// From an assembled primitive to what the tiles need of it: clipping, facing, culling, the pixels it may touch
// (Vulkan, "Basic Polygon Rasterization").
//
// A primitive that is set up is an outline and where it comes from. Nothing downstream asks what kind of primitive
// the outline belongs to, bins and coverage least: a line is set up by its rectangle and a point by its square, four
// vertices in the list of polygon vertices (line_point_setup.h). Only a Bresenham line, two vertices, is covered in
// its own way. The planes that give values depend on the kind (make_interpolation() of shading.h).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cases/model/case.h"
#include "renderer/clip.h"
#include "renderer/fixed_point.h"
#include "renderer/primitive_assembly.h"
#include "renderer/window_transform.h"

namespace fillrule::renderer {

// What holds for all primitives of a draw.
struct SetupState {
  WindowTransform transform;
  VkCullModeFlags cull_mode;
  VkFrontFace front_face;
  PixelRect clip_pixels;       // those of viewport, scissor and target
  FixedPosition least_sample;  // within a pixel, of all samples' locations; the centre where there is one sample
  FixedPosition greatest_sample;
  VkLineRasterizationModeEXT line_mode = VK_LINE_RASTERIZATION_MODE_RECTANGULAR_EXT;
  float line_width = 1;  // pixels
};

// A primitive as it is assembled, with all there is of its vertices. A line or a point repeats its last.
struct AssembledPrimitive {
  uint32_t number = 0;                // counted within the draw
  std::array<uint32_t, 3> indices{};  // its vertices among those of the draw, the provoking one first
  std::array<ClipPosition, 3> positions_clip{};
  std::array<WindowVertex, 3> window_vertices{};
  ClipDistances clip_distances;

  // One of the user's cull distances is negative at all vertices.
  [[nodiscard]] bool is_culled_by_distance() const {
    return (window_vertices[0].cull_code & window_vertices[1].cull_code & window_vertices[2].cull_code) != 0;
  }
};

// A primitive that may cover samples: its outline, closed, as a triangle or any other polygon.
struct SetupPrimitive {
  std::array<FixedPosition, 3> vertices;
  std::array<uint32_t, 3> indices{};  // see AssembledPrimitive
  uint32_t primitive = 0;             // counted within the draw
  // Of an outline that is no triangle: where it begins in the list of polygon vertices. Of a triangle: see
  // covered_pixels().
  uint32_t offset_or_pixels = 0;
  uint16_t left = 0;  // the pixels it may touch, within SetupState::clip_pixels
  uint16_t top = 0;
  uint16_t right = 0;
  uint16_t bottom = 0;
  uint8_t polygon_count = 0;  // 0: the outline is `vertices`
  LineEnds ends;              // of a line or a point; see primitive_assembly.h
  bool front_facing = false;

  [[nodiscard]] PixelRect bounds() const { return {left, top, right, bottom}; }

  void set_bounds(const PixelRect& pixels) {
    left = static_cast<uint16_t>(pixels.left);
    top = static_cast<uint16_t>(pixels.top);
    right = static_cast<uint16_t>(pixels.right);
    bottom = static_cast<uint16_t>(pixels.bottom);
  }

  // The pixels that a triangle covers, if they are known; else 0. Bit kCoveredWidth * y + x: the pixel at (x, y) from
  // the left and the top of the bounds.
  static constexpr int32_t kCoveredWidth = 8;
  static constexpr int32_t kCoveredHeight = 4;
  [[nodiscard]] uint32_t covered_pixels() const { return polygon_count == 0 ? offset_or_pixels : 0; }
  void set_covered_pixels(uint32_t pixels) { offset_or_pixels = pixels; }

  // Appends the outline to the list of polygon vertices.
  void set_outline(std::span<const FixedPosition> outline, std::vector<FixedPosition>& polygon_vertices) {
    offset_or_pixels = static_cast<uint32_t>(polygon_vertices.size());
    polygon_count = static_cast<uint8_t>(outline.size());
    polygon_vertices.insert(polygon_vertices.end(), outline.begin(), outline.end());
  }

  [[nodiscard]] std::span<const FixedPosition> outline(const std::vector<FixedPosition>& polygon_vertices) const {
    if (polygon_count == 0) {
      return vertices;
    }
    return std::span{polygon_vertices}.subspan(offset_or_pixels, polygon_count);
  }
};

// Draws hold many of them at once (tile_bins.h).
static_assert(sizeof(SetupPrimitive) <= 56);

// The pixels with a sample in the outline's bounding box.
PixelRect bounding_pixels(const SetupState& state, std::span<const FixedPosition> outline);

// The facing of a snapped outline of so much signed area (edge_function.h), y down: Vulkan's a = -doubled_area / 2 is
// positive for counter-clockwise. No area is back-facing.
bool is_front_facing(int64_t doubled_area_fixed, VkFrontFace front_face);

// What can be seen of a triangle, snapped.
struct VisiblePolygon {
  std::array<FixedPosition, 3> vertices;
  FixedPolygon clipped;  // nothing if no vertex is outside: then the outline is `vertices`
  [[nodiscard]] std::span<const FixedPosition> outline() const {
    return clipped.count == 0 ? std::span<const FixedPosition>{vertices} : clipped.span();
  }
};

// Nothing if it is clipped away, dropped by the user's cull distances or not finite.
std::optional<VisiblePolygon> visible_polygon(const SetupState& state, const AssembledPrimitive& triangle);

// Whether the polygon is front-facing; nothing if it is culled.
std::optional<bool> facing(const SetupState& state, const VisiblePolygon& polygon);

// Nothing if the triangle covers no sample for sure: clipped away, not finite, culled, without area or outside of
// clip_pixels. Appends the vertices of a clipped outline to `polygon_vertices`.
std::optional<SetupPrimitive> setup_triangle(const SetupState& state, const AssembledPrimitive& triangle,
                                             std::vector<FixedPosition>& polygon_vertices);

// The same of a triangle that is all within the clip volume and is not dropped by the user's distances, in place:
// `filled` has its vertices. False if it covers no sample for sure.
[[nodiscard]] bool setup_whole_triangle(const SetupState& state, SetupPrimitive& filled);

}  // namespace fillrule::renderer
