#include "harness/faults/assembly.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fillrule::faults {
namespace {

using Run = std::vector<uint32_t>;  // the vertices between two restarts

bool restarts(const Context& context, uint32_t index) {
  const Draw& draw = context.draw;
  if (!draw.primitive_restart) return false;
  if (context.has(Fault::kRestartOf32BitsOnly)) return index == 0xFFFFFFFF;
  if (context.has(Fault::kOffsetBeforeRestart)) index += static_cast<uint32_t>(draw.vertex_offset);
  return index == restart_index(draw.index_type);
}

std::vector<Run> runs_of(const Context& context) {
  const Draw& draw = context.draw;
  const auto vertices = static_cast<uint32_t>(draw.positions.size());
  std::vector<Run> runs(1);
  for (uint32_t i = 0; i < element_count(draw); ++i) {
    if (!draw.indices) {
      runs.back().push_back(i);
      continue;
    }
    const uint32_t index = (*draw.indices)[i];
    if (restarts(context, index)) {
      if (!context.has(Fault::kRestartIgnored)) runs.emplace_back();
      continue;
    }
    const auto offset = context.has(Fault::kOffsetIgnored) ? 0U : static_cast<uint32_t>(draw.vertex_offset);
    // A fault must not lead out of the vertices.
    runs.back().push_back(std::min(index + offset, vertices - 1));
  }
  return runs;
}

// The i-th primitive of a run. `odd` tells whether a strip's triangle has to be turned round.
Primitive primitive_of(const Context& context, const Run& run, uint32_t i, bool odd) {
  const bool last = context.state().provoking_vertex == VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT ||
                    context.has(Fault::kFlatFromLastVertex);
  const size_t pair = size_t{2} * i;
  const size_t triple = size_t{3} * i;
  switch (context.draw.topology) {
    case VK_PRIMITIVE_TOPOLOGY_POINT_LIST:
      return {.vertices = {run[i], run[i], run[i]}, .size = 1, .provoking = run[i]};
    case VK_PRIMITIVE_TOPOLOGY_LINE_LIST:
      return {.vertices = {run[pair], run[pair + 1]}, .size = 2, .provoking = run[pair + (last ? 1 : 0)]};
    case VK_PRIMITIVE_TOPOLOGY_LINE_STRIP:
      return {.vertices = {run[i], run[i + 1]}, .size = 2, .provoking = run[i + (last ? 1 : 0)]};
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP: {
      Primitive triangle{.vertices = {run[i], run[i + 1], run[i + 2]}, .provoking = run[i + (last ? 2 : 0)]};
      if (odd && !context.has(Fault::kStripParityIgnored)) std::swap(triangle.vertices[1], triangle.vertices[2]);
      return triangle;
    }
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN: {
      Primitive triangle{.vertices = {run[0], run[i + 1], run[i + 2]}, .provoking = run[i + (last ? 2 : 1)]};
      if (context.has(Fault::kFanProvokesHub)) triangle.provoking = run[0];
      if (context.has(Fault::kFanTurnedOver)) std::swap(triangle.vertices[1], triangle.vertices[2]);
      return triangle;
    }
    default:
      return {.vertices = {run[triple], run[triple + 1], run[triple + 2]}, .provoking = run[triple + (last ? 2 : 0)]};
  }
}

bool has_nan(const Context& context, const Primitive& primitive) {
  return std::ranges::any_of(primitive.vertices, [&](uint32_t vertex) {
    return std::ranges::any_of(context.draw.positions[vertex], [](float value) { return std::isnan(value); });
  });
}

}  // namespace

std::vector<Primitive> assemble(const Context& context) {
  std::vector<Primitive> primitives;
  bool odd = false;
  for (const Run& run : runs_of(context)) {
    if (!context.has(Fault::kStripParityRunsOverRestart)) odd = false;
    const uint32_t count = primitives_in_run(context.draw.topology, static_cast<uint32_t>(run.size()));
    for (uint32_t i = 0; i < count; ++i, odd = !odd) {
      Primitive primitive = primitive_of(context, run, i, odd);
      primitive.number = static_cast<uint32_t>(primitives.size());
      if (context.has(Fault::kNanVertexKillsDraw) && has_nan(context, primitive)) return primitives;
      primitives.push_back(primitive);
    }
  }
  if (context.has(Fault::kOrderLostBetweenThreads)) {
    std::stable_partition(primitives.begin(), primitives.end(),
                          [](const Primitive& one) { return one.number % 2 == 1; });
  }
  return primitives;
}

}  // namespace fillrule::faults
