// One primitive in one block of 8x8 pixels, row by row, as many pixels at once as there are lanes. Where a program
// wants its fragments one by one, pixels are.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "renderer/edge_fill.h"
#include "renderer/lane_pairs.h"
#include "renderer/primitive_shader.h"
#include "renderer/sample_rows.h"

namespace fillrule::renderer::internal {

template <typename L, Program P>
struct BlockShader {
  const PrimitiveShader<P>& shader;
  TileAttachments& attachments;

  [[gnu::always_inline]] void shade(const CoverageBlock& block) const {
    const TileAttachments::Values values = attachments.block(block.x, block.y);
    uint64_t landed = block.mask;
    if (shader.draw.depth.is_usual()) {
      if (is_hidden(block)) {
        return;
      }
      landed = block.mask == kFullMask ? landed_pixels<true, true>(block, values.depths)
                                       : landed_pixels<true, false>(block, values.depths);
      if (landed == 0) {
        attachments.set_depth_limit(block.x, block.y, greatest_depth<1>(values.depths));
        return;
      }
    } else if (shader.draw.depth.tests()) {
      landed = landed_pixels<false, false>(block, values.depths);
    }
    if constexpr (ColorProgram<P>) {
      if (landed == kFullMask) {
        write_full_block<1>(block.x, block.y, values.colors);
        return;
      }
      for (int32_t column = 0; column < kBlockSize; column += static_cast<int32_t>(L::kWidth)) {
        const PrimitiveColors<L, P> colors(shader);
        const auto x_from_anchor = colors.x_from_anchor(block.x + column);
        if constexpr (LanePairs<L>::kExist) {
          colors.write_row_pairs(x_from_anchor, block.y, landed, values.colors);
          continue;
        }
        const uint64_t own = landed & column_mask(column);
        for (uint64_t rest = own; rest != 0;) {
          const int32_t row = std::countr_zero(rest) / kBlockSize;
          rest &= ~(uint64_t{0xFF} << (row * kBlockSize));
          const auto packed = colors.packed(x_from_anchor, colors.y_from_anchor(block.y + row));
          write_samples<L, 1, false>(packed, bits_at(own, column, row),
                                     values.colors + ptrdiff_t{row} * kTileSize + column);
        }
      }
    } else if constexpr (BlockProgram<P>) {
      if (landed != 0) {
        shader.program.template block<L>(shader.primitive.data, block.x, block.y, landed,
                                         shader.primitive.interpolation);
      }
    } else {
      for (; landed != 0; landed &= landed - 1) {
        const int32_t bit = std::countr_zero(landed);
        shader.program.fragment(shader.primitive.data, {.x = block.x + bit % kBlockSize,
                                                        .y = block.y + bit / kBlockSize,
                                                        .interpolation = shader.primitive.interpolation});
      }
    }
  }

  [[gnu::always_inline]] void shade(const SampledBlock& block) const {
    constexpr uint32_t kUsualSamples = 4;
    const TileAttachments::Values values = attachments.block(block.x, block.y);
    if constexpr (ColorProgram<P> && L::kWidth >= kUsualSamples) {
      if (shader.draw.input.samples == kUsualSamples && !shader.draw.input.sample_shading) {
        shade_sampled_rows<kUsualSamples>(block, values);
        return;
      }
    }
    for (uint64_t mask = block.any; mask != 0; mask &= mask - 1) {
      const auto bit = static_cast<uint32_t>(std::countr_zero(mask));
      const int32_t x = block.x + static_cast<int32_t>(bit) % kBlockSize;
      const int32_t y = block.y + static_cast<int32_t>(bit) / kBlockSize;
      shader.shade_pixel(x, y, block.samples_at(bit), attachments.at(x, y));
    }
  }

 private:
  static constexpr uint32_t kAllLanes = (1U << L::kWidth) - 1;

  // The pixels of as many columns as there are lanes.
  static constexpr uint64_t column_mask(int32_t column) {
    return uint64_t{0x0101010101010101} * kAllLanes << static_cast<uint32_t>(column);
  }

  // A block's bits of as many pixels as there are lanes.
  [[gnu::always_inline]] static uint32_t bits_at(uint64_t mask, int32_t column, int32_t row) {
    return static_cast<uint32_t>(mask >> (row * kBlockSize + column)) & kAllLanes;
  }

