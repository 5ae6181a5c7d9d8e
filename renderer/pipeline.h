// The rasterization pipeline: one draw of triangles from vertices to fragments (Vulkan, "Fixed-Function Vertex
// Post-Processing" and "Rasterization").
//
// A *program* supplies the positions and receives the fragments. It is a template parameter, so that its fragment
// code is inlined into the loop over pixels. Fragments of one pixel arrive in the order of submission, and always
// from the same thread within a draw; different pixels arrive from different threads.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "renderer/coverage.h"
#include "renderer/depth.h"
#include "renderer/interpolation.h"
#include "renderer/primitive_assembly.h"
#include "renderer/tile_bins.h"
#include "renderer/triangle_setup.h"
#include "renderer/worker_pool.h"

namespace fillrule::renderer {

struct Options {
  uint32_t subpixel_bits = kMaxSubpixelBits;  // kMinSubpixelBits to kMaxSubpixelBits
  uint32_t threads = 1;                       // any number gives the same bytes
};

// What a draw needs besides its program. Fixed-function state is Vulkan's.
struct DrawInput {
  uint32_t target_width = 0;  // pixels
  uint32_t target_height = 0;
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  RasterState state;
  uint32_t vertex_count = 0;
  Indices indices;  // absent: vertices are used in their order
  DepthBuffer depth;
};

// A triangle about to be shaded.
struct ShadedTriangle {
  uint32_t primitive = 0;              // within the draw; culled, clipped and degenerate ones are counted
  std::array<uint32_t, 3> vertices{};  // the provoking one first; the weights' order
  bool front_facing = false;
};

// A fragment that passed the depth test. Framebuffer coordinates of its pixel; its centre is at x + 0.5, y + 0.5.
struct Fragment {
  int32_t x = 0;
  int32_t y = 0;
  float depth_framebuffer = 0;
  const TriangleInterpolation& interpolation;

