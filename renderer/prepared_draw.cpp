#include "renderer/prepared_draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "renderer/bresenham_line.h"
#include "renderer/outlines.h"

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

Result<void> check_topology(VkPrimitiveTopology topology) {
  switch (topology) {
    case VK_PRIMITIVE_TOPOLOGY_POINT_LIST:
    case VK_PRIMITIVE_TOPOLOGY_LINE_LIST:
    case VK_PRIMITIVE_TOPOLOGY_LINE_STRIP:
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST:
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP:
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN:
      return {};
    default:
      return failure(fmt::format("topology {}", static_cast<int>(topology)),
                     "point list, line list or strip, triangle list, strip or fan");
  }
}

Result<void> check_distances(const DrawInput& input) {
  const uint32_t count = input.clip_distances.count + input.cull_distances.count;
  if (count > kMaxClipAndCullDistances) {
    return failure(fmt::format("{} clip and cull distances", count),
                   fmt::format("at most {}", kMaxClipAndCullDistances));
  }
  for (const VertexDistances& distances : {input.clip_distances, input.cull_distances}) {
    if (distances.values.size() != size_t{distances.count} * input.vertices.vertex_count) {
      return failure(fmt::format("{} values of {} distances for {} vertices", distances.values.size(),
                                 distances.count, input.vertices.vertex_count));
    }
  }
  return {};
}

Result<void> check_lines_and_points(const DrawInput& input) {
  const RasterState& state = input.state;
  const Shape shape = shape_of(input.vertices.topology, state.polygon_mode);
  if (shape == Shape::kLine && !(state.line_width > 0 && state.line_width <= kMaxLineWidth)) {
    return failure(fmt::format("line_width is {}", state.line_width),
                   fmt::format("above 0, at most {}", kMaxLineWidth));
  }
  const size_t sizes = input.vertices.point_sizes.size();
  if (sizes != 0 && sizes != input.vertices.vertex_count) {
    return failure(fmt::format("{} point sizes for {} vertices", sizes, input.vertices.vertex_count));
  }
  return {};
}

Result<void> check_size(std::string_view kind, size_t values, const DrawInput& input) {
  if (values != 0 && values != size_t{input.target_width} * input.target_height * input.samples) {
    return failure(fmt::format("a {} buffer of {} values for a target of {} x {} pixels of {} samples", kind, values,
                               input.target_width, input.target_height, input.samples));
  }
  return {};
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

// Where each sample is and may be landed on; the bounds of them all.
void set_up_samples(PreparedDraw& prepared) {
  const DrawInput& input = prepared.input;
  const PixelRect scissor = scissor_pixels(input.state.scissor, input.target_width, input.target_height);
  prepared.sample_locations = standard_sample_locations(input.samples);
  SetupState& setup = prepared.setup;
  for (uint32_t i = 0; i < input.samples; ++i) {
    const FixedPosition sample = prepared.sample_locations[i].fixed(prepared.subpixel_bits);
    const PixelRect pixels = intersection(setup.transform.viewport_pixels(sample), scissor);
    prepared.sample_areas[i] = {.sample_fixed = sample, .pixels = pixels};
    if (i == 0) {
      setup.least_sample = setup.greatest_sample = sample;
      setup.clip_pixels = pixels;
    }
    setup.least_sample = {std::min(setup.least_sample.x_fixed, sample.x_fixed),
                          std::min(setup.least_sample.y_fixed, sample.y_fixed)};
    setup.greatest_sample = {std::max(setup.greatest_sample.x_fixed, sample.x_fixed),
                             std::max(setup.greatest_sample.y_fixed, sample.y_fixed)};
    setup.clip_pixels = hull(setup.clip_pixels, pixels);
  }
  for (uint32_t i = 0; i < input.samples * kBlockSize; ++i) {
    const uint32_t pixel = i / input.samples;
    const WindowOffset from_centre = prepared.sample_locations[i % input.samples].from_centre();
    prepared.sample_offsets_x[i] = pixel + from_centre.x;
    prepared.sample_offsets_y[i] = from_centre.y;
    if (i == 0) {
      prepared.least_sample_offset = prepared.greatest_sample_offset = from_centre;
    }
    prepared.least_sample_offset = {std::min(prepared.least_sample_offset.x, prepared.sample_offsets_x[i]),
                                    std::min(prepared.least_sample_offset.y, prepared.sample_offsets_y[i])};
    prepared.greatest_sample_offset = {std::max(prepared.greatest_sample_offset.x, prepared.sample_offsets_x[i]),
                                       std::max(prepared.greatest_sample_offset.y, prepared.sample_offsets_y[i])};
  }
}

// Spans are for filled triangles whose pixels have one sample, or four that share their fragments.
void set_up_spans(PreparedDraw& prepared) {
  const DrawInput& input = prepared.input;
  const bool has_spans = prepared.coverage_rule.fill == Fill::kEdgeFunction &&
                         (input.samples == 1 || (input.samples == 4 && !input.sample_shading));
  if (!has_spans) {
    return;
  }
  prepared.has_tiny_coverage = input.samples == 1;
  prepared.span_pixels = prepared.setup.clip_pixels;
  for (const SampleArea& sample : prepared.samples()) {
    prepared.span_pixels = intersection(prepared.span_pixels, sample.pixels);
  }
  prepared.run_sample_bits = 0;
  for (uint32_t i = 0; i < kBlockSize * input.samples; ++i) {
    prepared.run_sample_bits |= (input.state.sample_mask >> i % input.samples & 1U) << i;
  }
  for (uint32_t i = 0; i < kBlockSize; ++i) {
    const FixedPosition& sample = prepared.sample_areas[i % input.samples].sample_fixed;
    prepared.span_samples.x_fixed[i] = sample.x_fixed;
    prepared.span_samples.y_fixed[i] =
        sample.y_fixed + (static_cast<int32_t>(i / input.samples) << prepared.subpixel_bits);
  }
}

}  // namespace

