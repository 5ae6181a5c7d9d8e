// From an assembled primitive to what the tiles need of it: clipping, facing, culling, the pixels it may touch
// (Vulkan, "Basic Polygon Rasterization").
//
// A primitive that is set up is an outline and where it comes from. Nothing downstream asks what kind of primitive
// the outline belongs to, bins and coverage least: a line is set up by its rectangle and a point by its square, four
// vertices in the list of polygon vertices. Only the planes that give it values depend on its kind
// (make_interpolation() of pipeline.h).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cases/model/case.h"
#include "renderer/clip.h"
#include "renderer/fixed_point.h"
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
};

// A primitive that may cover samples: its outline, closed, as a triangle or any other polygon.
struct SetupPrimitive {
  std::array<FixedPosition, 3> vertices;
  uint32_t primitive = 0;       // counted within the draw
  uint32_t polygon_offset = 0;  // of an outline that is no triangle, in the list of polygon vertices
  uint16_t left = 0;            // the pixels it may touch, within SetupState::clip_pixels
  uint16_t top = 0;
  uint16_t right = 0;
  uint16_t bottom = 0;
  uint8_t polygon_count = 0;  // 0: the outline is `vertices`
  bool front_facing = false;

  [[nodiscard]] PixelRect bounds() const { return {left, top, right, bottom}; }

  [[nodiscard]] std::span<const FixedPosition> outline(const std::vector<FixedPosition>& polygon_vertices) const {
    if (polygon_count == 0) {
      return vertices;
    }
    return std::span{polygon_vertices}.subspan(polygon_offset, polygon_count);
  }
};

// The pixels with a sample in the outline's bounding box.
PixelRect bounding_pixels(const SetupState& state, std::span<const FixedPosition> outline);

// The facing of a snapped outline of so much signed area (edge_function.h), y down: Vulkan's a = -doubled_area / 2 is
// positive for counter-clockwise. No area is back-facing.
bool is_front_facing(int64_t doubled_area_fixed, VkFrontFace front_face);

// Nothing if the triangle covers no sample for sure: clipped away, not finite, culled, without area or outside of
// clip_pixels. Appends the vertices of a clipped outline to `polygon_vertices`.
std::optional<SetupPrimitive> setup_triangle(const SetupState& state, uint32_t primitive,
                                             const std::array<ClipPosition, 3>& positions_clip,
                                             const std::array<WindowVertex, 3>& window_vertices,
                                             const ClipDistances& clip_distances,
                                             std::vector<FixedPosition>& polygon_vertices);

}  // namespace fillrule::renderer
