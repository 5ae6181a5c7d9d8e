// From the coverage of a primitive in a tile to fragments: the per-sample operations and the fragment program
// (Vulkan, "Fragment Operations", "Sample Shading").
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/interpolation.h"
#include "renderer/prepared_draw.h"
#include "renderer/tile_bins.h"

namespace fillrule::renderer {

// A primitive about to be shaded.
struct ShadedPrimitive {
  uint32_t primitive = 0;  // within the draw; culled, clipped and degenerate ones are counted
  // The provoking one first; the weights' order. A primitive of fewer vertices repeats its last.
  std::array<uint32_t, 3> vertices{};
  bool front_facing = false;
};

// A fragment that passed the depth test at one of its samples at least.
struct Fragment {
  // Framebuffer coordinates of its pixel; the pixel's centre is at x + 0.5, y + 0.5.
  int32_t x = 0;
  int32_t y = 0;
  uint32_t samples = 1;   // bit i: it lands on sample i; one of them under sample shading
  WindowOffset position;  // gl_FragCoord.xy: the sample's location under sample shading, else the centre
  WindowOffset centroid;  // a point of both the pixel and the primitive
  const PrimitiveInterpolation& interpolation;

  [[nodiscard]] PixelWeights weights(const WindowOffset& from_centre = {}) const {
    return interpolation.weights_at(x, y, from_centre);
  }

  // gl_FragCoord: framebuffer x and y, the depth with its bias but neither clamped nor quantised, and 1/w.
  [[nodiscard]] std::array<float, 4> frag_coord() const {
    return {static_cast<float>(x + 0.5 + position.x), static_cast<float>(y + 0.5 + position.y),
            finite_float(interpolation.depth_at(x, y, position)),
            finite_float(interpolation.reciprocal_w_at(x, y, position))};
  }

  // gl_PointCoord; 0 of anything but points.
  [[nodiscard]] std::array<float, 2> point_coord() const { return interpolation.point_coord_at(x, y, position); }
};

template <typename P>
concept Program = requires(const P& program, uint32_t vertex, const ShadedPrimitive& primitive,
                           const typename P::PrimitiveData& data, const Fragment& fragment) {
  // The vertex program: the position in clip space. Called once for each vertex.
  { program.position(vertex) } -> std::convertible_to<ClipPosition>;
  // What the fragments of a primitive share. Called once for each primitive and tile.
  { program.primitive_data(primitive) } -> std::same_as<typename P::PrimitiveData>;
  // The fragment program: writes wherever it likes for this pixel.
  program.fragment(data, fragment);
};

// The plane equations of a primitive that was set up.
PrimitiveInterpolation make_interpolation(const PreparedDraw& draw, const SetupPrimitive& primitive,
                                          const std::array<uint32_t, 3>& vertices,
                                          const std::vector<ClipPosition>& positions_clip,
                                          std::span<const FixedPosition> outline);

namespace internal {

// One primitive in one tile.
template <Program P>
struct Shader {
  const PreparedDraw& draw;
  const P& program;
  const typename P::PrimitiveData& data;
  const PrimitiveInterpolation& interpolation;

  void shade(const CoverageBlock& block) const {
    for (uint64_t mask = block.mask; mask != 0; mask &= mask - 1) {
      const int32_t bit = std::countr_zero(mask);
      const int32_t x = block.x + bit % kBlockSize;
      const int32_t y = block.y + bit / kBlockSize;
      if (lands(x, y, 0, {})) {
        program.fragment(data, {.x = x, .y = y, .interpolation = interpolation});
      }
    }
  }

  void shade(const SampledBlock& block) const {
    for (uint64_t mask = block.any; mask != 0; mask &= mask - 1) {
      const int32_t bit = std::countr_zero(mask);
      shade_pixel(block.x + bit % kBlockSize, block.y + bit / kBlockSize,
                  block.samples_at(static_cast<uint32_t>(bit)));
    }
  }

