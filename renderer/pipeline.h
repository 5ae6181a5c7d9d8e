// The rasterization pipeline: one draw from vertices to fragments (Vulkan, "Fixed-Function Vertex
// Post-Processing" and "Rasterization").
//
// A *program* supplies the positions and receives the fragments. It is a template parameter, so that its fragment
// code is inlined into the loop over pixels. Fragments of one pixel arrive in the order of submission, and always
// from the same thread within a draw; different pixels arrive from different threads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "cases/model/result.h"
#include "renderer/big_array.h"
#include "renderer/prepared_draw.h"
#include "renderer/shade_tile.h"
#include "renderer/shading.h"
#include "renderer/tile_bins.h"
#include "renderer/worker_pool.h"

namespace fillrule::renderer {

// Sets up the primitives [first, end) and sorts them into tiles.
void build_chunk(const PreparedDraw& draw, const TileGrid& grid, std::span<const ClipPosition> positions_clip,
                 std::span<const WindowVertex> window_vertices, uint32_t first, uint32_t end, PrimitiveChunk& chunk);

// So many primitives are set up in one go; the last chunk of a draw may have less.
inline constexpr uint32_t kPrimitivesInChunk = 2048;
// So many chunks go into the tiles together, fewer where primitives fall into parts. Those of the triangles of a fine
// grid cover a band of tiles for each of two threads.
inline constexpr uint32_t kChunksInBatch = 128;

struct ChunkRange {
  uint32_t first = 0;  // within the draw
  uint32_t count = 0;
};
inline constexpr uint32_t kNoChunk = ~0U;

// The chunks of the range, counted from its first, for threads that take every threads-th call (worker_pool.h): each
// gets those that lie in its bands of tiles, going by the primitive in the middle, and mostly draws what it has set
// up; to fetch that from another processor's cache may take longer than drawing it. kNoChunk where a thread has
// fewer.
std::vector<uint32_t> chunks_by_bands(const PreparedDraw& draw, const TileGrid& grid,
                                      std::span<const WindowVertex> window_vertices, const ChunkRange& chunks,
                                      uint32_t threads);

// Clears all of the target but these pixels, which may be none.
void clear_around(const DrawInput& input, const PixelRect& pixels);

namespace internal {

// Of a thread that draws.
struct DrawMemory {
  BigArray<ClipPosition> positions_clip;
  BigArray<WindowVertex> window_vertices;
  BigArray<SetupPrimitive> primitives;
};

}  // namespace internal

// Draws; a program must not. The order of submission holds for any number of threads, and the result is the same to
// the byte.
template <Program P>
Result<void> draw(const DrawInput& input, const P& program, const Options& options) {
  if (Result<void> checked = check_draw(input, options); !checked) {
    return checked;
  }
  const PreparedDraw prepared = prepare_draw(input, options);
  const bool has_samples = (input.state.sample_mask & ((1U << input.samples) - 1)) != 0;
  if (prepared.setup.clip_pixels.empty() || !has_samples || prepared.assembly.count() == 0) {
    clear_around(input, {});
    return {};
  }
  WorkerPool& workers = own_workers(options.threads);
  const WorkerPool::Awake awake(workers);

  // Step 1: the vertices.
  constexpr uint32_t kVerticesAtOnce = 1024;
  constexpr size_t kCostOfVertex = 10;
  static thread_local internal::DrawMemory memory;
  const std::span<ClipPosition> positions_clip = memory.positions_clip.room_for(input.vertices.vertex_count);
  const std::span<WindowVertex> window_vertices = memory.window_vertices.room_for(input.vertices.vertex_count);
  const size_t vertex_runs = (size_t{input.vertices.vertex_count} + kVerticesAtOnce - 1) / kVerticesAtOnce;
  workers.parallel_for(vertex_runs, kCostOfVertex * input.vertices.vertex_count, [&](size_t run) {
    const auto first = static_cast<uint32_t>(run * kVerticesAtOnce);
    const uint32_t end = first + std::min(kVerticesAtOnce, input.vertices.vertex_count - first);
    for (uint32_t vertex = first; vertex < end; ++vertex) {
      positions_clip[vertex] = program.position(vertex);
    }
    prepared.make_window_vertices(first, end, positions_clip, window_vertices);
  });

  // Step 2: batches of primitives, so that bins need not hold all of them: setup in chunks, then tile by tile.
  constexpr size_t kCostOfSetup = 30;
  const TileGrid grid(prepared.setup.clip_pixels);
  clear_around(input, grid.pixels());
  const uint32_t primitives = prepared.assembly.count();
  const uint32_t all_chunks = (primitives - 1) / kPrimitivesInChunk + 1;
  const size_t room_of_chunk = size_t{prepared.parts_of_primitive()} * std::min(primitives, kPrimitivesInChunk);
  const uint32_t chunks_at_once = std::min(all_chunks, kChunksInBatch / prepared.parts_of_primitive());
  const std::span<SetupPrimitive> room = memory.primitives.room_for(room_of_chunk * chunks_at_once);
  std::vector<PrimitiveChunk> chunks;
  chunks.reserve(chunks_at_once);
  for (uint32_t chunk = 0; chunk < chunks_at_once; ++chunk) {
    chunks.emplace_back(room.subspan(chunk * room_of_chunk, room_of_chunk));
  }
  for (uint32_t first_chunk = 0; first_chunk < all_chunks; first_chunk += chunks_at_once) {
    const uint32_t batch_chunks = std::min(chunks_at_once, all_chunks - first_chunk);
    const std::vector<uint32_t> calls =
        chunks_by_bands(prepared, grid, window_vertices, {first_chunk, batch_chunks}, workers.threads());
    workers.parallel_for(calls.size(), kCostOfSetup * kPrimitivesInChunk * batch_chunks, [&](size_t call) {
      const uint32_t chunk = calls[call];
      if (chunk == kNoChunk) {
        return;
      }
      const uint32_t first = (first_chunk + chunk) * kPrimitivesInChunk;
      const uint32_t end = first + std::min(kPrimitivesInChunk, primitives - first);
      build_chunk(prepared, grid, positions_clip, window_vertices, first, end, chunks[chunk]);
    });
    const std::span<const PrimitiveChunk> batch(chunks.data(), batch_chunks);
    size_t cost = first_chunk == 0 && input.clears() ? size_t{grid.count()} * kTileSize * kTileSize : 0;
    for (const PrimitiveChunk& chunk : batch) {
      cost += chunk.cost();
    }
    workers.parallel_for(grid.count(), cost, [&](size_t number) {
      const uint32_t index = grid.in_bands(static_cast<uint32_t>(number), workers.threads());
      const PixelRect pixels = grid.pixels(index);
      const bool is_first = first_chunk == 0;
      // A function for each kind of coverage: one for both would take longer to compile than the two.
      if (input.samples == 1) {
        dispatch(
            prepared.isa, [&]<typename L>() __attribute__((always_inline)) {
              internal::shade_tile<L, TileCoverage>(prepared, program, positions_clip, pixels, index, batch,
                                                    is_first);
            });
      } else {
        dispatch(
            prepared.isa, [&]<typename L>() __attribute__((always_inline)) {
              internal::shade_tile<L, SampledTileCoverage>(prepared, program, positions_clip, pixels, index, batch,
                                                           is_first);
            });
      }
    });
  }
  return {};
}

}  // namespace fillrule::renderer
