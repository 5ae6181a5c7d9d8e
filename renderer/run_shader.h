// Primitives in runs of eight pixels of a row (row_spans.h): first the depth tests of all of them, then the colours
// of those that are left, so that neither has to guess which those will be, nor how many a primitive has.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "renderer/lane_pairs.h"
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

  // The runs [first, end), of which nothing of use is left.
  [[gnu::always_inline]] void shade(RunList& runs, uint32_t first, uint32_t end) const {
    if constexpr (!ColorProgram<P> && kSamples > 1) {
      for (uint32_t i = first; i < end; ++i) {
        shade_pixels(runs.run(i));
      }
    } else {
      end = draw.depth.is_usual() ? test<true>(runs, first, end) : test<false>(runs, first, end);
      if constexpr (ColorProgram<P>) {
        write_colors(runs, first, end);
      } else {
        for (uint32_t i = first; i < end; ++i) {
          emit_fragments(runs.run(i));
        }
      }
    }
  }

 private:
  static constexpr uint32_t kVectors = kBlockSize * kSamples / L::kWidth;

  // The runs that have a sample which passes the depth test, which is done, are put together; where they end.
  template <bool kIsUsual>
  [[gnu::always_inline]] uint32_t test(RunList& runs, uint32_t first, uint32_t end) const {
    const bool has_test = kIsUsual || draw.depth.tests();
    const auto pixels = attachments.template pixels<kSamples>();
    const DepthStage stage = draw.depth;
    const uint32_t sample_bits = draw.run_sample_bits;
    const TilePrimitive<P>* const of_runs = primitives.data();
    uint32_t count = first;
    for (uint32_t i = first; i < end; ++i) {
      const PixelRun run = runs.run(i);
      uint32_t samples = run.samples & sample_bits;
      if (has_test) {
        const PrimitiveInterpolation& planes = of_runs[run.primitive].interpolation;
        const auto [columns, row] =
            depths(planes.depth_framebuffer, run.x - planes.anchor_x, run.y - planes.anchor_y);
        samples = test_row<L, kIsUsual, false>(stage, columns, row, pixels.depths_at(run.x, run.y), samples);
      }
      runs.keep(count, i, samples);
      count += samples != 0 ? 1 : 0;
    }
    return count;
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

  // Two runs at once where lanes come in pairs and both runs are of one primitive.
  [[gnu::always_inline]] void write_colors(const RunList& runs, uint32_t first, uint32_t end) const {
    const auto pixels = attachments.template pixels<kSamples>();
    for (uint32_t i = first; i < end; ++i) {
      if constexpr (LanePairs<L>::kExist) {
        if (i + 1 < end && runs.primitives[i] == runs.primitives[i + 1]) {
          write_pair(runs.run(i), runs.run(i + 1), pixels);
          ++i;
          continue;
        }
      }
      write_colors(runs.run(i), pixels);
    }
  }

  using Pixels = TileAttachments::Pixels<kSamples>;

  [[gnu::always_inline]] void write_colors(const PixelRun& run, const Pixels& pixels) const {
    const TilePrimitive<P>& primitive = primitives[run.primitive];
    for (uint32_t column = 0; column < kBlockSize; column += L::kWidth) {
      const auto packed = packed_color<L>(program, primitive.data, primitive.reciprocal_w,
                                          x_from_anchor(primitive, run, column), y_from_anchor(primitive, run));
      write_samples<L, kSamples, false>(packed, run.samples >> (column * kSamples),
                                        pixels.colors_at(run.x, run.y) + size_t{column} * kSamples);
    }
  }

  [[gnu::always_inline]] void write_pair(const PixelRun& first, const PixelRun& second, const Pixels& pixels) const {
    using Pairs = LanePairs<L>;
    static_assert(L::kWidth == kBlockSize);
    const TilePrimitive<P>& primitive = primitives[first.primitive];
    const auto packed = packed_color<typename Pairs::Lanes>(
        program, primitive.data, primitive.reciprocal_w,
        Pairs::pair(x_from_anchor(primitive, first, 0), x_from_anchor(primitive, second, 0)),
        Pairs::pair(y_from_anchor(primitive, first), y_from_anchor(primitive, second)));
    write_samples<L, kSamples, false>(Pairs::first_of(packed), first.samples, pixels.colors_at(first.x, first.y));
    write_samples<L, kSamples, false>(Pairs::second_of(packed), second.samples, pixels.colors_at(second.x, second.y));
  }

  [[gnu::always_inline]] static typename L::Float x_from_anchor(const TilePrimitive<P>& primitive,
                                                                const PixelRun& run, uint32_t column) {
    return L::to_float(L::numbers() + (run.x - primitive.shaded.anchor_x + static_cast<int32_t>(column)));
  }
  [[gnu::always_inline]] static typename L::Float y_from_anchor(const TilePrimitive<P>& primitive,
                                                                const PixelRun& run) {
    return L::all(static_cast<float>(run.y - primitive.shaded.anchor_y));
  }

  // To a program without colours; a block's row must not reach into another tile.
  [[gnu::always_inline]] void emit_fragments(const PixelRun& run) const {
    const TilePrimitive<P>& primitive = primitives[run.primitive];
    if constexpr (BlockProgram<P>) {
      const int32_t beyond_tile = std::max(run.x + kBlockSize - tile_right, 0);
      program.template block<L>(primitive.data, run.x - beyond_tile, run.y, uint64_t{run.samples} << beyond_tile,
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
