// One tile: the primitives that touch it, in the order of submission, from coverage to the attachments.
//
// A block of 8x8 pixels is shaded row by row, as many pixels at once as there are lanes; blocks lie on multiples of 8
// pixels, so that none reaches into another tile. Where a program wants its fragments one by one, pixels are.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "renderer/color_rows.h"
#include "renderer/edge_fill.h"
#include "renderer/sample_rows.h"
#include "renderer/shading.h"
#include "renderer/tile_attachments.h"

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

  TileAttachments& attachments;

  [[gnu::always_inline]] void shade(const CoverageBlock& block) const {
    const TileAttachments::Block values = attachments.block(block.x, block.y);
    uint64_t landed = block.mask;
    if (draw.depth.is_usual()) {
      landed = block.mask == kFullMask ? landed_pixels<true, true>(block, values.depths)
                                       : landed_pixels<true, false>(block, values.depths);
    } else if (draw.depth.tests()) {
      landed = landed_pixels<false, false>(block, values.depths);
    }
    if constexpr (ColorProgram<P>) {
      if (landed == kFullMask) {
        write_full_block(block, values.colors);
        return;
      }
      for (int32_t column = 0; column < kBlockSize; column += static_cast<int32_t>(L::kWidth)) {
        const ColorRows<L, P> colors(*this, block.x + column, values.colors + column);
        const uint64_t own = landed & column_mask(column);
        for (uint64_t rest = own; rest != 0;) {
          const int32_t row = std::countr_zero(rest) / kBlockSize;
          rest &= ~(uint64_t{0xFF} << (row * kBlockSize));
          colors.write(row * kBlockSize, block.y + row, L::mask_of(bits_at(own, column, row)));
        }
      }
    } else if constexpr (BlockProgram<P>) {
      if (landed != 0) {
        program.block(data, block.x, block.y, landed, interpolation);
      }
    } else {
      for (; landed != 0; landed &= landed - 1) {
        const int32_t bit = std::countr_zero(landed);
        program.fragment(
            data, {.x = block.x + bit % kBlockSize, .y = block.y + bit / kBlockSize, .interpolation = interpolation});
      }
    }
  }

  [[gnu::always_inline]] void shade(const SampledBlock& block) const {
    constexpr uint32_t kUsualSamples = 4;
    const TileAttachments::Block values = attachments.block(block.x, block.y);
    if constexpr (ColorProgram<P> && L::kWidth >= kUsualSamples) {
      if (draw.input.samples == kUsualSamples && !draw.input.sample_shading) {
        shade_sampled_rows<kUsualSamples>(block, values);
        return;
      }
    }
    for (uint64_t mask = block.any; mask != 0; mask &= mask - 1) {
      const auto bit = static_cast<uint32_t>(std::countr_zero(mask));
      shade_pixel(block, bit, values);
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
    const WindowPlane depth = interpolation.depth_framebuffer;
    uint64_t landed = 0;
    for (int32_t column = 0; column < kBlockSize; column += static_cast<int32_t>(L::kWidth)) {
      const auto xs = L::to_double(L::numbers() + (block.x + column - interpolation.anchor_x));
      const auto depth_column = L::all(depth.at_anchor) + L::all(depth.step_x) * xs;
      const auto test_row = [&](auto row) __attribute__((always_inline)) {
        constexpr int32_t kRow = decltype(row)::value;
        const double depth_row = depth.step_y * (block.y + kRow - interpolation.anchor_y);
        const typename L::Mask mask = kIsFull ? L::mask_of(kAllLanes) : row_mask<kRow>(block.mask, column);
        landed |= uint64_t{test_depths<kIsUsual>(depth_column + L::all(depth_row), mask,
                                                 depths + ptrdiff_t{kRow} * kBlockSize + column)}
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

  // A row of a block's mask, from the column on.
  template <int32_t kRow>
  [[gnu::always_inline]] static typename L::Mask row_mask(uint64_t mask, int32_t column) {
    constexpr auto kFirst = static_cast<uint32_t>(kRow * kBlockSize);
    if constexpr (L::kWidth == kBlockSize) {
      return L::template mask_from<kFirst>(mask);
    } else {
      return L::template mask_from<kFirst>(mask >> static_cast<uint32_t>(column));
    }
  }

  // Which of the values pass the depth test, of those in the mask.
  template <bool kIsUsual>
  [[gnu::always_inline]] uint32_t test_depths(const typename L::Double& depth_framebuffer,
                                              const typename L::Mask& values, float* stored_depths) const {
    const DepthStage stage = draw.depth;
    typename L::Float stored = L::load(stored_depths);
    const typename L::Mask mask = stage.template lands<L, kIsUsual>(depth_framebuffer, values, stored);
    L::store(stored, stored_depths);
    return L::bits_of(mask);
  }

  // NOLINTNEXTLINE(readability-non-const-parameter): ColorRows writes
  [[gnu::always_inline]] void write_full_block(const CoverageBlock& block, uint32_t* colors) const {
    for (int32_t column = 0; column < kBlockSize; column += static_cast<int32_t>(L::kWidth)) {
      const ColorRows<L, P> rows(*this, block.x + column, colors + column);
      for (int32_t row = 0; row < kBlockSize; ++row) {
        rows.write_all(row * kBlockSize, block.y + row);
      }
    }
  }

  // The samples of as many pixels as there are lanes lie in kSamples vectors side by side.
  template <uint32_t kSamples>
  [[gnu::always_inline]] void shade_sampled_rows(const SampledBlock& block,
                                                 const TileAttachments::Block& values) const {
    SampleRows landed = sample_rows(block, draw.input.state.sample_mask);
    if (draw.depth.is_usual()) {
      test_samples<kSamples, true>(block, values.depths, landed);
    } else if (draw.depth.tests()) {
      test_samples<kSamples, false>(block, values.depths, landed);
    }
    for (uint32_t column = 0; column < kBlockSize; column += L::kWidth) {
      const ColorRows<L, P> colors(*this, block.x + static_cast<int32_t>(column),
                                   values.colors + size_t{column} * kSamples);
      for (int32_t row = 0; row < kBlockSize; ++row) {
        constexpr uint32_t kAllSamples = ~0U >> (32 - L::kWidth * kSamples);
        const uint32_t bits = landed[static_cast<size_t>(row)] >> (column * kSamples) & kAllSamples;
        const int32_t offset = row * kBlockSize * static_cast<int32_t>(kSamples);
        if (bits == kAllSamples) {
          colors.template write_samples<kSamples, true>(offset, block.y + row, bits);
        } else if (bits != 0) {
          colors.template write_samples<kSamples, false>(offset, block.y + row, bits);
        }
      }
    }
  }

  // Leaves those of a block's samples that pass the depth test, which is done.
  template <uint32_t kSamples, bool kIsUsual>
  [[gnu::always_inline]] void test_samples(const SampledBlock& block, float* depths, SampleRows& samples) const {
    constexpr uint32_t kVectors = kBlockSize * kSamples / L::kWidth;
    const WindowPlane depth = interpolation.depth_framebuffer;
    std::array<typename L::Double, kVectors> columns;
    for (uint32_t vector = 0; vector < kVectors; ++vector) {
      const auto xs = L::all(static_cast<double>(block.x - interpolation.anchor_x)) +
                      L::load(draw.sample_offsets_x.data() + size_t{vector} * L::kWidth);
      columns[vector] = L::all(depth.at_anchor) + L::all(depth.step_x) * xs;
    }
    const auto offsets_y = L::load(draw.sample_offsets_y.data());
    for (uint32_t row = 0; row < kBlockSize; ++row) {
      if (samples[row] == 0) {
        continue;
      }
      const auto ys =
          L::all(static_cast<double>(block.y + static_cast<int32_t>(row) - interpolation.anchor_y)) + offsets_y;
      const auto depth_row = L::all(depth.step_y) * ys;
      float* const row_depths = depths + size_t{row} * kBlockSize * kSamples;
      samples[row] = samples[row] == ~0U ? test_row<kIsUsual, true>(columns, depth_row, row_depths, ~0U)
                                         : test_row<kIsUsual, false>(columns, depth_row, row_depths, samples[row]);
    }
  }

  // The same of a row of samples: `columns` and `row` are what the depth is the sum of.
  template <bool kIsUsual, bool kIsFull, size_t kVectors>
  [[gnu::always_inline]] uint32_t test_row(const std::array<typename L::Double, kVectors>& columns,
                                           const typename L::Double& row, float* depths, uint32_t bits) const {
    uint32_t landed = 0;
    for (uint32_t vector = 0; vector < kVectors; ++vector) {
      const uint32_t first = vector * L::kWidth;
      const typename L::Mask values = L::mask_of(kIsFull ? kAllLanes : bits >> first);
      landed |= test_depths<kIsUsual>(columns[vector] + row, values, depths + first) << first;
    }
    return landed;
  }

  [[nodiscard]] WindowOffset location(uint32_t sample) const { return draw.sample_locations[sample].from_centre(); }

  [[nodiscard]] bool lands(int32_t x, int32_t y, uint32_t sample, float& stored) const {
    return !draw.depth.tests() || draw.depth.lands(interpolation.depth_at(x, y, location(sample)), true, stored);
  }

  // The block's pixel number `bit`.
  void shade_pixel(const SampledBlock& block, uint32_t bit, const TileAttachments::Block& values) const {
    const int32_t x = block.x + static_cast<int32_t>(bit) % kBlockSize;
    const int32_t y = block.y + static_cast<int32_t>(bit) / kBlockSize;
    const size_t first = size_t{bit} * draw.input.samples;
    const uint32_t covered = block.samples_at(bit);
    uint32_t landed = 0;
    for (uint32_t rest = covered & draw.input.state.sample_mask; rest != 0; rest &= rest - 1) {
      const auto sample = static_cast<uint32_t>(std::countr_zero(rest));
      landed |= static_cast<uint32_t>(lands(x, y, sample, values.depths[first + sample])) << sample;
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
      emit_fragment(fragment, values.colors + first);
      return;
    }
    for (uint32_t rest = landed; rest != 0; rest &= rest - 1) {
      const auto sample = static_cast<uint32_t>(std::countr_zero(rest));
      fragment.samples = 1U << sample;
      fragment.position = location(sample);
      emit_fragment(fragment, values.colors + first);
    }
  }

  void emit_fragment(const Fragment& fragment, [[maybe_unused]] uint32_t* colors) const {
    if constexpr (ColorProgram<P>) {
      const auto packed = static_cast<uint32_t>(packed_color<ScalarLanes>(
          program, data, reciprocal_w, static_cast<float>(fragment.x - primitive.anchor_x + fragment.position.x),
          static_cast<float>(fragment.y - primitive.anchor_y + fragment.position.y)));
      for (uint32_t rest = fragment.samples; rest != 0; rest &= rest - 1) {
        colors[std::countr_zero(rest)] = packed;
      }
    } else {
      program.fragment(data, fragment);
    }
  }
};

inline void cover(const PreparedDraw& draw, std::span<const FixedPosition> outline, const PixelRect& rect,
                  TileCoverage& coverage) {
  renderer::cover(draw.coverage_rule, outline, draw.samples().front().sample_fixed, rect, coverage);
}

inline void cover(const PreparedDraw& draw, std::span<const FixedPosition> outline, const PixelRect& rect,
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
[[gnu::always_inline]] inline void prefetch(const P& program, const std::vector<ClipPosition>& positions_clip,
                                            const TileEntries& entries) {
  constexpr size_t kFar = 48;
  constexpr size_t kNear = 24;  // has arrived since it was far
  if (const SetupPrimitive* const far = entries.ahead(kFar)) {
    __builtin_prefetch(far);
    __builtin_prefetch(&far->front_facing);  // its end, which may be in another line of the cache
  }
  if (const SetupPrimitive* const near = entries.ahead(kNear)) {
    for (const uint32_t vertex : near->indices) {
      __builtin_prefetch(&positions_clip[vertex]);
      if constexpr (requires { program.prefetch(vertex); }) {
        program.prefetch(vertex);
      }
    }
  }
}

// Primitives that were covered and wait for their shading: whether the next one covers anything is then known before
// it is asked, not guessed wrong half of the time.
template <typename L, typename Coverage, Program P>
class ShadingQueue {
 public:
  [[gnu::always_inline]] ShadingQueue(const PreparedDraw& draw, const P& program,
                                      const std::vector<ClipPosition>& positions_clip, const PixelRect& tile_pixels,
                                      TileAttachments& attachments)
      : draw_(draw),
        program_(program),
        positions_clip_(positions_clip),
        tile_pixels_(tile_pixels),
        attachments_(attachments) {}

  [[gnu::always_inline]] void add(const SetupPrimitive& primitive,
                                  const std::vector<FixedPosition>& polygon_vertices) {
    const PixelRect rect = intersection(primitive.bounds(), tile_pixels_);
    if (rect.empty()) {
      return;
    }
    const std::span<const FixedPosition> outline = primitive.outline(polygon_vertices);
    Entry& entry = entries_[count_];
    entry.primitive = &primitive;
    entry.outline = outline;
    entry.first_block = coverage_.count;
    const bool is_triangle = primitive.polygon_count == 0 && draw_.coverage_rule.fill == Fill::kEdgeFunction;
    if (!is_triangle || !cover_narrow<L>(primitive.vertices, draw_.samples(), draw_.subpixel_bits, rect,
                                         draw_.setup.clip_pixels, coverage_)) {
      cover(draw_, outline, rect, coverage_);
    }
    count_ += coverage_.count != entry.first_block ? 1 : 0;
    if (count_ == kMaxEntries || coverage_.count > kMaxBlocks) {
      shade();
    }
  }

  // Whatever waits: first the planes of all of them, whose long chains of operations then overlap.
  [[gnu::always_inline]] void shade() {
    for (uint32_t i = 0; i < count_; ++i) {
      set_up(entries_[i]);
    }
    for (uint32_t i = 0; i < count_; ++i) {
      shade(entries_[i], i + 1 < count_ ? entries_[i + 1].first_block : coverage_.count);
    }
    count_ = 0;
    coverage_.count = 0;
  }

 private:
  static constexpr uint32_t kMaxEntries = 16;
  static_assert(std::tuple_size_v<decltype(Coverage::blocks)> == 2 * kMaxBlocks, "room for one primitive more");

  struct Entry {
    const SetupPrimitive* primitive = nullptr;
    std::span<const FixedPosition> outline;
    uint32_t first_block = 0;
    PrimitiveInterpolation interpolation;
    ShadedPrimitive shaded;
    typename P::PrimitiveData data;
    VaryingPlane reciprocal_w;
  };

  [[gnu::always_inline]] void set_up(Entry& entry) const {
    entry.interpolation = make_interpolation(draw_, *entry.primitive, positions_clip_, entry.outline);
    entry.shaded = {.primitive = entry.primitive->primitive,
                    .vertices = entry.primitive->indices,
                    .front_facing = entry.primitive->front_facing,
                    .interpolation = &entry.interpolation};
    set_anchor(tile_pixels_, entry.shaded);
    entry.data = program_.primitive_data(entry.shaded);
    entry.reciprocal_w = reciprocal_w_plane(entry.interpolation, entry.shaded.anchor_x, entry.shaded.anchor_y);
  }

  [[gnu::always_inline]] void shade(const Entry& entry, uint32_t end_block) const {
    const Shader<L, P> shader{
        draw_, program_, entry.data, entry.shaded, entry.interpolation, entry.reciprocal_w, attachments_};
    for (uint32_t block = entry.first_block; block < end_block; ++block) {
      shader.shade(coverage_.blocks[block]);
    }
  }

  const PreparedDraw& draw_;
  const P& program_;
  const std::vector<ClipPosition>& positions_clip_;
  PixelRect tile_pixels_;
  TileAttachments& attachments_;
  std::array<Entry, kMaxEntries + 1> entries_;
  uint32_t count_ = 0;
  Coverage coverage_;
};

// Coverage is TileCoverage for draws of one sample a pixel, which are much the faster for it, and else
// SampledTileCoverage.
template <typename L, typename Coverage, Program P>
[[gnu::always_inline]] inline void shade_tile(const PreparedDraw& draw, const P& program,
                                              const std::vector<ClipPosition>& positions_clip,
                                              const PixelRect& tile_pixels, uint32_t tile,
                                              std::span<const PrimitiveChunk> chunks) {
  static thread_local TileAttachments::Storage storage;
  TileAttachments attachments(draw, tile_pixels, storage);
  ShadingQueue<L, Coverage, P> queue(draw, program, positions_clip, tile_pixels, attachments);
  for (const PrimitiveChunk& chunk : chunks) {
    TileEntries entries = chunk.entries(tile);
    while (const SetupPrimitive* const primitive = entries.next()) {
      prefetch(program, positions_clip, entries);
      queue.add(*primitive, chunk.polygon_vertices());
    }
  }
  queue.shade();
  attachments.store();
}

}  // namespace fillrule::renderer::internal
