#include "cases/format/toml_access.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "cases/format/suggestion.h"

namespace fillrule::format {
namespace {

Place place_of(const toml::source_region& region) {
  return Place{.line = region.begin.line, .column = static_cast<uint32_t>(region.begin.column)};
}

}  // namespace

Place place_of(const toml::node& node) {
  return place_of(node.source());
}
Place place_of(const toml::key& key) {
  return place_of(key.source());
}

std::string type_in_words(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a float";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

std::vector<Entry> in_file_order(const toml::table& table) {
  std::vector<Entry> entries;
  for (const auto& [key, value] : table) entries.push_back(Entry{.key = &key, .value = &value});
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    const Place pa = place_of(*a.key);
    const Place pb = place_of(*b.key);
    return std::tie(pa.line, pa.column) < std::tie(pb.line, pb.column);
  });
  return entries;
}

void check_keys(const Section& section, std::initializer_list<std::string_view> known, Diagnostics& diagnostics) {
  for (const auto& [key, value] : section.table) {
    const std::string_view name = key.str();
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    diagnostics.add(place_of(key), fmt::format("unknown key \"{}\" in {}", name, section.label),
                    suggestion(name, std::vector<std::string>(known.begin(), known.end()), "known keys"));
  }
}

void wrong_type(const toml::node& node, std::string_view label, std::string_view expected, Diagnostics& diagnostics,
                std::string hint) {
  diagnostics.add(place_of(node), fmt::format("{} must be {}, not {}", label, expected, type_in_words(node)),
                  std::move(hint));
}

const toml::table* as_table(const toml::node& node, std::string_view label, Diagnostics& diagnostics) {
  if (!node.is_table()) wrong_type(node, label, "a table", diagnostics);
  return node.as_table();
}

const toml::array* as_array(const toml::node& node, std::string_view label, std::string_view expected,
                            Diagnostics& diagnostics) {
  if (!node.is_array()) wrong_type(node, label, expected, diagnostics);
  return node.as_array();
}

}  // namespace fillrule::format
