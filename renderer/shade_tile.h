// One tile: the primitives that touch it, in the order of submission, from coverage to the attachments.
//
// Small triangles are covered and shaded in runs of a row (row_spans.h), all else in blocks of 8x8 pixels, which lie
// on multiples of 8 pixels, so that none reaches into another tile.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "renderer/big_array.h"
#include "renderer/block_shader.h"
#include "renderer/edge_fill.h"
#include "renderer/row_spans.h"
#include "renderer/run_shader.h"
#include "renderer/shading.h"
#include "renderer/tile_attachments.h"
#include "renderer/tiny_shader.h"
#include "renderer/triangle_buffer.h"
#include "renderer/uncleared.h"

namespace fillrule::renderer::internal {

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

// Asks for what the primitives after entry i will need: those of a tile are far apart in memory.
template <Program P>
[[gnu::always_inline]] inline void prefetch(const P& program, std::span<const ClipPosition> positions_clip,
                                            std::span<const TileEntry> entries, size_t i) {
  constexpr size_t kFar = 12;
  constexpr size_t kNear = 6;  // has arrived since it was far
  if (i + kFar < entries.size()) {
    const SetupPrimitive* const far = entries[i + kFar].primitive;
    __builtin_prefetch(far);
    __builtin_prefetch(&far->front_facing);  // its end, which may be in another line of the cache
  }
  if (i + kNear < entries.size()) {
    for (const uint32_t vertex : entries[i + kNear].primitive->indices) {
      __builtin_prefetch(&positions_clip[vertex]);
      if constexpr (requires { program.prefetch(vertex); }) {
        program.prefetch(vertex);
      }
    }
  }
}

// A block of which all samples are covered, wherever it is put.
template <typename Coverage>
[[gnu::always_inline]] inline auto whole_block(size_t samples) {
  if constexpr (std::is_same_v<Coverage, TileCoverage>) {
    return CoverageBlock{.x = 0, .y = 0, .mask = kFullMask};
  } else {
    SampledBlock block;
    block.any = kFullMask;
    std::fill_n(block.masks.begin(), samples, kFullMask);
    return block;
  }
}

// Primitives that were covered and wait for their shading: whether the next one covers anything is then known before
// it is asked, not guessed wrong half of the time.
template <typename L, typename Coverage, Program P>
class ShadingQueue {
 public:
  [[gnu::always_inline]] ShadingQueue(const PreparedDraw& draw, const P& program,
                                      std::span<const ClipPosition> positions_clip, const PixelRect& tile_pixels,
                                      TileAttachments& attachments)
      : draw_(draw),
        program_(program),
        positions_clip_(positions_clip),
        tile_pixels_(tile_pixels),
        attachments_(attachments),
        has_lane_planes_(L::kWidth > 1 && draw.shape == Shape::kPolygon && !draw.input.state.depth_bias) {
    runs_.tile_left = tile_pixels.left;
    runs_.tile_top = tile_pixels.top;
  }

  // Whether the queue is full then, and must be shaded before the next primitive.
  [[nodiscard, gnu::always_inline]] bool add(const SetupPrimitive& primitive,
                                             const std::vector<FixedPosition>& polygon_vertices) {
    const PixelRect rect = intersection(primitive.bounds(), tile_pixels_);
    if (rect.empty()) {
      return false;
    }
    const std::span<const FixedPosition> outline = primitive.outline(polygon_vertices);
    if (attachments_.has_depth_limit(rect) && is_hidden(primitive, outline, rect)) {
      return false;
    }
    Entry& entry = entries_[count_];
    entry.primitive = &primitive;
    entry.outline = outline;
    entry.first_block = coverage_.count;
    entry.first_run = runs_.count;
    entry.covered = 0;
    entry.is_whole_tile = false;
    if (kHasTiny && has_lane_planes_ && primitive.covered_pixels() != 0) {
      attachments_.load(rect);
      entry.covered = covered_within(primitive, rect);
      count_ += entry.covered != 0 ? 1 : 0;
      return count_ == kMaxEntries;
    }
    cover_outline(primitive, outline, rect, entry);
    count_ += entry.is_whole_tile || coverage_.count != entry.first_block || runs_.count != entry.first_run ? 1 : 0;
    return count_ == kMaxEntries || coverage_.count > kMaxBlocks || !runs_.has_room();
  }

