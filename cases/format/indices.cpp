#include "cases/format/indices.h"

#include <fmt/format.h>

#include <limits>

namespace fillrule::format {
namespace {

void refuse_index_keys_without_indices(const toml::table& table, Diagnostics& diagnostics) {
  if (table.get("indices") != nullptr) return;
  for (const std::string_view key : {"index_type", "vertex_offset", "primitive_restart"}) {
    if (const toml::node* const node = table.get(key)) {
      diagnostics.add(place_of(*node), fmt::format("{} without indices", key), "give indices, or leave the key out");
    }
  }
}

bool is_list(VkPrimitiveTopology topology) {
  return topology == VK_PRIMITIVE_TOPOLOGY_POINT_LIST || topology == VK_PRIMITIVE_TOPOLOGY_LINE_LIST ||
         topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
}

void refuse_vertex(const toml::node& node, int64_t index, int64_t vertices, int32_t offset,
                   Diagnostics& diagnostics) {
  if (offset == 0) {
    diagnostics.add(place_of(node), fmt::format("index must be 0 to {}, not {}", vertices - 1, index));
    return;
  }
  diagnostics.add(
      place_of(node),
      fmt::format("index {} with vertex_offset {} is vertex {} of {}", index, offset, index + offset, vertices),
      "vertices count from 0, in each copy of repeat anew");
}

}  // namespace

void append_index(const toml::node& node, uint32_t first_vertex, int64_t vertices, Values& values, Draw& draw) {
  const uint32_t restart = restart_index(draw.index_type);
  if (node.is_string() && node.as_string()->get() == "restart") {
    if (!draw.primitive_restart) {
      values.diagnostics().add(place_of(node), "an index restarts, but primitive_restart is not true",
                               is_list(draw.topology) ? "strips and fans can restart, lists cannot"
                                                      : "write primitive_restart = true in the draw");
    }
    draw.indices->push_back(restart);
    return;
  }
  const auto index = values.integer(node, "index", {.min = 0, .max = restart});
  if (!index) return;
  const int64_t moved = *index + first_vertex;
  const bool restarts = draw.primitive_restart && *index == restart;
  const int64_t vertex = *index + draw.vertex_offset;
  if (!restarts && (vertex < 0 || vertex >= vertices)) {
    refuse_vertex(node, *index, vertices, draw.vertex_offset, values.diagnostics());
    return;
  }
  const int64_t largest = draw.primitive_restart ? int64_t{restart} - 1 : int64_t{restart};
  if (!restarts && moved > largest) {
    values.diagnostics().add(
        place_of(node),
        fmt::format("repeat moves an index to {}, beyond {}, the index_type's largest", moved, largest),
        "choose a larger index_type");
    return;
  }
  draw.indices->push_back(restarts ? restart : static_cast<uint32_t>(moved));
}

void read_index_state(const toml::table& table, Values& values, Draw& draw) {
  refuse_index_keys_without_indices(table, values.diagnostics());
  if (const toml::node* const node = table.get("index_type")) {
    draw.index_type = values.enumerator(*node, "index_type", kIndexTypes).value_or(draw.index_type);
  }
  if (const toml::node* const node = table.get("vertex_offset")) {
    constexpr IntegerRange kInt32{.min = std::numeric_limits<int32_t>::min(),
                                  .max = std::numeric_limits<int32_t>::max()};
    draw.vertex_offset = static_cast<int32_t>(values.integer(*node, "vertex_offset", kInt32).value_or(0));
  }
  const toml::node* const node = table.get("primitive_restart");
  if (node == nullptr) return;
  draw.primitive_restart = values.boolean(*node, "primitive_restart").value_or(false);
  if (draw.primitive_restart && is_list(draw.topology)) {
    values.diagnostics().add(place_of(*node), "primitive_restart is for strips and fans, not for lists",
                             "Vulkan allows it for lists only with an extension");
  }
}

}  // namespace fillrule::format
