#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cases/format/sections.h"

namespace fillrule::format {
namespace {

// Varyings are planes of the results beside these.
constexpr std::array<std::string_view, 5> kPlaneNames{"coverage", "owner", "hits", "depth", "front_facing"};

void check_varying_name(const Entry& entry, Values& values) {
  const std::string name = entry.name();
  const auto word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  if (name.empty() || (name.front() >= '0' && name.front() <= '9') || !std::all_of(name.begin(), name.end(), word)) {
    values.diagnostics().add(place_of(*entry.key), fmt::format("\"{}\" is not a varying's name", name),
                             "a name has letters, digits and _, and does not begin with a digit");
  }
  if (std::find(kPlaneNames.begin(), kPlaneNames.end(), name) != kPlaneNames.end()) {
    values.diagnostics().add(place_of(*entry.key), fmt::format("a varying cannot be named \"{}\"", name),
                             "the results have a plane of that name; choose another");
  }
}

// The first vertex's value of a varying, in the first draw that has one.
const toml::node* first_value(const toml::table& root, std::string_view name) {
  const toml::array* const draws = root["draw"].as_array();
  if (draws == nullptr) return nullptr;
  for (const toml::node& draw : *draws) {
    const toml::table* const table = draw.as_table();
    if (table == nullptr) continue;
    const toml::array* const entries = (*table)["varyings"][name].as_array();
    if (entries != nullptr && !entries->empty()) return entries->get(0);
  }
  return nullptr;
}

// Adds an error if there is no value to take the number from.
uint32_t components_of_first_value(const toml::table& root, const Entry& entry, Values& values) {
  const toml::node* const value = first_value(root, entry.name());
  if (value == nullptr) {
    values.diagnostics().add(
        place_of(*entry.key),
        fmt::format("varying \"{}\" has no vertex to take its number of components from", entry.name()),
        "give its values in [draw.varyings], or write { components = 1, interpolation = \"smooth\" }");
    return 1;
  }
  const toml::array* const components = value->as_array();
  const size_t count = components == nullptr ? 1 : components->size();
  if (count < 1 || count > kMaxVaryingComponents) {
    values.diagnostics().add(place_of(*value), fmt::format("varying \"{}\" must have 1 to {} components, not {}",
                                                           entry.name(), kMaxVaryingComponents, count));
  }
  return static_cast<uint32_t>(count);
}

// gl_FragCoord and gl_PointCoord have no values in the file and nothing to choose.
void read_built_in(const toml::table& table, const Entry& entry, Values& values, Varying& varying) {
  for (const std::string_view key : {"components", "interpolation", "sampling"}) {
    const toml::node* const node = table.get(key);
    if (node == nullptr) continue;
    values.diagnostics().add(place_of(*node),
                             fmt::format("varying \"{}\" is a built-in and has no {}", entry.name(), key),
                             "leave the key out");
  }
  varying.components = varying.source == VaryingSource::kFragCoord ? 4 : 2;
}

void read_sampling(const toml::node& node, Values& values, Varying& varying) {
  varying.sampling = values.enumerator(node, "sampling", kSamplings).value_or(varying.sampling);
  if (varying.interpolation == Interpolation::kFlat && varying.sampling != Sampling::kCenter) {
    values.diagnostics().add(place_of(node), fmt::format("varying \"{}\" is flat and has no sampling", varying.name),
                             "leave the key out, or interpolate it");
  }
}

// Either "smooth", or { components = 3, interpolation = "smooth" } with all keys optional.
Varying read_varying(const toml::table& root, const Entry& entry, Values& values) {
  Varying varying{.name = entry.name()};
  const toml::table* const table = entry.value->as_table();
  if (table == nullptr && !entry.value->is_string()) {
    wrong_type(*entry.value, fmt::format("varying \"{}\"", varying.name), "a table or an interpolation",
               values.diagnostics(), R"(for example "smooth" or { components = 3, interpolation = "smooth" })");
    return varying;
  }
  if (table != nullptr) {
    check_keys({*table, fmt::format("varying \"{}\"", varying.name)},
               {"components", "interpolation", "sampling", "source"}, values.diagnostics());
    if (const toml::node* const source = table->get("source")) {
      varying.source = values.enumerator(*source, "source", kVaryingSources).value_or(varying.source);
    }
    if (varying.source != VaryingSource::kVertices) {
      read_built_in(*table, entry, values, varying);
      return varying;
    }
  }
  const toml::node* const interpolation = table == nullptr ? entry.value : table->get("interpolation");
  const toml::node* const components = table == nullptr ? nullptr : table->get("components");
  if (interpolation != nullptr) {
    varying.interpolation =
        values.enumerator(*interpolation, "interpolation", kInterpolations).value_or(varying.interpolation);
  }
  const toml::node* const sampling = table == nullptr ? nullptr : table->get("sampling");
  if (sampling != nullptr) read_sampling(*sampling, values, varying);
  if (components == nullptr) {
    varying.components = components_of_first_value(root, entry, values);
  } else if (const auto count = values.integer(*components, "components", {.min = 1, .max = kMaxVaryingComponents})) {
    varying.components = static_cast<uint32_t>(*count);
  }
  return varying;
}

}  // namespace

std::vector<Varying> read_varyings(const toml::table& root, Values& values) {
  std::vector<Varying> varyings;
  const toml::node* const node = root.get("varyings");
  if (node == nullptr) return varyings;
  const toml::table* const table = as_table(*node, "varyings", values.diagnostics());
  if (table == nullptr) return varyings;
  for (const Entry& entry : in_file_order(*table)) {
    if (varyings.size() == kMaxVaryings) {
      values.diagnostics().add(place_of(*entry.key), fmt::format("{} varyings are too many", table->size()),
                               fmt::format("a case has up to {}", kMaxVaryings));
      break;
    }
    check_varying_name(entry, values);
    varyings.push_back(read_varying(root, entry, values));
  }
  return varyings;
}

}  // namespace fillrule::format
