// One tile: the primitives that touch it, in the order of submission, from coverage to the attachments.
//
// A block of 8x8 pixels is shaded row by row, as many pixels at once as there are lanes; blocks lie on multiples of 8
// pixels, so that none reaches into another tile. Where a row of lanes would reach beyond the target, and where a
// program wants its fragments one by one, pixels are.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/shading.h"

namespace fillrule::renderer::internal {

// One primitive in one tile.
template <typename L, Program P>
struct Shader {
  const PreparedDraw& draw;
  const P& program;
  const typename P::PrimitiveData& data;
  const ShadedPrimitive& primitive;
  const PrimitiveInterpolation& interpolation;
  WindowPlane reciprocal_w;  // from the primitive's anchor of planes

  [[gnu::always_inline]] void shade(const CoverageBlock& block) const {
    if (static_cast<uint32_t>(block.x + kBlockSize) > draw.input.target_width) {
      shade_rows<ScalarLanes>(block);
    } else {
      shade_rows<L>(block);
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
  // A pixel's first value in the attachments.
  [[nodiscard]] size_t index_of(int32_t x, int32_t y) const {
    return (static_cast<size_t>(y) * draw.input.target_width + static_cast<size_t>(x)) * draw.input.samples;
  }

  template <typename Lanes>
  [[gnu::always_inline]] void shade_rows(const CoverageBlock& block) const {
    const WindowPlane& depth = interpolation.depth_framebuffer;
    for (int32_t column = 0; column < kBlockSize; column += static_cast<int32_t>(Lanes::kWidth)) {
      const int32_t x = block.x + column;
      const auto xs = Lanes::to_double(Lanes::numbers() + (x - interpolation.anchor_x));
      const auto depth_column = Lanes::all(depth.at_anchor) + Lanes::all(depth.step_x) * xs;
      for (int32_t row = 0; row < kBlockSize; ++row) {
        constexpr uint32_t kAllLanes = (1U << Lanes::kWidth) - 1;
        const auto bits = static_cast<uint32_t>(block.mask >> (row * kBlockSize + column)) & kAllLanes;
        if (bits == 0) {
          continue;
        }
        const int32_t y = block.y + row;
        typename Lanes::Mask mask = Lanes::mask_of(bits);
        if (draw.depth.tests()) {
          float* const stored_depth = draw.input.depth.values.data() + index_of(x, y);
          typename Lanes::Float stored = Lanes::load(stored_depth);
          const double depth_row = depth.step_y * (y - interpolation.anchor_y);
          mask = draw.depth.template lands<Lanes>(depth_column + Lanes::all(depth_row), mask, stored);
          if (!Lanes::any(mask)) {
            continue;
          }
          Lanes::store(stored, stored_depth);
        }
        emit<Lanes>(x, y, mask);
      }
    }
  }

  // Fragments of one sample a pixel, those in the mask, from (x, y) to the right.
  template <typename Lanes>
  [[gnu::always_inline]] void emit(int32_t x, int32_t y, const typename Lanes::Mask& mask) const {
    if constexpr (ColorProgram<P>) {
      uint32_t* const color = draw.input.color.values.data() + index_of(x, y);
      const typename Lanes::Int packed = packed_color<Lanes>(x, y, {});
      Lanes::store(mask ? packed : Lanes::load(color), color);
    } else {
      for (uint32_t bits = Lanes::bits_of(mask); bits != 0; bits &= bits - 1) {
        program.fragment(data, {.x = x + std::countr_zero(bits), .y = y, .interpolation = interpolation});
      }
    }
  }

  template <typename Lanes>
  [[gnu::always_inline]] typename Lanes::Int packed_color(int32_t x, int32_t y, const WindowOffset& at) const {
    FragmentLanes<Lanes> fragments;
    fragments.x = Lanes::to_float(Lanes::numbers() + (x - primitive.anchor_x)) + Lanes::all(static_cast<float>(at.x));
    fragments.y = Lanes::all(static_cast<float>(y - primitive.anchor_y + at.y));
    const auto plane = [](double value) __attribute__((always_inline)) {
      return Lanes::all(static_cast<float>(value));
    };
    fragments.w = Lanes::all(1.0F) / (plane(reciprocal_w.at_anchor) + plane(reciprocal_w.step_x) * fragments.x +
                                      plane(reciprocal_w.step_y) * fragments.y);
    return packed_unorm8<Lanes>(program.template color<Lanes>(data, fragments));
  }

  [[nodiscard]] WindowOffset location(uint32_t sample) const { return draw.sample_locations[sample].from_centre(); }

  [[nodiscard]] bool lands(int32_t x, int32_t y, uint32_t sample) const {
    if (!draw.depth.tests()) {
      return true;
    }
    float& stored = draw.input.depth.values[index_of(x, y) + sample];
    return draw.depth.lands(interpolation.depth_at(x, y, location(sample)), true, stored);
  }

  void shade_pixel(int32_t x, int32_t y, uint32_t covered) const {
    uint32_t landed = 0;
    for (uint32_t rest = covered & draw.input.state.sample_mask; rest != 0; rest &= rest - 1) {
      const auto sample = static_cast<uint32_t>(std::countr_zero(rest));
      landed |= static_cast<uint32_t>(lands(x, y, sample)) << sample;
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
      emit_fragment(fragment);
      return;
    }
    for (uint32_t rest = landed; rest != 0; rest &= rest - 1) {
      const auto sample = static_cast<uint32_t>(std::countr_zero(rest));
      fragment.samples = 1U << sample;
      fragment.position = location(sample);
      emit_fragment(fragment);
    }
  }

  void emit_fragment(const Fragment& fragment) const {
    if constexpr (ColorProgram<P>) {
      const auto packed = static_cast<uint32_t>(packed_color<ScalarLanes>(fragment.x, fragment.y, fragment.position));
      for (uint32_t rest = fragment.samples; rest != 0; rest &= rest - 1) {
        draw.input.color.values[index_of(fragment.x, fragment.y) + static_cast<size_t>(std::countr_zero(rest))] =
            packed;
      }
    } else {
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

// The pixel of the tile that is nearest to a primitive's own anchor: not too far to lose digits, and independent of
// the scissor.
inline void set_anchor(const PixelRect& tile_pixels, ShadedPrimitive& primitive) {
  primitive.anchor_x = std::clamp(primitive.interpolation->anchor_x, tile_pixels.left, tile_pixels.right - 1);
  primitive.anchor_y = std::clamp(primitive.interpolation->anchor_y, tile_pixels.top, tile_pixels.bottom - 1);
}

// Coverage is TileCoverage for draws of one sample a pixel, which are much the faster for it, and else
// SampledTileCoverage.
template <typename L, typename Coverage, Program P>
[[gnu::always_inline]] inline void shade_tile(const PreparedDraw& draw, const P& program,
                                              const std::vector<ClipPosition>& positions_clip,
                                              const PixelRect& tile_pixels, uint32_t tile,
                                              std::span<const PrimitiveChunk> chunks) {
  Coverage coverage;
  for (const PrimitiveChunk& chunk : chunks) {
    TileEntries entries = chunk.entries(tile);
    while (const SetupPrimitive* const primitive = entries.next()) {
      const PixelRect rect = intersection(primitive->bounds(), tile_pixels);
      if (rect.empty()) {
        continue;
      }
      const std::span<const FixedPosition> outline = primitive->outline(chunk.polygon_vertices());
      cover_tile(draw, outline, rect, coverage);
      if (coverage.count == 0) {
        continue;
      }
      const std::array<uint32_t, 3> vertices = draw.assembly.vertices(primitive->primitive);
      const PrimitiveInterpolation interpolation =
          make_interpolation(draw, *primitive, vertices, positions_clip, outline);
      ShadedPrimitive shaded{.primitive = primitive->primitive,
                             .vertices = vertices,
                             .front_facing = primitive->front_facing,
                             .interpolation = &interpolation};
      set_anchor(tile_pixels, shaded);
      const typename P::PrimitiveData data = program.primitive_data(shaded);
      const Shader<L, P> shader{draw,          program,
                                data,          shaded,
                                interpolation, interpolation.reciprocal_w_plane(shaded.anchor_x, shaded.anchor_y)};
      for (uint32_t i = 0; i < coverage.count; ++i) {
        shader.shade(coverage.blocks[i]);
      }
    }
  }
}

}  // namespace fillrule::renderer::internal
