#include "renderer/pipeline.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "renderer/bresenham_line.h"
#include "renderer/depth_bias.h"
#include "renderer/line_point_setup.h"
#include "renderer/outlines.h"
#include "renderer/triangle_setup.h"

namespace fillrule::renderer {
namespace {

AssembledPrimitive assembled(const PreparedDraw& draw, uint32_t number, const std::array<uint32_t, 3>& vertices,
                             std::span<const ClipPosition> positions_clip,
                             const std::array<WindowVertex, 3>& window_vertices) {
  const auto& [a, b, c] = vertices;
  const VertexDistances& distances = draw.input.clip_distances;
  return {.number = number,
          .indices = vertices,
          .positions_clip = {positions_clip[a], positions_clip[b], positions_clip[c]},
          .window_vertices = window_vertices,
          .clip_distances = {distances.of(a), distances.of(b), distances.of(c)}};
}

// Sets up primitives into a chunk.
class ChunkBuilder {
 public:
  ChunkBuilder(const PreparedDraw& draw, std::span<const ClipPosition> positions_clip,
               std::span<const WindowVertex> window_vertices, PrimitiveChunk& chunk)
      : draw_(draw), positions_clip_(positions_clip), window_vertices_(window_vertices), chunk_(chunk) {}

  // The primitives [first, end).
  void add(uint32_t first, uint32_t end) const {
    dispatch(
        draw_.isa, [&]<typename L>() __attribute__((always_inline)) {
          if constexpr (L::kWidth > 1) {
            if (draw_.shape == Shape::kPolygon) {
              add_polygons<L>(first, end);
              return;
            }
          }
          for (uint32_t number = first; number < end; ++number) {
            add(number, draw_.assembly.vertices(number));
          }
        });
  }

 private:
  template <typename L>
  [[gnu::always_inline]] void add_polygons(uint32_t first, uint32_t end) const {
    constexpr uint32_t kAtOnce = internal::TriangleLanes<L>::kTriangles;
    for (; first < end; first += kAtOnce) {
      add_lanes<L>(first, std::min(kAtOnce, end - first));
    }
  }

  // Whole triangles by lanes, others one by one, all in their order.
  template <typename L>
  [[gnu::always_inline]] void add_lanes(uint32_t first, uint32_t count) const {
    using Lanes = internal::TriangleLanes<L>;
    Lanes lanes;
    std::array<std::array<uint32_t, 3>, Lanes::kTriangles> indices;
    draw_.assembly.vertices(first, std::span{indices}.first(count));
    uint64_t others = 0;
    for (uint32_t i = 0; i < count; ++i) {
      const auto& [a, b, c] = indices[i];
      lanes.put(i, window_vertices_[a].position, window_vertices_[b].position, window_vertices_[c].position);
      others |= uint64_t{!is_whole(indices[i])} << i;
    }
    lanes.set_up(draw_.setup, {draw_.has_tiny_coverage, draw_.samples().front().sample_fixed}, count);
    const uint64_t by_lanes = lanes.visible() & ~others;
    const uint64_t one_by_one = others | lanes.too_large();
    for (uint64_t rest = by_lanes | one_by_one; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<uint32_t>(std::countr_zero(rest));
      if ((by_lanes >> i & 1U) != 0) {
        lanes.get(i, append(first + i, indices[i]));
      } else {
        add(first + i, indices[i]);
      }
    }
  }

  void add(uint32_t number, const std::array<uint32_t, 3>& vertices) const {
    const auto& [a, b, c] = vertices;
    const AssembledPrimitive primitive = assembled(draw_, number, vertices, positions_clip_,
                                                   {window_vertices_[a], window_vertices_[b], window_vertices_[c]});
    if (draw_.shape == Shape::kPolygon) {
      add(setup_triangle(draw_.setup, primitive, chunk_.polygon_vertices()));
    } else if (is_polygon_topology(draw_.input.vertices.topology)) {
      add_edges_or_corners(primitive, vertices);
    } else if (!primitive.is_culled_by_distance()) {
      add_part(primitive, vertices, line_ends(draw_.input.state.provoking_vertex), true);
    }
  }

  // Neither clipped nor dropped for its distances.
  [[nodiscard]] bool is_whole(const std::array<uint32_t, 3>& vertices) const {
    const WindowVertex& a = window_vertices_[vertices[0]];
    const WindowVertex& b = window_vertices_[vertices[1]];
    const WindowVertex& c = window_vertices_[vertices[2]];
    return (a.clip_code | b.clip_code | c.clip_code) == 0 && (a.cull_code & b.cull_code & c.cull_code) == 0;
  }

