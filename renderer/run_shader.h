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
#include "renderer/run_planes.h"

namespace fillrule::renderer::internal {

// The blocks of the runs must have been loaded. Planes are those of the runs' primitives (run_planes.h).
template <typename L, Program P, uint32_t kSamples, typename Planes>
struct RunShader {
  const PreparedDraw& draw;
  const P& program;
  const Planes& planes;
  const TileAttachments& attachments;
  PixelRect tile_pixels;

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
    // Without its only sample a draw has nothing to do, and gets not here.
    const uint32_t sample_bits = kSamples == 1 ? ~0U : draw.run_sample_bits;
    uint32_t count = first;
    for (uint32_t i = first; i < end; ++i) {
      const PixelRun run = runs.run(i);
      uint32_t samples = run.samples & sample_bits;
      if (has_test) {
        const auto [columns, row] = depths(run);
        samples = test_row<L, kIsUsual, false>(stage, columns, row, pixels.depths_at(run.pixel), samples);
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
  [[nodiscard, gnu::always_inline]] RunDepths depths(const PixelRun& run) const {
    const WindowPlane& depth = planes.depth_framebuffer(run.primitive);
    const AnchorDistance distance = planes.depth_distance(run.primitive);
    const int32_t x = distance.x + static_cast<int32_t>(run.x());
    const auto y = static_cast<double>(distance.y + static_cast<int32_t>(run.y()));
    RunDepths result;
    for (uint32_t vector = 0; vector < kVectors; ++vector) {
      typename L::Double of_columns;
      if constexpr (kSamples == 1) {
        of_columns = L::to_double(L::numbers() + (x + static_cast<int32_t>(vector * L::kWidth)));
      } else {
        of_columns =
            L::all(static_cast<double>(x)) + L::load(draw.sample_offsets_x.data() + size_t{vector} * L::kWidth);
      }
      result.columns[vector] = L::all(depth.at_anchor) + L::all(depth.step_x) * of_columns;
    }
    if constexpr (kSamples == 1) {
      result.row = L::all(depth.step_y * y);
    } else {
      result.row = L::all(depth.step_y) * (L::all(y) + L::load(draw.sample_offsets_y.data()));
    }
    return result;
  }

  // Two runs at once where lanes come in pairs and both runs are of one primitive; a run that is alone goes with
  // itself, for whether it is alone cannot be foreseen.
  [[gnu::always_inline]] void write_colors(const RunList& runs, uint32_t first, uint32_t end) const {
    const auto pixels = attachments.template pixels<kSamples>();
    if constexpr (LanePairs<L>::kExist) {
      for (uint32_t i = first; i < end; ++i) {
        const PixelRun run = runs.run(i);
        const uint32_t of_same = runs.run(i + 1).primitive == run.primitive ? 1 : 0;
        i += (i + 1 < end ? 1U : 0U) & of_same;
        const PixelRun second = runs.run(i);
        write_pair(run, {second.pixel, second.samples, run.primitive}, pixels);
      }
    } else {
      for (uint32_t i = first; i < end; ++i) {
        write_colors(runs.run(i), pixels);
      }
    }
  }

  using Pixels = TileAttachments::Pixels<kSamples>;

  [[gnu::always_inline]] void write_colors(const PixelRun& run, const Pixels& pixels) const {
    for (uint32_t column = 0; column < kBlockSize; column += L::kWidth) {
      const auto packed = planes.template color<L>(run.primitive, x_from_anchor(run, column), y_from_anchor(run));
      write_samples<L, kSamples, false>(packed, run.samples >> (column * kSamples),
                                        pixels.colors_at(run.pixel) + size_t{column} * kSamples);
    }
  }

  [[gnu::always_inline]] void write_pair(const PixelRun& first, const PixelRun& second, const Pixels& pixels) const {
    using Pairs = LanePairs<L>;
    static_assert(L::kWidth == kBlockSize);
    const auto packed = planes.template color<typename Pairs::Lanes>(
        first.primitive, Pairs::pair(x_from_anchor(first, 0), x_from_anchor(second, 0)),
        Pairs::pair(y_from_anchor(first), y_from_anchor(second)));
    write_samples<L, kSamples, false>(Pairs::first_of(packed), first.samples, pixels.colors_at(first.pixel));
    write_samples<L, kSamples, false>(Pairs::second_of(packed), second.samples, pixels.colors_at(second.pixel));
  }

  // Of the run's pixels from this one on, from the anchor of the planes of varyings.
  [[nodiscard, gnu::always_inline]] typename L::Float x_from_anchor(const PixelRun& run, uint32_t column) const {
    const int32_t x = planes.color_distance(run.primitive).x + static_cast<int32_t>(run.x() + column);
    return L::load(distances_from(x));
  }
  [[nodiscard, gnu::always_inline]] typename L::Float y_from_anchor(const PixelRun& run) const {
    return L::all(*distances_from(planes.color_distance(run.primitive).y + static_cast<int32_t>(run.y())));
  }

  // To a program without colours; a block's row must not reach into another tile.
  [[gnu::always_inline]] void emit_fragments(const PixelRun& run) const {
    const TilePrimitive<P>& primitive = planes.primitives[run.primitive];
    const int32_t x = tile_pixels.left + static_cast<int32_t>(run.x());
    const int32_t y = tile_pixels.top + static_cast<int32_t>(run.y());
    if constexpr (BlockProgram<P>) {
      const int32_t beyond_tile = std::max(x + kBlockSize - tile_pixels.right, 0);
      program.template block<L>(primitive.data, x - beyond_tile, y, uint64_t{run.samples} << beyond_tile,
                                primitive.interpolation);
    } else {
      for (uint32_t rest = run.samples; rest != 0; rest &= rest - 1) {
        program.fragment(primitive.data,
                         {.x = x + std::countr_zero(rest), .y = y, .interpolation = primitive.interpolation});
      }
    }
  }

  void shade_pixels(const PixelRun& run) const {
    constexpr uint32_t kAllSamples = (1U << kSamples) - 1;
    const PrimitiveShader<P> shader{draw, program, planes.primitives[run.primitive]};
    for (uint32_t pixel = 0; pixel < kBlockSize; ++pixel) {
      const uint32_t covered = run.samples >> (pixel * kSamples) & kAllSamples;
      if (covered != 0) {
        const int32_t x = tile_pixels.left + static_cast<int32_t>(run.x() + pixel);
        const int32_t y = tile_pixels.top + static_cast<int32_t>(run.y());
        shader.shade_pixel(x, y, covered, attachments.at(x, y));
      }
    }
  }
};

}  // namespace fillrule::renderer::internal
