// Primitives in runs of eight pixels of a row (row_spans.h): first the depth tests of all of them, then the colours
// of those that are left, so that neither has to guess which those will be, nor how many a primitive has.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "renderer/primitive_shader.h"
#include "renderer/row_spans.h"

namespace fillrule::renderer::internal {

// The blocks of the runs must have been loaded. A run's primitive is its number in `primitives`.
template <typename L, Program P, uint32_t kSamples>
struct RunShader {
  const PreparedDraw& draw;
  const P& program;
  std::span<const TilePrimitive<P>> primitives;
  const TileAttachments& attachments;
  int32_t tile_right;  // pixels

  // Nothing of use is left of `runs`.
  [[gnu::always_inline]] void shade(std::span<PixelRun> runs) const {
    if constexpr (!ColorProgram<P> && kSamples > 1) {
      for (const PixelRun& run : runs) {
        shade_pixels(run);
      }
    } else {
      const std::span<PixelRun> landed = draw.depth.is_usual() ? test<true>(runs) : test<false>(runs);
      for (const PixelRun& run : landed) {
        if constexpr (ColorProgram<P>) {
          write_colors(run);
        } else {
          emit_fragments(run);
        }
      }
    }
  }

 private:
  static constexpr uint32_t kVectors = kBlockSize * kSamples / L::kWidth;

  // The runs that have a sample which passes the depth test, which is done; they are put together.
  template <bool kIsUsual>
  [[gnu::always_inline]] std::span<PixelRun> test(std::span<PixelRun> runs) const {
    const bool has_test = kIsUsual || draw.depth.tests();
    size_t count = 0;
    for (const PixelRun run : runs) {
      uint32_t samples = run.samples & draw.run_sample_bits;
      if (has_test) {
        const PrimitiveInterpolation& planes = primitives[run.primitive].interpolation;
        const auto [columns, row] =
            depths(planes.depth_framebuffer, run.x - planes.anchor_x, run.y - planes.anchor_y);
        samples =
            test_row<L, kIsUsual, false>(draw.depth, columns, row, attachments.at(run.x, run.y).depths, samples);
      }
      runs[count] = {run.x, run.y, samples, run.primitive};
      count += samples != 0 ? 1 : 0;
    }
    return runs.first(count);
  }

  struct RunDepths {
    std::array<typename L::Double, kVectors> columns;
    typename L::Double row;
  };

  // What the depths of a run's samples are the sum of.
  [[nodiscard, gnu::always_inline]] RunDepths depths(const WindowPlane& depth, int32_t x_from_anchor,
                                                     int32_t y_from_anchor) const {
    RunDepths result;
    for (uint32_t vector = 0; vector < kVectors; ++vector) {
      typename L::Double xs;
      if constexpr (kSamples == 1) {
        xs = L::to_double(L::numbers() + (x_from_anchor + static_cast<int32_t>(vector * L::kWidth)));
      } else {
        xs = L::all(static_cast<double>(x_from_anchor)) +
             L::load(draw.sample_offsets_x.data() + size_t{vector} * L::kWidth);
      }
      result.columns[vector] = L::all(depth.at_anchor) + L::all(depth.step_x) * xs;
    }
    if constexpr (kSamples == 1) {
      result.row = L::all(depth.step_y * y_from_anchor);
    } else {
      const auto ys = L::all(static_cast<double>(y_from_anchor)) + L::load(draw.sample_offsets_y.data());
      result.row = L::all(depth.step_y) * ys;
    }
    return result;
  }

  [[gnu::always_inline]] void write_colors(const PixelRun& run) const {
    const TilePrimitive<P>& primitive = primitives[run.primitive];
    const int32_t x_from_anchor = run.x - primitive.shaded.anchor_x;
    const auto y_from_anchor = static_cast<float>(run.y - primitive.shaded.anchor_y);
    uint32_t* const stored = attachments.at(run.x, run.y).colors;
    for (uint32_t column = 0; column < kBlockSize; column += L::kWidth) {
      const auto xs = L::to_float(L::numbers() + (x_from_anchor + static_cast<int32_t>(column)));
      const auto packed = packed_color<L>(program, primitive.data, primitive.reciprocal_w, xs, y_from_anchor);
      write_samples<L, kSamples, false>(packed, run.samples >> (column * kSamples),
                                        stored + size_t{column} * kSamples);
    }
  }

  // To a program without colours; a block's row must not reach into another tile.
  [[gnu::always_inline]] void emit_fragments(const PixelRun& run) const {
    const TilePrimitive<P>& primitive = primitives[run.primitive];
    if constexpr (BlockProgram<P>) {
      const int32_t beyond_tile = std::max(run.x + kBlockSize - tile_right, 0);
      program.block(primitive.data, run.x - beyond_tile, run.y, uint64_t{run.samples} << beyond_tile,
                    primitive.interpolation);
    } else {
      for (uint32_t rest = run.samples; rest != 0; rest &= rest - 1) {
        program.fragment(primitive.data,
                         {.x = run.x + std::countr_zero(rest), .y = run.y, .interpolation = primitive.interpolation});
      }
    }
  }

  void shade_pixels(const PixelRun& run) const {
    constexpr uint32_t kAllSamples = (1U << kSamples) - 1;
    const PrimitiveShader<P> shader{draw, program, primitives[run.primitive]};
    for (int32_t pixel = 0; pixel < kBlockSize; ++pixel) {
      const uint32_t covered = run.samples >> (static_cast<uint32_t>(pixel) * kSamples) & kAllSamples;
      if (covered != 0) {
        shader.shade_pixel(run.x + pixel, run.y, covered, attachments.at(run.x + pixel, run.y));
      }
    }
  }
};

}  // namespace fillrule::renderer::internal
