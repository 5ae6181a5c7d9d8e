#include "renderer/primitive_assembly.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

namespace fillrule::renderer {
namespace {

std::vector<ElementRun> runs_of(const VertexStream& stream) {
  if (stream.runs) {
    return {stream.runs->begin(), stream.runs->end()};
  }
  return {
      {.first = 0, .count = stream.indices ? static_cast<uint32_t>(stream.indices->size()) : stream.vertex_count}};
}

}  // namespace

PrimitiveAssembly::PrimitiveAssembly(const VertexStream& stream, VkProvokingVertexModeEXT provoking_vertex)
    : topology_(stream.topology),
      provoking_vertex_(provoking_vertex),
      indices_(stream.indices),
      vertex_offset_(static_cast<uint32_t>(stream.vertex_offset)) {
  for (const ElementRun& run : runs_of(stream)) {
    const uint32_t primitives = primitives_in_run(topology_, run.count);
    if (primitives > 0) {
      runs_.push_back({.first_element = run.first, .first_primitive = count_});
      count_ += primitives;
    }
  }
}

void PrimitiveAssembly::vertices(uint32_t first, std::span<std::array<uint32_t, 3>> of_primitives) const {
  const bool are_as_indexed = indices_ && topology_ == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST &&
                              provoking_vertex_ == VK_PROVOKING_VERTEX_MODE_FIRST_VERTEX_EXT && runs_.size() == 1;
  if (!are_as_indexed) {
    for (auto& of_primitive : of_primitives) {
      of_primitive = vertices(first++);
    }
    return;
  }
  const uint32_t* index = indices_->data() + runs_.front().first_element + size_t{3} * first;
  for (auto& of_primitive : of_primitives) {
    of_primitive = {index[0] + vertex_offset_, index[1] + vertex_offset_, index[2] + vertex_offset_};
    index += 3;
  }
}

const PrimitiveAssembly::Run& PrimitiveAssembly::run_of(uint32_t primitive) const {
  const auto next = std::upper_bound(runs_.begin(), runs_.end(), primitive,
                                     [](uint32_t number, const Run& run) { return number < run.first_primitive; });
  return *(next - 1);
}

Result<void> check_indices(const VertexStream& stream) {
  if (!stream.indices) {
    return {};
  }
  const auto vertex = [&](uint32_t index) { return int64_t{index} + stream.vertex_offset; };
  const auto exists = [&](uint32_t index) { return vertex(index) >= 0 && vertex(index) < stream.vertex_count; };
  for (const ElementRun& run : runs_of(stream)) {
    const std::span<const uint32_t> indices = stream.indices->subspan(run.first, run.count);
    // Which one is wrong is asked only if one is: the extremes are found by vectors.
    uint32_t least = std::numeric_limits<uint32_t>::max();
    uint32_t greatest = 0;
    for (const uint32_t index : indices) {
      least = std::min(least, index);
      greatest = std::max(greatest, index);
    }
    if (!indices.empty() && !(exists(least) && exists(greatest))) {
      const uint32_t wrong = *std::ranges::find_if_not(indices, exists);
      return failure(fmt::format("index {} in a draw of {} vertices", vertex(wrong), stream.vertex_count));
    }
  }
  return {};
}

}  // namespace fillrule::renderer
