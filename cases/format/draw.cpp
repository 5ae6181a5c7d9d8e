#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/format/indices.h"
#include "cases/format/repeat.h"
#include "cases/format/sections.h"
#include "cases/format/space.h"

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
  const toml::node* point_sizes = nullptr;   // null: none, or one number, or one for each position
  const toml::array* clip_distances = nullptr;
  const toml::array* cull_distances = nullptr;
};

std::optional<float> rounded_coordinate(const toml::node& node, double value, bool finite_inputs, Values& values) {
  const auto rounded = static_cast<float>(value);
  if (finite_inputs && !std::isfinite(rounded)) {
    values.diagnostics().add(place_of(node), fmt::format("clip-space coordinate {} is beyond float32", value),
                             "write inf if infinity is meant");
    return std::nullopt;
  }
  return rounded;
}

ClipPosition read_clip_position(const toml::array& coordinates, Values& values) {
  ClipPosition clip{};
  for (size_t i = 0; i < clip.size(); ++i) {
    clip[i] = values.float32(*coordinates.get(i), "coordinate").value_or(0.0F);
  }
  return clip;
}

ClipPosition read_other_position(const toml::array& coordinates, PositionSpace space, const VkViewport& viewport,
                                 Values& values) {
  Position position{0.0, 0.0, 0.5, 1.0};
  bool finite_inputs = true;
  for (size_t i = 0; i < coordinates.size(); ++i) {
    const auto number = values.number(*coordinates.get(i), "coordinate");
    if (!number) return {};
    position[i] = number->value;
    finite_inputs = finite_inputs && std::isfinite(number->value);
  }
  Position pos_clip = clip_from(space, position, viewport);
  // Without a depth (and so with w = 1) the position lies in the middle of NDC, whatever the viewport's depth range.
  if (coordinates.size() == 2) pos_clip[2] = 0.5;
  ClipPosition rounded{};
  for (size_t i = 0; i < rounded.size(); ++i) {
    const auto value = rounded_coordinate(coordinates, pos_clip[i], finite_inputs, values);
    if (!value) return {};
    rounded[i] = *value;
  }
  return rounded;
}

ClipPosition read_position(const toml::node& node, PositionSpace space, const VkViewport& viewport, Values& values) {
  const bool clip = space == PositionSpace::kClip;
  const std::string_view expected = clip ? "[x, y, z, w]" : "[x, y], [x, y, z] or [x, y, z, w]";
  const toml::array* const coordinates = as_array(node, "position", expected, values.diagnostics());
  if (coordinates == nullptr) return {};
  const size_t count = coordinates->size();
  if (count > 4 || count < (clip ? 4U : 2U)) {
    values.diagnostics().add(place_of(node),
                             fmt::format("position in {} space must be {}, not {} numbers",
                                         enum_name(kPositionSpaces, space), expected, count),
                             clip ? R"(other spaces: space = "ndc" or "framebuffer")" : "");
    return {};
  }
  return clip ? read_clip_position(*coordinates, values) : read_other_position(*coordinates, space, viewport, values);
}

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

void append_distances(const toml::array* array, std::string_view label, uint32_t count, Values& values,
                      std::vector<float>& out) {
  if (array == nullptr) return;
  for (const toml::node& vertex : *array) {
    const toml::array* const distances = vertex.as_array();
    if (distances != nullptr && distances->size() != count) {
      values.diagnostics().add(place_of(vertex), fmt::format("{} has {} distances here and {} at the first position",
                                                             label, distances->size(), count));
    }
    for (size_t i = 0; i < count; ++i) {
      const toml::node* const node = distances == nullptr ? &vertex : distances->get(i);
      out.push_back(node == nullptr ? 0.0F : values.float32(*node, label).value_or(0.0F));
    }
  }
}

void append_vertex_attributes(const VertexSource& source, Values& values, Draw& draw) {
  if (source.point_sizes != nullptr) {
    const toml::array* const sizes = source.point_sizes->as_array();
    for (size_t i = 0; i < source.positions->size(); ++i) {
      const toml::node& node = sizes == nullptr ? *source.point_sizes : *sizes->get(i);
      const auto size = values.finite_float32(node, "point size");
      if (size && *size <= 0.0F) {
        values.diagnostics().add(place_of(node), fmt::format("a point size must be above 0, not {}", *size));
      }
      draw.point_sizes.push_back(size.value_or(1.0F));
    }
  }
  append_distances(source.clip_distances, "clip_distances", draw.clip_distance_count, values, draw.clip_distances);
  append_distances(source.cull_distances, "cull_distances", draw.cull_distance_count, values, draw.cull_distances);
}