  // A triangle that is not set up, where it is to stay: copies would be a good part of the work.
  [[nodiscard]] SetupPrimitive& append(uint32_t number, const std::array<uint32_t, 3>& vertices) const {
    SetupPrimitive& triangle = chunk_.append();
    for (size_t i = 0; i < 3; ++i) {
      triangle.vertices[i] = window_vertices_[vertices[i]].position;
      triangle.indices[i] = vertices[i];
    }
    triangle.primitive = number;
    return triangle;
  }

  void add(const std::optional<SetupPrimitive>& primitive) const {
    if (primitive) {
      chunk_.append() = *primitive;
    }
  }

  void add_edges_or_corners(const AssembledPrimitive& primitive, const std::array<uint32_t, 3>& vertices) const {
    const std::optional<VisiblePolygon> polygon = visible_polygon(draw_.setup, primitive);
    const std::optional<bool> front_facing = polygon ? facing(draw_.setup, *polygon) : std::nullopt;
    if (!front_facing) {
      return;
    }
    for (const LineEnds& ends : {LineEnds{0, 1}, LineEnds{1, 2}, LineEnds{2, 0}}) {
      add_part(primitive, vertices, ends, *front_facing);
    }
  }

  // A line, or the point at its beginning.
  void add_part(const AssembledPrimitive& primitive, const std::array<uint32_t, 3>& vertices, const LineEnds& ends,
                bool front_facing) const {
    std::optional<SetupPrimitive> part;
    if (draw_.shape == Shape::kLine) {
      part = setup_line(draw_.setup, primitive, ends, chunk_.polygon_vertices());
    } else {
      const float size = draw_.input.vertices.point_size(vertices[ends.from]);
      part = setup_point(draw_.setup, primitive, ends.from, size, chunk_.polygon_vertices());
    }
    if (part) {
      part->front_facing = front_facing;
      chunk_.append() = *part;
    }
  }

