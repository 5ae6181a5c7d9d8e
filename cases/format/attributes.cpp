#include "cases/format/attributes.h"

#include <fmt/format.h>

namespace fillrule::format {
namespace {

bool is_for_each_position(const toml::node& node, const toml::array& array, std::string_view key, size_t positions,
                          Diagnostics& diagnostics) {
  if (array.size() == positions) return true;
  diagnostics.add(place_of(node), fmt::format("{} has {} values for {} positions", key, array.size(), positions));
  return false;
}

const toml::node* find_point_sizes(const toml::table& table, size_t positions, Diagnostics& diagnostics) {
  const toml::node* const node = table.get("point_sizes");
  const toml::array* const array = node == nullptr ? nullptr : node->as_array();
  if (array == nullptr || is_for_each_position(*node, *array, "point_sizes", positions, diagnostics)) return node;
  return nullptr;
}

// A vertex's distances, of which a single one may stand without brackets.
size_t count_of(const toml::node& vertex) {
  const toml::array* const distances = vertex.as_array();
  return distances == nullptr ? 1 : distances->size();
}

bool have_one_count(const toml::array& vertices, std::string_view key, Diagnostics& diagnostics) {
  const size_t count = count_of(*vertices.get(0));
  if (count == 0 || count > kMaxClipAndCullDistances) {
    diagnostics.add(
        place_of(*vertices.get(0)),
        fmt::format("{} must have 1 to {} distances a position, not {}", key, kMaxClipAndCullDistances, count),
        count == 0 ? "leave the key out if there are none" : "");
    return false;
  }
  for (const toml::node& vertex : vertices) {
    if (count_of(vertex) == count) continue;
    diagnostics.add(place_of(vertex), fmt::format("{} has {} distances here and {} at the first position", key,
                                                  count_of(vertex), count));
    return false;
  }
  return true;
}

const toml::array* find_distances(const toml::table& table, std::string_view key, size_t positions,
                                  Diagnostics& diagnostics, uint32_t& count) {
  const toml::node* const node = table.get(key);
  if (node == nullptr) return nullptr;
  const toml::array* const array =
      as_array(*node, key, "an array with one distance, or an array of them, for each position", diagnostics);
  if (array == nullptr) return nullptr;
  const bool good =
      is_for_each_position(*node, *array, key, positions, diagnostics) && have_one_count(*array, key, diagnostics);
  if (!good) return nullptr;
  count = static_cast<uint32_t>(count_of(*array->get(0)));
  return array;
}

void append_point_sizes(const toml::node& node, size_t positions, Values& values, std::vector<float>& out) {
  const toml::array* const array = node.as_array();
  const size_t given = array == nullptr ? 1 : array->size();
  for (size_t i = 0; i < given; ++i) {
    const toml::node& value = array == nullptr ? node : *array->get(i);
    const auto size = values.finite_float32(value, "point_sizes");
    if (size && *size <= 0.0F) {
      values.diagnostics().add(place_of(value), fmt::format("point_sizes must be above 0, not {}", *size));
    }
    out.insert(out.end(), array == nullptr ? positions : 1, size.value_or(1.0F));
  }
}

void append_distances(const toml::array& vertices, std::string_view key, Values& values, std::vector<float>& out) {
  for (const toml::node& vertex : vertices) {
    const toml::array* const distances = vertex.as_array();
    for (size_t i = 0; i < count_of(vertex); ++i) {
      out.push_back(values.float32(distances == nullptr ? vertex : *distances->get(i), key).value_or(0.0F));
    }
  }
}

}  // namespace

VertexAttributes find_attributes(const toml::table& table, size_t positions, Diagnostics& diagnostics, Draw& draw) {
  VertexAttributes found;
  found.point_sizes = find_point_sizes(table, positions, diagnostics);
  found.clip_distances = find_distances(table, "clip_distances", positions, diagnostics, draw.clip_distance_count);
  found.cull_distances = find_distances(table, "cull_distances", positions, diagnostics, draw.cull_distance_count);
  if (draw.clip_distance_count + draw.cull_distance_count > kMaxClipAndCullDistances) {
    diagnostics.add(place_of(*table.get("cull_distances")),
                    fmt::format("{} clip_distances and {} cull_distances a position are too many",
                                draw.clip_distance_count, draw.cull_distance_count),
                    fmt::format("up to {} together", kMaxClipAndCullDistances));
  }
  return found;
}

void append_attributes(const VertexAttributes& attributes, size_t positions, Values& values, Draw& draw) {
  if (attributes.point_sizes != nullptr) {
    append_point_sizes(*attributes.point_sizes, positions, values, draw.point_sizes);
  }
  if (attributes.clip_distances != nullptr) {
    append_distances(*attributes.clip_distances, "clip_distances", values, draw.clip_distances);
  }
  if (attributes.cull_distances != nullptr) {
    append_distances(*attributes.cull_distances, "cull_distances", values, draw.cull_distances);
  }
}

}  // namespace fillrule::format
