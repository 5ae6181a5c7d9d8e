// A draw as it is asked for, checked, and what follows from its state before any vertex is seen.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "renderer/color.h"
#include "renderer/coverage.h"
#include "renderer/depth.h"
#include "renderer/isa.h"
#include "renderer/primitive_assembly.h"
#include "renderer/primitive_setup.h"
#include "renderer/sample_locations.h"

namespace fillrule::renderer {

struct Options {
  uint32_t subpixel_bits = kMaxSubpixelBits;  // kMinSubpixelBits to kMaxSubpixelBits
  uint32_t threads = 1;                       // any number gives the same bytes
  Fill fill = Fill::kEdgeFunction;            // so does either fill
  Isa isa = best_isa();                       // and any instruction set
};

// The user's distances, vertex by vertex.
struct VertexDistances {
  uint32_t count = 0;  // of a vertex
  std::span<const float> values;

  [[nodiscard]] std::span<const float> of(uint32_t vertex) const {
    return values.subspan(size_t{vertex} * count, count);
  }
};

// What a draw needs besides its program. Fixed-function state is Vulkan's.
struct DrawInput {
  uint32_t target_width = 0;  // pixels
  uint32_t target_height = 0;
  uint32_t samples = 1;         // of a pixel: 1, 2, 4, 8 or 16
  bool sample_shading = false;  // the fragment program runs for each sample, not for each pixel
  VertexStream vertices;
  // gl_ClipDistance: what is kept is where each of them is not negative. gl_CullDistance: a primitive is dropped if
  // one of them is negative at all of its vertices. At most kMaxClipAndCullDistances together.
  VertexDistances clip_distances;
  VertexDistances cull_distances;
  RasterState state;
  DepthBuffer depth;
  ColorBuffer color;  // of a program that gives colours (shading.h)

  // Whether an attachment is cleared before it is drawn to.
  [[nodiscard]] bool clears() const { return depth.clear || color.clear; }
};

// Everything of a draw that does not depend on the program.
struct PreparedDraw {
  DrawInput input;
  Shape shape;
  uint32_t subpixel_bits;
  Isa isa;
  CoverageRule coverage_rule;
  DepthStage depth;
  PrimitiveAssembly assembly;
  PixelRect viewport_pixels;  // by their centres
  SetupState setup;
  std::span<const SampleLocation> sample_locations;
  std::array<SampleArea, kMaxSamples> sample_areas;  // the first input.samples of them
  // Of the samples of eight pixels side by side, as they lie in the attachments: pixels from the first one's centre.
  std::array<double, size_t{kMaxSamples} * kBlockSize> sample_offsets_x;
  std::array<double, size_t{kMaxSamples} * kBlockSize> sample_offsets_y;
  // The least and the greatest of them, x and y by themselves.
  WindowOffset least_sample_offset;
  WindowOffset greatest_sample_offset;

  // The pixels in which a small triangle is covered by spans: those in which fragments may land on any of the
  // samples. None for draws that have no spans.
  PixelRect span_pixels;
  SpanSamples span_samples;
  uint32_t run_sample_bits;  // of a run's samples those in the sample mask
  bool has_tiny_coverage;    // tiny triangles are covered as soon as they are set up (triangle_setup.h)

  [[nodiscard]] WindowVertex window_vertex(uint32_t vertex, const ClipPosition& pos_clip) const {
    WindowVertex window_vertex = setup.transform.window_vertex(pos_clip);
    add_user_distances(input.clip_distances.of(vertex), input.cull_distances.of(vertex), window_vertex);
    return window_vertex;
  }

  // The same of the vertices [first, end), from their places in `positions_clip` to those in `window_vertices`.
  void make_window_vertices(uint32_t first, uint32_t end, std::span<const ClipPosition> positions_clip,
                            std::span<WindowVertex> window_vertices) const;

  // Into how many that are drawn a primitive may fall: outlined or as points, a polygon has three.
  [[nodiscard]] uint32_t parts_of_primitive() const {
    return shape != Shape::kPolygon && is_polygon_topology(input.vertices.topology) ? 3 : 1;
  }

  [[nodiscard]] std::span<const SampleArea> samples() const { return {sample_areas.data(), input.samples}; }
};

// Refuses what the pipeline cannot draw: a state outside of Vulkan's limits, an index without a vertex, a topology of
// patches or with adjacency.
Result<void> check_draw(const DrawInput& input, const Options& options);

// Of a draw that was checked.
PreparedDraw prepare_draw(const DrawInput& input, const Options& options);

}  // namespace fillrule::renderer