 private:
  [[nodiscard]] WindowOffset location(uint32_t sample) const { return draw.sample_locations[sample].from_centre(); }

  [[nodiscard]] bool lands(int32_t x, int32_t y, uint32_t sample, const WindowOffset& from_centre) const {
    if (!draw.depth.tests()) {
      return true;
    }
    const size_t pixel = static_cast<size_t>(y) * draw.input.target_width + static_cast<size_t>(x);
    float& stored = draw.input.depth.values[pixel * draw.input.samples + sample];
    return draw.depth.lands(interpolation.depth_at(x, y, from_centre), stored);
  }

  void shade_pixel(int32_t x, int32_t y, uint32_t covered) const {
    uint32_t landed = 0;
    for (uint32_t rest = covered & draw.input.state.sample_mask; rest != 0; rest &= rest - 1) {
      const auto sample = static_cast<uint32_t>(std::countr_zero(rest));
      landed |= static_cast<uint32_t>(lands(x, y, sample, location(sample))) << sample;
    }
    if (landed == 0) {
      return;
    }
    Fragment fragment{.x = x, .y = y, .samples = landed, .interpolation = interpolation};
    // The centre is within the convex hull of all samples; of fewer, any is a point of the primitive.
    if (covered != (1U << draw.input.samples) - 1) {
      fragment.centroid = location(static_cast<uint32_t>(std::countr_zero(covered)));
    }
    if (!draw.input.sample_shading) {
      program.fragment(data, fragment);
      return;
    }
    for (uint32_t rest = landed; rest != 0; rest &= rest - 1) {
      const auto sample = static_cast<uint32_t>(std::countr_zero(rest));
      fragment.samples = 1U << sample;
      fragment.position = location(sample);
      program.fragment(data, fragment);
    }
  }
};

inline void cover_tile(const PreparedDraw& draw, std::span<const FixedPosition> outline, const PixelRect& rect,
                       TileCoverage& coverage) {
  cover(draw.coverage_rule, outline, draw.samples().front().sample_fixed, rect, coverage);
}

inline void cover_tile(const PreparedDraw& draw, std::span<const FixedPosition> outline, const PixelRect& rect,
                       SampledTileCoverage& coverage) {
  cover_samples(draw.coverage_rule, outline, draw.samples(), rect, coverage);
}

// Coverage is TileCoverage for draws of one sample a pixel, which are much the faster for it, and else
// SampledTileCoverage.
template <typename Coverage, Program P>
void shade_tile(const PreparedDraw& draw, const P& program, const std::vector<ClipPosition>& positions_clip,
                const PixelRect& tile_pixels, uint32_t tile, std::span<const PrimitiveChunk> chunks) {
  Coverage coverage;
  for (const PrimitiveChunk& chunk : chunks) {
    chunk.for_each_in_tile(tile, [&](const SetupPrimitive& primitive) {
      const PixelRect rect = intersection(primitive.bounds(), tile_pixels);
      if (rect.empty()) {
        return;
      }
      const std::span<const FixedPosition> outline = primitive.outline(chunk.polygon_vertices());
      cover_tile(draw, outline, rect, coverage);
      if (coverage.count == 0) {
        return;
      }
      const std::array<uint32_t, 3> vertices = draw.assembly.vertices(primitive.primitive);
      const PrimitiveInterpolation interpolation =
          make_interpolation(draw, primitive, vertices, positions_clip, outline);
      const typename P::PrimitiveData data = program.primitive_data(
          {.primitive = primitive.primitive, .vertices = vertices, .front_facing = primitive.front_facing});
      const Shader<P> shader{draw, program, data, interpolation};
      for (uint32_t i = 0; i < coverage.count; ++i) {
        shader.shade(coverage.blocks[i]);
      }
    });
  }
}

}  // namespace internal
}  // namespace fillrule::renderer
