// The rasterization pipeline: one draw from vertices to fragments (Vulkan, "Fixed-Function Vertex
// Post-Processing" and "Rasterization").
//
// A *program* supplies the positions and receives the fragments. It is a template parameter, so that its fragment
// code is inlined into the loop over pixels. Fragments of one pixel arrive in the order of submission, and always
// from the same thread within a draw; different pixels arrive from different threads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "cases/model/result.h"
#include "renderer/prepared_draw.h"
#include "renderer/shade_tile.h"
#include "renderer/shading.h"
#include "renderer/tile_bins.h"
#include "renderer/worker_pool.h"

namespace fillrule::renderer {

// Sets up the primitives [first, end) and sorts them into tiles.
void build_chunk(const PreparedDraw& draw, const TileGrid& grid, const std::vector<ClipPosition>& positions_clip,
                 const std::vector<WindowVertex>& window_vertices, uint32_t first, uint32_t end,
                 PrimitiveChunk& chunk);

// Draws. The order of submission holds for any number of threads, and the result is the same to the byte.
template <Program P>
Result<void> draw(const DrawInput& input, const P& program, const Options& options) {
  const Result<PreparedDraw> prepared = prepare_draw(input, options);
  if (!prepared) {
    return tl::unexpected(prepared.error());
  }
  const bool has_samples = (input.state.sample_mask & ((1U << input.samples) - 1)) != 0;
  if (prepared->setup.clip_pixels.empty() || !has_samples || prepared->assembly.count() == 0) {
    return {};
  }
  WorkerPool workers(options.threads);

  // Step 1: the vertices.
  constexpr uint32_t kVerticesAtOnce = 4096;
  constexpr size_t kCostOfVertex = 10;
  std::vector<ClipPosition> positions_clip(input.vertices.vertex_count);
  std::vector<WindowVertex> window_vertices(input.vertices.vertex_count);
  const size_t vertex_runs = (size_t{input.vertices.vertex_count} + kVerticesAtOnce - 1) / kVerticesAtOnce;
  workers.parallel_for(vertex_runs, kCostOfVertex * input.vertices.vertex_count, [&](size_t run) {
    const size_t end = std::min<size_t>((run + 1) * kVerticesAtOnce, input.vertices.vertex_count);
    for (auto vertex = static_cast<uint32_t>(run * kVerticesAtOnce); vertex < end; ++vertex) {
      positions_clip[vertex] = program.position(vertex);
      window_vertices[vertex] = prepared->window_vertex(vertex, positions_clip[vertex]);
    }
  });

  // Step 2: batches of primitives, so that bins need not hold all of them: setup in chunks, then tile by tile.
  constexpr uint32_t kPrimitivesInChunk = 2048;
  constexpr uint32_t kChunksInBatch = 16;
  constexpr size_t kCostOfSetup = 30;
  const TileGrid grid(prepared->setup.clip_pixels);
  const uint32_t primitives = prepared->assembly.count();
  const uint32_t all_chunks = (primitives - 1) / kPrimitivesInChunk + 1;
  std::vector<PrimitiveChunk> chunks(std::min(all_chunks, kChunksInBatch));
  for (uint32_t first_chunk = 0; first_chunk < all_chunks; first_chunk += kChunksInBatch) {
    const uint32_t batch_chunks = std::min(kChunksInBatch, all_chunks - first_chunk);
    workers.parallel_for(batch_chunks, kCostOfSetup * kPrimitivesInChunk * batch_chunks, [&](size_t chunk) {
      const uint32_t first = (first_chunk + static_cast<uint32_t>(chunk)) * kPrimitivesInChunk;
      const uint32_t end = first + std::min(kPrimitivesInChunk, primitives - first);
      build_chunk(*prepared, grid, positions_clip, window_vertices, first, end, chunks[chunk]);
    });
    const std::span<const PrimitiveChunk> batch(chunks.data(), batch_chunks);
    size_t cost = 0;
    for (const PrimitiveChunk& chunk : batch) {
      cost += chunk.cost();
    }
    workers.parallel_for(grid.count(), cost, [&](size_t tile) {
      const auto index = static_cast<uint32_t>(tile);
      dispatch(
          prepared->isa, [&]<typename L>() __attribute__((always_inline)) {
            if (input.samples == 1) {
              internal::shade_tile<L, TileCoverage>(*prepared, program, positions_clip, grid.pixels(index), index,
                                                    batch);
            } else {
              internal::shade_tile<L, SampledTileCoverage>(*prepared, program, positions_clip, grid.pixels(index),
                                                           index, batch);
            }
          });
    });
  }
  return {};
}

}  // namespace fillrule::renderer