  // Whatever waits: first the planes of all of them, whose long chains of operations then overlap.
  [[gnu::always_inline]] void shade() {
    entries_[count_].first_block = coverage_.count;
    entries_[count_].first_run = runs_.count;
    entries_[count_].covered = 0;
    for (uint32_t first = 0; first < count_;) {
      LaneTriangleBuffer<L> triangles;
      const uint32_t end = has_lane_planes_ ? make_triangle_interpolations(first, triangles) : make_interpolations();
      for (uint32_t i = first; i < end; ++i) {
        if (!stays_in_lanes(i)) {
          set_up(*entries_[i].primitive, primitives_[i]);
        }
      }
      while (first < end) {
        first = is_tiny(first)    ? shade_tiny(first, triangles)
                : has_runs(first) ? shade_runs(first, end, triangles)
                                  : shade_blocks(first, end);
      }
    }
    count_ = 0;
    coverage_.count = 0;
    runs_.count = 0;
  }

 private:
  static constexpr uint32_t kMaxEntries = 16;
  static_assert(std::tuple_size_v<decltype(Coverage::blocks)> == 2 * kMaxBlocks, "room for one primitive more");

  struct Entry {
    const SetupPrimitive* primitive = nullptr;
    std::span<const FixedPosition> outline;
    uint32_t first_block = 0;
    uint32_t first_run = 0;
    bool is_whole_tile = false;  // it covers all of the tile's samples, and has no blocks
    uint32_t covered = 0;        // of a tiny triangle the pixels within the tile, as SetupPrimitive::covered_pixels()
  };

  // Whether nothing of it can land, so that it need not even be covered. Of what is visible the planes are made
  // again: there are limits only where much is hidden.
  [[nodiscard, gnu::noinline]] bool is_hidden(const SetupPrimitive& primitive, std::span<const FixedPosition> outline,
                                              const PixelRect& rect) const {
    const PrimitiveInterpolation planes = make_interpolation(draw_, primitive, positions_clip_, outline);
    return draw_.depth.hides(least_depth(draw_, planes, rect), attachments_.depth_limit(rect));
  }

  // All of them; returns their end.
  uint32_t make_interpolations() {
    for (uint32_t i = 0; i < count_; ++i) {
      const Entry& entry = entries_[i];
      primitives_[i].interpolation = make_interpolation(draw_, *entry.primitive, positions_clip_, entry.outline);
    }
    return count_;
  }

  // The same of triangles without a bias from `first` on, as many at once as there are lanes, until there are some
  // that stay in their lanes: entry i in lane i % L::kWidth.
  [[nodiscard, gnu::always_inline]] uint32_t make_triangle_interpolations(uint32_t first,
                                                                          LaneTriangleBuffer<L>& triangles) {
    bool some_stay = false;
    for (; first < count_ && !some_stay; first += L::kWidth) {
      for (uint32_t lane = 0; lane < L::kWidth; ++lane) {
        const Entry& entry = entries_[std::min(first + lane, count_ - 1)];  // beyond the last, the last again
        triangles.put(lane, *entry.primitive, entry.outline, positions_clip_);
      }
      triangles.compute(draw_);
      for (uint32_t i = first; i < std::min(first + L::kWidth, count_); ++i) {
        if (stays_in_lanes(i)) {
          some_stay = true;
        } else {
          triangles.get(i % L::kWidth, primitives_[i].interpolation);
        }
      }
    }
    return std::min(first, count_);
  }

  [[gnu::always_inline]] void set_up(const SetupPrimitive& setup, TilePrimitive<P>& primitive) const {
    primitive.shaded = {.primitive = setup.primitive,
                        .vertices = setup.indices,
                        .front_facing = setup.front_facing,
                        .interpolation = &primitive.interpolation};
    set_anchor(tile_pixels_, primitive.shaded);
    primitive.data = program_.primitive_data(primitive.shaded);
    primitive.reciprocal_w =
        reciprocal_w_plane(primitive.interpolation, primitive.shaded.anchor_x, primitive.shaded.anchor_y);
  }

