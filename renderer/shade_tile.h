// One tile: the primitives that touch it, in the order of submission, from coverage to the attachments.
//
// A block of 8x8 pixels is shaded row by row, as many pixels at once as there are lanes; blocks lie on multiples of 8
// pixels, so that none reaches into another tile. Where a row of lanes would reach beyond the target, and where a
// program wants its fragments one by one, pixels are.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "renderer/row_emitter.h"
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
  VaryingPlane reciprocal_w;

  [[gnu::always_inline]] void shade(const CoverageBlock& block) const {
    if (static_cast<uint32_t>(block.x + kBlockSize) > draw.input.target_width) {
      shade_rows<ScalarLanes>(block);
    } else {
      shade_rows<L>(block);
    }
  }

  [[gnu::always_inline]] void shade(const SampledBlock& block) const {
    constexpr uint32_t kUsualSamples = 4;
    if constexpr (ColorProgram<P> && L::kWidth >= kUsualSamples) {
      const bool is_within = static_cast<uint32_t>(block.x + kBlockSize) <= draw.input.target_width;
      if (draw.input.samples == kUsualSamples && !draw.input.sample_shading && is_within) {
        shade_sampled_rows<kUsualSamples>(block);
        return;
      }
    }
    shade_pixels(block);
  }

 private:
  void shade_pixels(const SampledBlock& block) const {
    for (uint64_t mask = block.any; mask != 0; mask &= mask - 1) {
      const int32_t bit = std::countr_zero(mask);
      shade_pixel(block.x + bit % kBlockSize, block.y + bit / kBlockSize,
                  block.samples_at(static_cast<uint32_t>(bit)));
    }
  }

  // A pixel's first value in the attachments.
  [[nodiscard]] size_t index_of(int32_t x, int32_t y) const {
    return (static_cast<size_t>(y) * draw.input.target_width + static_cast<size_t>(x)) * draw.input.samples;
  }

  template <typename Lanes>
  [[gnu::always_inline]] void shade_rows(const CoverageBlock& block) const {
    const WindowPlane depth = interpolation.depth_framebuffer;
    const size_t first = index_of(block.x, block.y);
    const size_t row_stride = draw.input.target_width;
    float* const stored_depths = draw.input.depth.values.data() + first;
    const DepthStage stage = draw.depth;
    const bool tests = stage.tests();
    for (int32_t column = 0; column < kBlockSize; column += static_cast<int32_t>(Lanes::kWidth)) {
      const int32_t x = block.x + column;
      const auto xs = Lanes::to_double(Lanes::numbers() + (x - interpolation.anchor_x));
      const auto depth_column = Lanes::all(depth.at_anchor) + Lanes::all(depth.step_x) * xs;
      const RowEmitter<Lanes, P> emitter(*this, x, first + static_cast<size_t>(column));
      for (int32_t row = 0; row < kBlockSize; ++row) {
        constexpr uint32_t kAllLanes = (1U << Lanes::kWidth) - 1;
        const auto bits = static_cast<uint32_t>(block.mask >> (row * kBlockSize + column)) & kAllLanes;
        if (bits == 0) {
          continue;
        }
        const int32_t y = block.y + row;
        typename Lanes::Mask mask = Lanes::mask_of(bits);
        if (tests) {
          float* const stored_depth = stored_depths + static_cast<size_t>(row) * row_stride + column;
          typename Lanes::Float stored = Lanes::load(stored_depth);
          const double depth_row = depth.step_y * (y - interpolation.anchor_y);
          mask = stage.template lands<Lanes>(depth_column + Lanes::all(depth_row), mask, stored);
          if (!Lanes::any(mask)) {
            continue;
          }
          Lanes::store(stored, stored_depth);
        }
        emitter.emit(static_cast<size_t>(row) * row_stride, y, mask);
      }
    }
  }

  // The samples of as many pixels as there are lanes lie in kSamples vectors side by side.
  template <uint32_t kSamples>
  [[gnu::always_inline]] void shade_sampled_rows(const SampledBlock& block) const {
    constexpr uint32_t kAllLanes = (1U << L::kWidth) - 1;
    const WindowPlane depth = interpolation.depth_framebuffer;
    const DepthStage stage = draw.depth;
    const bool tests = stage.tests();
    const size_t first = index_of(block.x, block.y);
    const size_t row_stride = size_t{draw.input.target_width} * kSamples;
    for (int32_t column = 0; column < kBlockSize; column += static_cast<int32_t>(L::kWidth)) {
      const int32_t x = block.x + column;
      std::array<typename L::Double, kSamples> depth_columns;
      for (uint32_t part = 0; part < kSamples; ++part) {
        const auto xs = L::all(static_cast<double>(x - interpolation.anchor_x)) +
                        L::load(draw.sample_offsets_x.data() + size_t{part} * L::kWidth);
        depth_columns[part] = L::all(depth.at_anchor) + L::all(depth.step_x) * xs;
      }
      const size_t offset = first + static_cast<size_t>(column) * kSamples;
      const RowEmitter<L, P> emitter(*this, x, offset);
      for (int32_t row = 0; row < kBlockSize; ++row) {
        uint32_t bits = 0;  // a byte for each sample
        for (uint32_t sample = 0; sample < kSamples; ++sample) {
          if ((draw.input.state.sample_mask >> sample & 1U) != 0) {
            bits |= (static_cast<uint32_t>(block.masks[sample] >> (row * kBlockSize + column)) & kAllLanes)
                    << (8 * sample);
          }
        }
        if (bits == 0) {
          continue;
        }
        const int32_t y = block.y + row;
        const size_t row_offset = static_cast<size_t>(row) * row_stride;
        float* const stored_depths = draw.input.depth.values.data() + offset + row_offset;
        const auto ys =
            L::all(static_cast<double>(y - interpolation.anchor_y)) + L::load(draw.sample_offsets_y.data());
        const auto depth_row = L::all(depth.step_y) * ys;
        std::array<typename L::Mask, kSamples> masks;
        typename L::Mask any = L::mask_of(0);
        [&]<uint32_t... kPart>(std::integer_sequence<uint32_t, kPart...>) __attribute__((always_inline)) {
          ((masks[kPart] = sampled_mask<kSamples, kPart>(bits)), ...);
        }
        (std::make_integer_sequence<uint32_t, kSamples>());
        for (uint32_t part = 0; part < kSamples; ++part) {
          if (tests) {
            float* const stored_depth = stored_depths + size_t{part} * L::kWidth;
            typename L::Float stored = L::load(stored_depth);
            masks[part] = stage.template lands<L>(depth_columns[part] + depth_row, masks[part], stored);
            L::store(stored, stored_depth);
          }
          any = any | masks[part];
        }
        if (L::any(any)) {
          emitter.template emit_samples<kSamples>(row_offset, y, masks);
        }
      }
    }
  }

  // Of vector kPart the lanes whose bits are set: bit i of byte s is sample s of pixel i.
  template <uint32_t kSamples, uint32_t kPart>
  [[gnu::always_inline]] static typename L::Mask sampled_mask(uint32_t bits) {
    const typename L::Int lane = L::numbers() + static_cast<int32_t>(kPart * L::kWidth);
    const typename L::Int own =
        1 << (lane % static_cast<int32_t>(kSamples) * 8 + lane / static_cast<int32_t>(kSamples));
    return ((own & static_cast<int32_t>(bits)) == own);
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
      const auto packed = static_cast<uint32_t>(packed_color<ScalarLanes>(
          program, data, reciprocal_w, static_cast<float>(fragment.x - primitive.anchor_x + fragment.position.x),
          static_cast<float>(fragment.y - primitive.anchor_y + fragment.position.y)));
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

// Asks for what the next primitives will need: those of a tile are far apart in memory.
template <Program P>
[[gnu::always_inline]] inline void prefetch(const PreparedDraw& draw, const P& program,
                                            const std::vector<ClipPosition>& positions_clip,
                                            const TileEntries& entries) {
  constexpr size_t kFar = 8;
  constexpr size_t kNear = 4;  // has arrived since it was far
  if (const SetupPrimitive* const far = entries.ahead(kFar)) {
    __builtin_prefetch(far);
  }
  if (const SetupPrimitive* const near = entries.ahead(kNear)) {
    for (const uint32_t vertex : draw.assembly.vertices(near->primitive)) {
      __builtin_prefetch(&positions_clip[vertex]);
      if constexpr (requires { program.prefetch(vertex); }) {
        program.prefetch(vertex);
      }
    }
  }
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
      prefetch(draw, program, positions_clip, entries);
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
                                interpolation, reciprocal_w_plane(interpolation, shaded.anchor_x, shaded.anchor_y)};
      for (uint32_t i = 0; i < coverage.count; ++i) {
        shader.shade(coverage.blocks[i]);
      }
    }
  }
}

}  // namespace fillrule::renderer::internal
