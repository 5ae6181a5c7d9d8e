#include <fmt/format.h>

#include <algorithm>

#include "cases/format/attributes.h"
#include "cases/format/indices.h"
#include "cases/format/position.h"
#include "cases/format/repeat.h"
#include "cases/format/sections.h"

namespace fillrule::format {
namespace {

// Far beyond any sensible case; a slip in `repeat` must not take all memory.
constexpr size_t kMaxVertices = size_t{1} << 22U;

// What one draw gives its vertices from, checked once and evaluated for each copy of `repeat`.
struct VertexSource {
  PositionSpace space = PositionSpace::kClip;
  const toml::array* positions = nullptr;
  std::vector<const toml::array*> varyings;  // as the case's; null where missing or wrong
  const toml::array* indices = nullptr;      // null: none
  VertexAttributes attributes;
};

void read_varying_value(const toml::node& node, const Varying& varying, Values& values, std::vector<float>& out) {
  const toml::array* const components = node.as_array();
  const size_t count = components == nullptr ? 1 : components->size();
  if (count != varying.components) {
    values.diagnostics().add(place_of(node), fmt::format("varying \"{}\" has {} components, not {}", varying.name,
                                                         varying.components, count));
    out.resize(out.size() + varying.components);
    return;
  }
  for (size_t i = 0; i < count; ++i) {
    const toml::node& component = components == nullptr ? node : *components->get(i);
    out.push_back(values.float32(component, varying.name).value_or(0.0F));
  }
}

void append_copy(const VertexSource& source, const std::vector<Varying>& varyings, Values& values, Draw& draw) {
  const auto first_vertex = static_cast<uint32_t>(draw.positions.size());
  for (size_t vertex = 0; vertex < source.positions->size(); ++vertex) {
    draw.positions.push_back(read_position(*source.positions->get(vertex), source.space, draw.state, values));
    for (size_t i = 0; i < varyings.size(); ++i) {
      if (source.varyings[i] == nullptr) continue;  // a built-in, or wrong
      read_varying_value(*source.varyings[i]->get(vertex), varyings[i], values, draw.varyings);
    }
  }
  append_attributes(source.attributes, source.positions->size(), values, draw);
  if (source.indices == nullptr) return;
  for (const toml::node& node : *source.indices) {
    append_index(node, first_vertex, static_cast<int64_t>(source.positions->size()), values, draw);
  }
}

void refuse_other_varyings(const toml::table& given, const std::vector<Varying>& varyings, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const Varying& varying : varyings) {
    if (varying.source == VaryingSource::kVertices) names.push_back(varying.name);
  }
  for (const auto& [key, value] : given) {
    const std::string_view name = key.str();
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const bool built_in =
        std::any_of(varyings.begin(), varyings.end(), [&](const Varying& varying) { return varying.name == name; });
    if (built_in) {
      diagnostics.add(place_of(key), fmt::format("varying \"{}\" is a built-in and has no values", name),
                      "leave it out of [draw.varyings]");
    } else {
      diagnostics.add(place_of(key), fmt::format("unknown varying \"{}\"", name),
                      names.empty() ? "declare it in [varyings]" : suggestion(name, names, "declared"));
    }
  }
}

std::vector<const toml::array*> find_varyings(const toml::table& table, const std::vector<Varying>& varyings,
                                              size_t vertex_count, Values& values) {
  Diagnostics& diagnostics = values.diagnostics();
  std::vector<const toml::array*> found(varyings.size(), nullptr);
  const toml::node* const node = table.get("varyings");
  const toml::table* const given = node == nullptr ? nullptr : as_table(*node, "draw.varyings", diagnostics);
  if (node != nullptr && given == nullptr) return found;
  for (size_t i = 0; i < varyings.size(); ++i) {
    if (varyings[i].source != VaryingSource::kVertices) continue;
    const std::string& name = varyings[i].name;
    const toml::node* const value = given == nullptr ? nullptr : given->get(name);
    if (value == nullptr) {
      diagnostics.add(place_of(table), fmt::format("draw lacks the varying \"{}\"", name),
                      "give one value for each position in [draw.varyings]");
      continue;
    }
    const toml::array* const array =
        as_array(*value, fmt::format("varying \"{}\"", name), "an array with a value for each position", diagnostics);
    if (array == nullptr) continue;
    if (array->size() != vertex_count) {
      diagnostics.add(place_of(*value), fmt::format("varying \"{}\" has {} values for {} positions", name,
                                                    array->size(), vertex_count));
      continue;
    }
    found[i] = array;
  }
  if (given != nullptr) refuse_other_varyings(*given, varyings, diagnostics);
  return found;
}

VkPrimitiveTopology read_topology(const toml::table& table, Values& values) {
  constexpr VkPrimitiveTopology kFallback = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  const toml::node* const node = table.get("topology");
  if (node == nullptr) return kFallback;
  const auto name = values.text(*node, "topology");
  if (!name) return kFallback;
  if (std::find(kUnsupportedTopologies.begin(), kUnsupportedTopologies.end(), *name) ==
      kUnsupportedTopologies.end()) {
    return values.enumerator(*node, "topology", kTopologies).value_or(kFallback);
  }
  values.diagnostics().add(place_of(*node), fmt::format("topology \"{}\" is not supported", *name),
                           fmt::format("supported: {}", fmt::join(enum_names(kTopologies), ", ")));
  return kFallback;
}

// Nothing if the draw has no positions to go on with.
std::optional<VertexSource> find_vertices(const toml::table& table, const std::vector<Varying>& varyings,
                                          Values& values) {
  Diagnostics& diagnostics = values.diagnostics();
  VertexSource source;
  if (const toml::node* const node = table.get("space")) {
    source.space = values.enumerator(*node, "space", kPositionSpaces).value_or(source.space);
  }
  if (const toml::node* const node = table.get("indices")) {
    source.indices = as_array(*node, "indices", "an array of integers", diagnostics);
    if (source.indices != nullptr && source.indices->empty()) {
      diagnostics.add(place_of(*node), "indices is empty", "leave the key out to draw the vertices in their order");
    }
  }
  const toml::node* const positions = table.get("positions");
  if (positions == nullptr) {
    diagnostics.add(place_of(table), "draw has no positions", "positions = [[x, y, z, w], ...]");
    return std::nullopt;
  }
  source.positions = as_array(*positions, "positions", "an array of positions", diagnostics);
  if (source.positions == nullptr) return std::nullopt;
  if (source.positions->empty()) {
    diagnostics.add(place_of(*positions), "positions is empty", "a draw has at least one vertex");
    return std::nullopt;
  }
  source.varyings = find_varyings(table, varyings, source.positions->size(), values);
  return source;
}

// Elsewhere gl_PointCoord is undefined.
void refuse_point_coord_without_points(const toml::table& table, const std::vector<Varying>& varyings,
                                       const Draw& draw, Diagnostics& diagnostics) {
  const bool lines =
      draw.topology == VK_PRIMITIVE_TOPOLOGY_LINE_LIST || draw.topology == VK_PRIMITIVE_TOPOLOGY_LINE_STRIP;
  const bool points = draw.topology == VK_PRIMITIVE_TOPOLOGY_POINT_LIST ||
                      (!lines && draw.state.polygon_mode == VK_POLYGON_MODE_POINT);
  if (points) return;
  for (const Varying& varying : varyings) {
    if (varying.source != VaryingSource::kPointCoord) continue;
    diagnostics.add(place_of(table),
                    fmt::format("varying \"{}\" is point_coord, but this draw has no points", varying.name),
                    R"(topology = "point_list", or polygon_mode = "point")");
  }
}

Draw read_draw(const toml::table& table, const Target& target, const std::vector<Varying>& varyings,
               const RasterState& state, Values& values) {
  check_keys({table, "[[draw]]"},
             {"topology", "space", "positions", "indices", "index_type", "vertex_offset", "primitive_restart",
              "point_sizes", "clip_distances", "cull_distances", "repeat", "varyings", "state"},
             values.diagnostics());
  Draw draw{.topology = read_topology(table, values), .state = state};
  if (const toml::node* const node = table.get("state")) {
    const toml::table* const own = as_table(*node, "draw.state", values.diagnostics());
    if (own != nullptr) read_state({*own, "[draw.state]"}, target, values, draw.state);
  }
  refuse_point_coord_without_points(table, varyings, draw, values.diagnostics());
  auto source = find_vertices(table, varyings, values);
  if (!source) return draw;
  source->attributes = find_attributes(table, source->positions->size(), values.diagnostics(), draw);
  if (source->indices != nullptr) draw.indices.emplace();
  read_index_state(table, values, draw);
  const size_t size = source->positions->size() + (source->indices == nullptr ? 0 : source->indices->size());
  for_each_copy(table.get("repeat"), kMaxVertices / size, values,
                [&] { append_copy(*source, varyings, values, draw); });
  return draw;
}

}  // namespace

std::vector<Draw> read_draws(const toml::table& root, const Target& target, const std::vector<Varying>& varyings,
                             const RasterState& state, Values& values) {
  std::vector<Draw> draws;
  const toml::node* const node = root.get("draw");
  const toml::array* const array = node == nullptr ? nullptr : node->as_array();
  if (node == nullptr || (array != nullptr && array->empty())) {
    values.diagnostics().add(Place{}, "the case draws nothing", "add a [[draw]] with positions");
    return draws;
  }
  if (array == nullptr) {
    wrong_type(*node, "draw", "an array of tables", values.diagnostics(), "write [[draw]] with two brackets");
    return draws;
  }
  for (const toml::node& entry : *array) {
    const toml::table* const table = as_table(entry, "draw", values.diagnostics());
    if (table != nullptr) draws.push_back(read_draw(*table, target, varyings, state, values));
  }
  return draws;
}

}  // namespace fillrule::format