  // Those of a block's pixels that pass the depth test, which is done.
  template <bool kIsUsual, bool kIsFull>
  [[gnu::always_inline]] uint64_t landed_pixels(const CoverageBlock& block, float* depths) const {
    const WindowPlane depth = shader.primitive.interpolation.depth_framebuffer;
    const std::array<double, kBlockSize> depth_rows = depths_of_rows(block.y);
    uint64_t landed = 0;
    for (int32_t column = 0; column < kBlockSize; column += static_cast<int32_t>(L::kWidth)) {
      const auto xs = L::to_double(L::numbers() + (block.x + column - shader.primitive.interpolation.anchor_x));
      const auto depth_column = L::all(depth.at_anchor) + L::all(depth.step_x) * xs;
      const auto test_row = [&](auto row) __attribute__((always_inline)) {
        constexpr int32_t kRow = decltype(row)::value;
        const typename L::Some mask = kIsFull ? L::some(kAllLanes) : row_mask<kRow>(block.mask, column);
        landed |= uint64_t{test_depths<L, kIsUsual>(shader.draw.depth, depth_column + L::all(depth_rows[kRow]), mask,
                                                    depths + ptrdiff_t{kRow} * kTileSize + column)}
                  << (kRow * kBlockSize + column);
      };
      // Of half a block a row more costs less than to guess wrong which of them are empty.
      if (kIsFull || static_cast<uint32_t>(block.mask) != 0) {
        test_row(std::integral_constant<int32_t, 0>());
        test_row(std::integral_constant<int32_t, 1>());
        test_row(std::integral_constant<int32_t, 2>());
        test_row(std::integral_constant<int32_t, 3>());
      }
      if (kIsFull || block.mask >> 32U != 0) {
        test_row(std::integral_constant<int32_t, 4>());
        test_row(std::integral_constant<int32_t, 5>());
        test_row(std::integral_constant<int32_t, 6>());
        test_row(std::integral_constant<int32_t, 7>());
      }
    }
    return landed;
  }

  // What the depth changes by from the anchor to each row of a block.
  [[nodiscard, gnu::always_inline]] std::array<double, kBlockSize> depths_of_rows(int32_t y) const {
    const PrimitiveInterpolation& planes = shader.primitive.interpolation;
    std::array<double, kBlockSize> depths;
    for (uint32_t row = 0; row < kBlockSize; row += L::kWidth) {
      const auto ys = L::to_double(L::numbers() + (y + static_cast<int32_t>(row) - planes.anchor_y));
      L::store(L::all(planes.depth_framebuffer.step_y) * ys, depths.data() + row);
    }
    return depths;
  }

  // A row of a block's mask, from the column on.
  template <int32_t kRow>
  [[gnu::always_inline]] static typename L::Some row_mask(uint64_t mask, int32_t column) {
    constexpr auto kFirst = static_cast<uint32_t>(kRow * kBlockSize);
    if constexpr (L::kWidth == kBlockSize) {
      return L::template some_from<kFirst>(mask);
    } else {
      return L::template some_from<kFirst>(mask >> static_cast<uint32_t>(column));
    }
  }

  // All of a block's samples. No row is asked whether anything landed on it, so that the compiler computes what rows
  // share once: it does not take floating-point operations out of what may not be done.
  template <uint32_t kSamples>
  // NOLINTNEXTLINE(readability-non-const-parameter): it is written to
  [[gnu::always_inline]] void write_full_block(int32_t x, int32_t y, uint32_t* stored) const {
    const PrimitiveColors<L, P> colors(shader);
    for (int32_t column = 0; column < kBlockSize; column += static_cast<int32_t>(L::kWidth)) {
      const auto x_from_anchor = colors.x_from_anchor(x + column);
      uint32_t* of_row = stored + ptrdiff_t{column} * kSamples;
      if constexpr (LanePairs<L>::kExist) {
        using Pairs = LanePairs<L>;
        using Both = typename Pairs::Lanes;
        const auto xs = Pairs::pair(x_from_anchor, x_from_anchor);
        auto ys = Pairs::pair(colors.y_from_anchor(y), colors.y_from_anchor(y + 1));
        for (int32_t row = 0; row < kBlockSize; row += 2) {
          const auto pair = colors.template packed<Both>(xs, ys);
          write_samples<L, kSamples, true>(Pairs::first_of(pair), ~0U, of_row);
          of_row += size_t{kTileSize} * kSamples;
          write_samples<L, kSamples, true>(Pairs::second_of(pair), ~0U, of_row);
          of_row += size_t{kTileSize} * kSamples;
          ys = ys + Both::all(2.0F);  // whole, and small: exact
        }
      } else {
        auto ys = colors.y_from_anchor(y);
        for (int32_t row = 0; row < kBlockSize; ++row) {
          write_samples<L, kSamples, true>(colors.packed(x_from_anchor, ys), ~0U, of_row);
          of_row += size_t{kTileSize} * kSamples;
          ys = ys + L::all(1.0F);
        }
      }
    }
  }

  // The samples of as many pixels as there are lanes lie in kSamples vectors side by side.
  template <uint32_t kSamples>
  [[gnu::always_inline]] void shade_sampled_rows(const SampledBlock& block,
                                                 const TileAttachments::Values& values) const {
    if (shader.draw.depth.is_usual() && is_hidden(block)) {
      return;
    }
    SampleRows landed = sample_rows(block, shader.draw.input.state.sample_mask);
    if (shader.draw.depth.is_usual()) {
      const bool any = is_full(landed) ? test_samples<kSamples, true, true>(block, values.depths, landed)
                                       : test_samples<kSamples, true, false>(block, values.depths, landed);
      if (!any) {
        attachments.set_depth_limit(block.x, block.y, greatest_depth<kSamples>(values.depths));
        return;
      }
    } else if (shader.draw.depth.tests()) {
      test_samples<kSamples, false, false>(block, values.depths, landed);
    }
    if (is_full(landed)) {
      write_full_block<kSamples>(block.x, block.y, values.colors);
    } else {
      write_landed<kSamples>(block.x, block.y, landed, values.colors);
    }
  }