  const PreparedDraw& draw_;
  std::span<const ClipPosition> positions_clip_;
  std::span<const WindowVertex> window_vertices_;
  PrimitiveChunk& chunk_;
};

// The greatest |depth| of the part of a triangle that the near and far planes leave.
double greatest_depth(const PreparedDraw& draw, const std::array<ClipPosition, 3>& positions_clip,
                      std::span<const FixedPosition> outline, const PrimitiveInterpolation& interpolation) {
  const RasterState& state = draw.input.state;
  const DepthTransform transform = depth_transform(state);
  const auto& [least, greatest] = std::minmax(state.viewport.minDepth, state.viewport.maxDepth);
  double result = 0;
  const auto include = [&, low = double{least}, high = double{greatest}](double depth) {
    const double limited = state.depth_clip ? std::clamp(depth, low, high) : depth;
    // To float32: the last bit of a double must not decide about the exponent.
    result = std::max(result, double{std::abs(static_cast<float>(limited))});
  };
  if (std::all_of(positions_clip.begin(), positions_clip.end(), [](const auto& one) { return one[3] > 0; })) {
    for (const ClipPosition& position : positions_clip) {
      include(double{position[2]} / double{position[3]} * transform.scale + transform.offset);
    }
    return result;
  }
  const double pixel = 1U << draw.subpixel_bits;
  for (const FixedPosition& vertex : outline) {
    include(interpolation.depth_framebuffer.at(vertex.x_fixed / pixel - 0.5 - interpolation.anchor_x,
                                               vertex.y_fixed / pixel - 0.5 - interpolation.anchor_y));
  }
  return result;
}

// What a polygon's depth is biased by, filled or not.
double bias_of(const PreparedDraw& draw, const std::array<ClipPosition, 3>& positions_clip,
               std::span<const FixedPosition> outline, const PrimitiveInterpolation& interpolation) {
  return depth_bias(*draw.input.state.depth_bias, interpolation.depth_framebuffer,
                    max_depth_code(draw.input.depth.format),
                    greatest_depth(draw, positions_clip, outline, interpolation));
}

// The same for the polygon whose edges or corners are drawn.
double bias_of_outlined(const PreparedDraw& draw, const std::array<uint32_t, 3>& vertices,
                        std::span<const ClipPosition> all_positions_clip, int32_t anchor_x, int32_t anchor_y) {
  const auto window_vertex = [&](uint32_t vertex) { return draw.window_vertex(vertex, all_positions_clip[vertex]); };
  const AssembledPrimitive triangle =
      assembled(draw, 0, vertices, all_positions_clip,
                {window_vertex(vertices[0]), window_vertex(vertices[1]), window_vertex(vertices[2])});
  const std::optional<VisiblePolygon> polygon = visible_polygon(draw.setup, triangle);
  const RasterState& state = draw.input.state;
  const PrimitiveInterpolation interpolation =
      make_interpolation(state.viewport, depth_transform(state), triangle.positions_clip, anchor_x, anchor_y);
  return bias_of(draw, triangle.positions_clip, polygon->outline(), interpolation);
}

LineParameter line_parameter(const RasterState& state, std::span<const FixedPosition> outline) {
  if (state.line_mode != VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT) {
    return LineParameter::kProjection;
  }
  return is_x_major({outline[0], outline[1]}) ? LineParameter::kX : LineParameter::kY;
}

}  // namespace

void build_chunk(const PreparedDraw& draw, const TileGrid& grid, std::span<const ClipPosition> positions_clip,
                 std::span<const WindowVertex> window_vertices, uint32_t first, uint32_t end, PrimitiveChunk& chunk) {
  chunk.clear();
  const ChunkBuilder builder(draw, positions_clip, window_vertices, chunk);
  builder.add(first, end);
  chunk.sort_into(grid);
}

std::vector<uint32_t> chunks_by_bands(const PreparedDraw& draw, const TileGrid& grid,
                                      std::span<const WindowVertex> window_vertices, const ChunkRange& chunks,
                                      uint32_t threads) {
  std::vector<std::vector<uint32_t>> of_threads(threads);
  for (uint32_t chunk = 0; chunk < chunks.count; ++chunk) {
    const uint32_t middle = (chunks.first + chunk) * kPrimitivesInChunk + kPrimitivesInChunk / 2;
    const uint32_t vertex = draw.assembly.vertices(std::min(middle, draw.assembly.count() - 1))[0];
    const auto& [position, clip_code, cull_code] = window_vertices[vertex];
    // Clipped, it is nowhere.
    const uint32_t thread =
        clip_code == 0 ? grid.thread_of_row(position.y_fixed >> draw.subpixel_bits, threads) : chunk % threads;
    of_threads[thread].push_back(chunk);
  }
  size_t longest = 0;
  for (const std::vector<uint32_t>& chunks_of_thread : of_threads) {
    longest = std::max(longest, chunks_of_thread.size());
  }
  std::vector<uint32_t> calls(longest * threads, kNoChunk);
  for (uint32_t thread = 0; thread < threads; ++thread) {
    for (size_t i = 0; i < of_threads[thread].size(); ++i) {
      calls[i * threads + thread] = of_threads[thread][i];
    }
  }
  return calls;
}

void clear_around(const DrawInput& input, const PixelRect& pixels) {
  if (!input.clears()) {
    return;
  }
  const auto width = static_cast<int32_t>(input.target_width);
  const auto height = static_cast<int32_t>(input.target_height);
  const PixelRect kept = intersection(pixels, {0, 0, width, height});
  if (kept.empty()) {
    internal::clear_attachments(input, {0, 0, width, height});
    return;
  }
  for (const PixelRect& side :
       {PixelRect{0, 0, width, kept.top}, PixelRect{0, kept.bottom, width, height},
        PixelRect{0, kept.top, kept.left, kept.bottom}, PixelRect{kept.right, kept.top, width, kept.bottom}}) {
    internal::clear_attachments(input, side);
  }
}

PrimitiveInterpolation make_interpolation(const PreparedDraw& draw, const SetupPrimitive& primitive,
                                          std::span<const ClipPosition> positions_clip,
                                          std::span<const FixedPosition> outline) {
  const std::array<uint32_t, 3>& vertices = primitive.indices;
  const PlaneAnchor anchor = plane_anchor(draw, outline);
  const RasterState& state = draw.input.state;
  const DepthTransform depth = depth_transform(state);
  const std::array<ClipPosition, 3> positions{positions_clip[vertices[0]], positions_clip[vertices[1]],
                                              positions_clip[vertices[2]]};
  PrimitiveInterpolation interpolation = [&] {
    switch (draw.shape) {
      case Shape::kLine:
        return make_line_interpolation(state.viewport, depth, positions, primitive.ends,
                                       line_parameter(state, outline), anchor.x, anchor.y);
      case Shape::kPoint: {
        const float size = effective_point_size(draw.input.vertices.point_size(vertices[primitive.ends.from]));
        return make_point_interpolation(state.viewport, depth, positions, primitive.ends.from, size, anchor.x,
                                        anchor.y);
      }
      case Shape::kPolygon:
        break;
    }
    return make_interpolation(state.viewport, depth, positions, anchor.x, anchor.y);
  }();
  if (state.depth_bias && is_polygon_topology(draw.input.vertices.topology)) {
    interpolation.depth_framebuffer.at_anchor +=
        draw.shape == Shape::kPolygon ? bias_of(draw, positions, outline, interpolation)
                                      : bias_of_outlined(draw, vertices, positions_clip, anchor.x, anchor.y);
  }
  return interpolation;
}

}  // namespace fillrule::renderer