  static constexpr uint32_t kSamples = std::is_same_v<Coverage, TileCoverage> ? 1 : 4;  // of a run's pixels
  static constexpr bool kHasRuns = L::kWidth > 1;
  static_assert(!kHasRuns || L::kWidth >= kSamples);
  static constexpr bool kHasLanePlanes = kHasRuns && LaneProgram<P>;
  static constexpr bool kHasTiny = kHasLanePlanes && kSamples == 1;

  [[gnu::always_inline]] void cover_outline(const SetupPrimitive& primitive, std::span<const FixedPosition> outline,
                                            const PixelRect& rect, Entry& entry) {
    if (primitive.polygon_count == 0 && draw_.coverage_rule.fill == Fill::kEdgeFunction) {
      if constexpr (kHasRuns) {
        if (primitive.covered_pixels() != 0) {
          attachments_.load(rect);
          runs_.primitive = number_of(count_);
          add_covered(primitive, rect, runs_);
          return;
        }
        if (intersection(rect, draw_.span_pixels) == rect && is_small(primitive.vertices, rect)) {
          attachments_.load(rect);
          runs_.primitive = number_of(count_);
          cover_small<L, kSamples>(primitive.vertices, draw_.span_samples, draw_.subpixel_bits, rect, runs_);
          return;
        }
      }
      const NarrowCover cover = cover_narrow<L>(primitive.vertices, draw_.samples(), draw_.subpixel_bits, rect,
                                                draw_.setup.clip_pixels, coverage_);
      entry.is_whole_tile = cover == NarrowCover::kWholeTile;
      if (cover != NarrowCover::kNotNarrow) {
        return;
      }
    }
    cover(draw_, outline, rect, coverage_);
  }

  [[nodiscard, gnu::always_inline]] bool has_runs(uint32_t entry) const {
    return entries_[entry].first_run != entries_[entry + 1].first_run;
  }

  [[nodiscard, gnu::always_inline]] bool is_tiny(uint32_t entry) const {
    return kHasTiny && entries_[entry].covered != 0;
  }

  // Whether what its fragments need is used lane by lane.
  [[nodiscard, gnu::always_inline]] bool stays_in_lanes(uint32_t entry) const {
    return kHasLanePlanes && has_lane_planes_ && (is_tiny(entry) || has_runs(entry));
  }
  // What its runs know it by.
  [[nodiscard, gnu::always_inline]] uint32_t number_of(uint32_t entry) const {
    return kHasLanePlanes && has_lane_planes_ ? entry % L::kWidth : entry;
  }

  // Each shades some entries from this one on and returns their end.

  // Tiny triangles that are in the same lanes.
  [[nodiscard, gnu::always_inline]] uint32_t shade_tiny(uint32_t entry,
                                                        const LaneTriangleBuffer<L>& triangles) const {
    if constexpr (kHasTiny) {
      TinyShader<L, P> shader(draw_, program_, triangles, attachments_.template pixels<1>());
      do {
        const SetupPrimitive& primitive = *entries_[entry].primitive;
        shader.add(entry % L::kWidth, primitive.left, primitive.top, entries_[entry].covered);
        ++entry;
      } while (is_tiny(entry) && entry % L::kWidth != 0);
      shader.shade();
    }
    return entry;
  }

  // All that come one after the other, up to this end at most.
  [[nodiscard, gnu::always_inline]] uint32_t shade_runs(uint32_t first, uint32_t end,
                                                        const LaneTriangleBuffer<L>& triangles) {
    uint32_t entry = first + 1;
    while (entry < end && has_runs(entry)) {
      ++entry;
    }
    if constexpr (kHasLanePlanes) {
      if (has_lane_planes_) {
        shade_runs(PlanesInLanes<L, P>(program_, triangles, tile_pixels_), first, entry);
        return entry;
      }
    }
    if constexpr (kHasRuns) {
      shade_runs(PlanesOfPrimitives<P>{program_, primitives_.span(), tile_pixels_}, first, entry);
    }
    return entry;
  }
  template <typename Planes>
  [[gnu::always_inline]] void shade_runs(const Planes& planes, uint32_t first, uint32_t end) {
    RunShader<L, P, kSamples, Planes>{draw_, program_, planes, attachments_, tile_pixels_}.shade(
        runs_, entries_[first].first_run, entries_[end].first_run);
  }