void PreparedDraw::make_window_vertices(uint32_t first, uint32_t end, std::span<const ClipPosition> positions_clip,
                                        std::span<WindowVertex> window_vertices) const {
  uint32_t vertex = first;
  dispatch(
      isa, [&]<typename L>() __attribute__((always_inline)) {
        const WindowTransform transform = setup.transform;
        for (; vertex + L::kWidth <= end; vertex += L::kWidth) {
          transform.window_vertices<L>(&positions_clip[vertex], &window_vertices[vertex]);
        }
      });
  for (; vertex < end; ++vertex) {
    window_vertices[vertex] = setup.transform.window_vertex(positions_clip[vertex]);
  }
  if (input.clip_distances.count != 0 || input.cull_distances.count != 0) {
    for (vertex = first; vertex < end; ++vertex) {
      add_user_distances(input.clip_distances.of(vertex), input.cull_distances.of(vertex), window_vertices[vertex]);
    }
  }
}

Result<void> check_draw(const DrawInput& input, const Options& options) {
  if (!is_supported(options.isa)) {
    return failure(fmt::format("this processor does not have {}", to_string(options.isa)),
                   fmt::format("the greatest that it has is {}", to_string(best_isa())));
  }
  if (options.subpixel_bits < kMinSubpixelBits || options.subpixel_bits > kMaxSubpixelBits) {
    return failure(fmt::format("{} subpixel bits", options.subpixel_bits),
                   fmt::format("{} to {}", kMinSubpixelBits, kMaxSubpixelBits));
  }
  if (input.target_width == 0 || input.target_width > kMaxTargetSize || input.target_height == 0 ||
      input.target_height > kMaxTargetSize) {
    return failure(fmt::format("target of {} x {} pixels", input.target_width, input.target_height),
                   fmt::format("1 to {}", kMaxTargetSize));
  }
  if (standard_sample_locations(input.samples).empty()) {
    return failure(fmt::format("{} samples a pixel", input.samples), "1, 2, 4, 8 or 16");
  }
  const size_t depth_values = input.depth.values.size();
  if (auto checked = check_size("depth", depth_values, input); !checked) {
    return checked;
  }
  if (auto checked = check_size("color", input.color.values.size(), input); !checked) {
    return checked;
  }
  const VkFormat format = input.depth.format;
  if (depth_values != 0 && format != VK_FORMAT_D32_SFLOAT && max_depth_code(format) == 0) {
    return failure(fmt::format("depth format {}", static_cast<int>(format)),
                   "D16_UNORM, X8_D24_UNORM_PACK32 or D32_SFLOAT");
  }
  return check_viewport(input.state.viewport)
      .and_then([&] { return check_topology(input.vertices.topology); })
      .and_then([&] { return check_lines_and_points(input); })
      .and_then([&] { return check_indices(input.vertices); })
      .and_then([&] { return check_distances(input); });
}

PreparedDraw prepare_draw(const DrawInput& input, const Options& options) {
  const RasterState& state = input.state;
  const WindowTransform transform(state.viewport, options.subpixel_bits,
                                  {.clips = state.depth_clip, .negative_one_to_one = state.negative_one_to_one});
  PreparedDraw prepared{.input = input,
                        .shape = shape_of(input.vertices.topology, state.polygon_mode),
                        .subpixel_bits = options.subpixel_bits,
                        .isa = options.isa,
                        .coverage_rule = {.fill = options.fill,
                                          .subpixel_bits = options.subpixel_bits,
                                          .bresenham_width = bresenham_width(state.line_width),
                                          .isa = options.isa},
                        .depth = DepthStage(state, input.depth),
                        .assembly = PrimitiveAssembly(input.vertices, state.provoking_vertex),
                        .viewport_pixels = transform.viewport_pixels(pixel_centre_fixed(options.subpixel_bits)),
                        .setup = {.transform = transform,
                                  .cull_mode = state.cull_mode,
                                  .front_face = state.front_face,
                                  .line_mode = state.line_mode,
                                  .line_width = state.line_width}};
  set_up_samples(prepared);
  set_up_spans(prepared);
  return prepared;
}

}  // namespace fillrule::renderer