void append_copy(const VertexSource& source, const std::vector<Varying>& varyings, Values& values, Draw& draw) {
  const auto first_vertex = static_cast<uint32_t>(draw.positions.size());
  for (size_t vertex = 0; vertex < source.positions->size(); ++vertex) {
    draw.positions.push_back(
        read_position(*source.positions->get(vertex), source.space, draw.state.viewport, values));
    for (size_t i = 0; i < varyings.size(); ++i) {
      if (source.varyings[i] == nullptr) continue;  // a built-in, or wrong
      read_varying_value(*source.varyings[i]->get(vertex), varyings[i], values, draw.varyings);
    }
  }
  append_vertex_attributes(source, values, draw);
  if (source.indices == nullptr) return;
  for (const toml::node& node : *source.indices) {
    append_index(node, first_vertex, static_cast<int64_t>(source.positions->size()), values, draw);
  }
}

std::vector<const toml::array*> find_varyings(const toml::table& table, const std::vector<Varying>& varyings,
                                              size_t vertex_count, Values& values) {
  Diagnostics& diagnostics = values.diagnostics();
  std::vector<const toml::array*> found(varyings.size(), nullptr);
  const toml::node* const node = table.get("varyings");
  const toml::table* const given = node == nullptr ? nullptr : as_table(*node, "draw.varyings", diagnostics);
  if (node != nullptr && given == nullptr) return found;
  std::vector<std::string> names;
  for (size_t i = 0; i < varyings.size(); ++i) {
    if (varyings[i].source != VaryingSource::kVertices) continue;
    const std::string& name = varyings[i].name;
    names.push_back(name);
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
  if (given == nullptr) return found;
  for (const auto& [key, value] : *given) {
    if (std::find(names.begin(), names.end(), key.str()) != names.end()) continue;
    diagnostics.add(place_of(key), fmt::format("unknown varying \"{}\"", key.str()),
                    names.empty() ? "declare it in [varyings]" : suggestion(key.str(), names, "declared"));
  }
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

void wrong_number(const toml::node& node, std::string_view label, const toml::array& positions,
                  Diagnostics& diagnostics) {
  diagnostics.add(place_of(node),
                  fmt::format("{} has {} values for {} positions", label, node.as_array()->size(), positions.size()));
}

// Null where there are none, or wrong ones.
const toml::array* find_distances(const toml::table& table, std::string_view key, const toml::array& positions,
                                  Diagnostics& diagnostics) {
  const toml::node* const node = table.get(key);
  if (node == nullptr) return nullptr;
  const toml::array* const array =
      as_array(*node, key, "an array with one distance, or an array of them, for each position", diagnostics);
  if (array == nullptr) return nullptr;
  if (array->size() == positions.size()) return array;
  wrong_number(*node, key, positions, diagnostics);
  return nullptr;
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
  source.point_sizes = table.get("point_sizes");
  if (source.point_sizes != nullptr && source.point_sizes->is_array() &&
      source.point_sizes->as_array()->size() != source.positions->size()) {
    wrong_number(*source.point_sizes, "point_sizes", *source.positions, diagnostics);
    source.point_sizes = nullptr;
  }
  source.clip_distances = find_distances(table, "clip_distances", *source.positions, diagnostics);
  source.cull_distances = find_distances(table, "cull_distances", *source.positions, diagnostics);
  return source;
}

// As many as the first vertex has.
uint32_t distance_count(const toml::array* array) {
  if (array == nullptr) return 0;
  const toml::array* const first = array->get(0)->as_array();
  return first == nullptr ? 1 : static_cast<uint32_t>(first->size());
}

void read_distance_counts(const toml::table& table, const VertexSource& source, Diagnostics& diagnostics,
                          Draw& draw) {
  draw.clip_distance_count = distance_count(source.clip_distances);
  draw.cull_distance_count = distance_count(source.cull_distances);
  if (draw.clip_distance_count + draw.cull_distance_count <= kMaxClipAndCullDistances) return;
  diagnostics.add(place_of(table),
                  fmt::format("{} clip distances and {} cull distances are too many", draw.clip_distance_count,
                              draw.cull_distance_count),
                  fmt::format("up to {} together", kMaxClipAndCullDistances));
  draw.clip_distance_count = 0;
  draw.cull_distance_count = 0;
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
  const auto source = find_vertices(table, varyings, values);
  if (!source) return draw;
  if (source->indices != nullptr) draw.indices.emplace();
  read_index_state(table, values, draw);
  read_distance_counts(table, *source, values.diagnostics(), draw);
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