  // All that cover the whole tile and come one after the other, or one that does not. The former block by block: a
  // block's samples then stay in the nearest cache.
  [[nodiscard, gnu::always_inline]] uint32_t shade_blocks(uint32_t first, uint32_t end) const {
    const bool is_whole_tile = entries_[first].is_whole_tile;
    uint32_t entry = first + 1;
    while (is_whole_tile && entry < end && entries_[entry].is_whole_tile) {
      ++entry;
    }
    auto whole = whole_block<Coverage>(draw_.samples().size());
    const uint32_t first_block = entries_[first].first_block;
    const uint32_t blocks = is_whole_tile ? kMaxBlocks : entries_[entry].first_block - first_block;
    for (uint32_t i = 0; i < blocks; ++i) {
      constexpr int32_t kBlocksInRow = kTileSize / kBlockSize;
      whole.x = tile_pixels_.left + static_cast<int32_t>(i) % kBlocksInRow * kBlockSize;
      whole.y = tile_pixels_.top + static_cast<int32_t>(i) / kBlocksInRow * kBlockSize;
      const auto& block = is_whole_tile ? whole : coverage_.blocks[first_block + i];
      for (uint32_t k = first; k < entry; ++k) {
        const PrimitiveShader<P> shader{draw_, program_, primitives_[k]};
        BlockShader<L, P>{shader, attachments_}.shade(block);
      }
    }
    return entry;
  }

  const PreparedDraw& draw_;
  const P& program_;
  std::span<const ClipPosition> positions_clip_;
  PixelRect tile_pixels_;
  TileAttachments& attachments_;
  bool has_lane_planes_;
  std::array<Entry, kMaxEntries + 1> entries_;  // the last is where those before it end
  Uncleared<TilePrimitive<P>, kMaxEntries> primitives_;
  uint32_t count_ = 0;
  Coverage coverage_;
  RunList runs_;
};

// Coverage is TileCoverage for draws of one sample a pixel, which are much the faster for it, and else
// SampledTileCoverage. is_first: these are the first chunks of the draw.
template <typename L, typename Coverage, Program P>
[[gnu::always_inline]] inline void shade_tile(const PreparedDraw& draw, const P& program,
                                              std::span<const ClipPosition> positions_clip,
                                              const PixelRect& tile_pixels, uint32_t tile,
                                              std::span<const PrimitiveChunk> chunks, bool is_first) {
  static thread_local TileAttachments::Storage storage;
  static thread_local BigArray<TileEntry> entry_memory;
  // A tile's bins are far apart, one in each chunk, and another thread may have made them.
  for (const PrimitiveChunk& chunk : chunks) {
    chunk.prefetch_bin(tile);
  }
  size_t count = 0;
  for (const PrimitiveChunk& chunk : chunks) {
    count += chunk.entry_count(tile);
  }
  const std::span<TileEntry> entries = entry_memory.room_for(count);
  TileEntry* next = entries.data();
  for (size_t i = 0; i < chunks.size(); ++i) {
    constexpr size_t kAhead = 8;
    if (i + kAhead < chunks.size()) {
      chunks[i + kAhead].prefetch_entries(tile);
    }
    next = chunks[i].write_entries(tile, next);
  }
  TileAttachments attachments(draw, tile_pixels, is_first, storage);
  ShadingQueue<L, Coverage, P> queue(draw, program, positions_clip, tile_pixels, attachments);
  for (size_t i = 0; i < entries.size(); ++i) {
    prefetch(program, positions_clip, entries, i);
    const bool is_full = queue.add(*entries[i].primitive, *entries[i].polygon_vertices);
    // In one place, since all of shading is expanded into it.
    if (is_full || i + 1 == entries.size()) {
      queue.shade();
    }
  }
  attachments.store();
}

}  // namespace fillrule::renderer::internal