  // Those of a block's samples.
  template <uint32_t kSamples>
  // NOLINTNEXTLINE(readability-non-const-parameter): it is written to
  [[gnu::always_inline]] void write_landed(int32_t x, int32_t y, const SampleRows& landed, uint32_t* stored) const {
    const PrimitiveColors<L, P> colors(shader);
    for (uint32_t column = 0; column < kBlockSize; column += L::kWidth) {
      const auto x_from_anchor = colors.x_from_anchor(x + static_cast<int32_t>(column));
      const auto write_row = [&](const typename L::Int& packed, size_t row) __attribute__((always_inline)) {
        constexpr uint32_t kAllSamples = ~0U >> (32 - L::kWidth * kSamples);
        const uint32_t bits = landed[row] >> (column * kSamples) & kAllSamples;
        uint32_t* const of_row = stored + (row * kTileSize + column) * kSamples;
        if (bits == kAllSamples) {
          write_samples<L, kSamples, true>(packed, bits, of_row);
        } else if (bits != 0) {
          write_samples<L, kSamples, false>(packed, bits, of_row);
        }
      };
      if constexpr (LanePairs<L>::kExist) {
        for (size_t row = 0; row < kBlockSize; row += 2) {
          if ((landed[row] | landed[row + 1]) != 0) {
            const auto pair = colors.packed_pair(x_from_anchor, y + static_cast<int32_t>(row));
            write_row(LanePairs<L>::first_of(pair), row);
            write_row(LanePairs<L>::second_of(pair), row + 1);
          }
        }
      } else {
        for (size_t row = 0; row < kBlockSize; ++row) {
          if (landed[row] != 0) {
            write_row(colors.packed(x_from_anchor, colors.y_from_anchor(y + static_cast<int32_t>(row))), row);
          }
        }
      }
    }
  }

  // Leaves those of a block's samples that pass the depth test, which is done; whether there are any.
  template <uint32_t kSamples, bool kIsUsual, bool kIsFull>
  [[gnu::always_inline]] bool test_samples(const SampledBlock& block, float* depths, SampleRows& samples) const {
    constexpr uint32_t kVectors = kBlockSize * kSamples / L::kWidth;
    const WindowPlane depth = shader.primitive.interpolation.depth_framebuffer;
    std::array<typename L::Double, kVectors> columns;
    for (uint32_t vector = 0; vector < kVectors; ++vector) {
      const auto xs = L::all(static_cast<double>(block.x - shader.primitive.interpolation.anchor_x)) +
                      L::load(shader.draw.sample_offsets_x.data() + size_t{vector} * L::kWidth);
      columns[vector] = L::all(depth.at_anchor) + L::all(depth.step_x) * xs;
    }
    const auto offsets_y = L::load(shader.draw.sample_offsets_y.data());
    const DepthStage& stage = shader.draw.depth;
    uint32_t any = 0;
    for (uint32_t row = 0; row < kBlockSize; ++row) {
      if (!kIsFull && samples[row] == 0) {
        continue;
      }
      const auto ys =
          L::all(static_cast<double>(block.y + static_cast<int32_t>(row) - shader.primitive.interpolation.anchor_y)) +
          offsets_y;
      const auto depth_row = L::all(depth.step_y) * ys;
      float* const row_depths = depths + size_t{row} * kTileSize * kSamples;
      samples[row] = kIsFull || samples[row] == ~0U
                         ? test_row<L, kIsUsual, true>(stage, columns, depth_row, row_depths, ~0U)
                         : test_row<L, kIsUsual, false>(stage, columns, depth_row, row_depths, samples[row]);
      any |= samples[row];
    }
    return any != 0;
  }

  // Whether the usual test keeps all of a block's fragments from its samples.
  template <typename Block>
  [[nodiscard, gnu::always_inline]] bool is_hidden(const Block& block) const {
    const float limit = attachments.depth_limit(block.x, block.y);
    const PixelRect pixels{block.x, block.y, block.x + kBlockSize, block.y + kBlockSize};
    return limit < std::numeric_limits<float>::infinity() &&
           shader.draw.depth.hides(least_depth(shader.draw, shader.primitive.interpolation, pixels), limit);
  }

  // Of a block; what is no number is no limit.
  template <uint32_t kSamples>
  [[nodiscard, gnu::always_inline]] static float greatest_depth(const float* depths) {
    auto greatest = L::all(-std::numeric_limits<float>::infinity());
    for (uint32_t row = 0; row < kBlockSize; ++row, depths += size_t{kTileSize} * kSamples) {
      for (uint32_t i = 0; i < kBlockSize * kSamples; i += L::kWidth) {
        greatest = L::greater(L::load(depths + i), greatest);
      }
    }
    std::array<float, L::kWidth> lanes;
    L::store(greatest, lanes.data());
    return *std::max_element(lanes.begin(), lanes.end());
  }
};

}  // namespace fillrule::renderer::internal