  [[nodiscard]] PixelWeights weights() const { return interpolation.weights_at(x, y); }
};

template <typename P>
concept Program = requires(const P& program, uint32_t vertex, const ShadedTriangle& triangle,
                           const typename P::TriangleData& data, const Fragment& fragment) {
  // The vertex program: the position in clip space. Called once for each vertex.
  { program.position(vertex) } -> std::convertible_to<ClipPosition>;
  // What the fragments of a triangle share. Called once for each triangle and tile.
  { program.triangle_data(triangle) } -> std::same_as<typename P::TriangleData>;
  // The fragment program: writes wherever it likes for this pixel.
  program.fragment(data, fragment);
};

// Everything of a draw that does not depend on the program.
struct PreparedDraw {
  DrawInput input;
  uint32_t subpixel_bits;
  uint32_t primitive_count;
  PixelRect viewport_pixels;
  SetupState setup;
};

// Refuses what the pipeline cannot draw: a state outside of Vulkan's limits, an index without a vertex, a topology of
// lines or points.
Result<PreparedDraw> prepare_draw(const DrawInput& input, const Options& options);

// Sets up the triangles [first, end) and sorts them into tiles.
void build_chunk(const PreparedDraw& draw, const TileGrid& grid, const std::vector<ClipPosition>& positions_clip,
                 const std::vector<WindowVertex>& window_vertices, uint32_t first, uint32_t end,
                 TriangleChunk& chunk);

// The plane equations of a triangle that was set up.
TriangleInterpolation make_interpolation(const PreparedDraw& draw, const std::array<uint32_t, 3>& vertices,
                                         const std::vector<ClipPosition>& positions_clip,
                                         std::span<const FixedPosition> outline);

namespace internal {

// Depth test, depth write and fragment program for the pixels of a block.
template <Program P>
void shade_block(const PreparedDraw& draw, const P& program, const typename P::TriangleData& data,
                 const TriangleInterpolation& interpolation, const CoverageBlock& block) {
  const RasterState& state = draw.input.state;
  const std::span<float> depth_values = draw.input.depth.values;
  const size_t row_pixels = draw.input.target_width;
  for (uint64_t mask = block.mask; mask != 0; mask &= mask - 1) {
    const int32_t bit = std::countr_zero(mask);
    const int32_t x = block.x + bit % kBlockSize;
    const int32_t y = block.y + bit / kBlockSize;
    const float depth_framebuffer = interpolation.depth_d32_at(x, y);
    if (state.depth_test) {
      float& stored = depth_values[static_cast<size_t>(y) * row_pixels + static_cast<size_t>(x)];
      if (!depth_passes(state.depth_compare, depth_framebuffer, stored)) {
        continue;
      }
      if (state.depth_write) {
        stored = depth_framebuffer;
      }
    }
    program.fragment(data, Fragment{x, y, depth_framebuffer, interpolation});
  }
}

template <Program P>
void shade_tile(const PreparedDraw& draw, const P& program, const std::vector<ClipPosition>& positions_clip,
                const PixelRect& tile_pixels, uint32_t tile, std::span<const TriangleChunk> chunks) {
  TileCoverage coverage;
  for (const TriangleChunk& chunk : chunks) {
    chunk.for_each_in_tile(tile, [&](const SetupTriangle& triangle) {
      const PixelRect rect = intersection(triangle.bounds(), tile_pixels);
      if (rect.empty()) {
        return;
      }
      const std::span<const FixedPosition> outline = triangle.outline(chunk.polygon_vertices());
      cover(outline, draw.subpixel_bits, rect, coverage);
      if (coverage.count == 0) {
        return;
      }
      const std::array<uint32_t, 3> vertices =
          triangle_vertices(draw.input.topology, draw.input.indices, triangle.primitive);
      const TriangleInterpolation interpolation = make_interpolation(draw, vertices, positions_clip, outline);
      const typename P::TriangleData data = program.triangle_data(
          {.primitive = triangle.primitive, .vertices = vertices, .front_facing = triangle.front_facing});
      for (uint32_t i = 0; i < coverage.count; ++i) {
        shade_block(draw, program, data, interpolation, coverage.blocks[i]);
      }
    });
  }
}

}  // namespace internal

// Draws. The order of submission holds for any number of threads, and the result is the same to the byte.
template <Program P>
Result<void> draw(const DrawInput& input, const P& program, const Options& options) {
  const Result<PreparedDraw> prepared = prepare_draw(input, options);
  if (!prepared) {
    return tl::unexpected(prepared.error());
  }
  if (prepared->setup.clip_pixels.empty() || prepared->primitive_count == 0) {
    return {};
  }
  WorkerPool workers(options.threads);

  // Step 1: the vertices.
  constexpr uint32_t kVerticesAtOnce = 4096;
  constexpr size_t kCostOfVertex = 10;
  std::vector<ClipPosition> positions_clip(input.vertex_count);
  std::vector<WindowVertex> window_vertices(input.vertex_count);
  const size_t vertex_runs = (size_t{input.vertex_count} + kVerticesAtOnce - 1) / kVerticesAtOnce;
  workers.parallel_for(vertex_runs, kCostOfVertex * input.vertex_count, [&](size_t run) {
    const size_t end = std::min<size_t>((run + 1) * kVerticesAtOnce, input.vertex_count);
    for (size_t vertex = run * kVerticesAtOnce; vertex < end; ++vertex) {
      positions_clip[vertex] = program.position(static_cast<uint32_t>(vertex));
      window_vertices[vertex] = prepared->setup.transform.window_vertex(positions_clip[vertex]);
    }
  });

  // Step 2: batches of triangles, so that bins need not hold all of them: setup in chunks, then tile by tile.
  constexpr uint32_t kTrianglesInChunk = 2048;
  constexpr uint32_t kChunksInBatch = 16;
  constexpr size_t kCostOfSetup = 30;
  const TileGrid grid(prepared->setup.clip_pixels);
  const uint32_t primitives = prepared->primitive_count;
  const uint32_t all_chunks = (primitives - 1) / kTrianglesInChunk + 1;
  std::vector<TriangleChunk> chunks(std::min(all_chunks, kChunksInBatch));
  for (uint32_t first_chunk = 0; first_chunk < all_chunks; first_chunk += kChunksInBatch) {
    const uint32_t batch_chunks = std::min(kChunksInBatch, all_chunks - first_chunk);
    workers.parallel_for(batch_chunks, kCostOfSetup * kTrianglesInChunk * batch_chunks, [&](size_t chunk) {
      const uint32_t first = (first_chunk + static_cast<uint32_t>(chunk)) * kTrianglesInChunk;
      const uint32_t end = first + std::min(kTrianglesInChunk, primitives - first);
      build_chunk(*prepared, grid, positions_clip, window_vertices, first, end, chunks[chunk]);
    });
    const std::span<const TriangleChunk> batch(chunks.data(), batch_chunks);
    size_t cost = 0;
    for (const TriangleChunk& chunk : batch) {
      cost += chunk.cost();
    }
    workers.parallel_for(grid.count(), cost, [&](size_t tile) {
      const auto index = static_cast<uint32_t>(tile);
      internal::shade_tile(*prepared, program, positions_clip, grid.pixels(index), index, batch);
    });
  }
  return {};
}

}  // namespace fillrule::renderer
