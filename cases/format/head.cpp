#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cases/format/sections.h"

namespace fillrule::format {
namespace {

std::string read_string(const toml::table& root, std::string_view key, Diagnostics& diagnostics) {
  const toml::node* const node = root.get(key);
  if (node == nullptr) return {};
  if (!node->is_string()) wrong_type(*node, key, "a string", diagnostics);
  return node->value_or(std::string());
}

std::string read_required(const toml::table& root, std::string_view key, std::string_view hint,
                          Diagnostics& diagnostics) {
  const toml::node* const node = root.get(key);
  if (node == nullptr) {
    diagnostics.add(Place{}, fmt::format("missing key \"{}\"", key), std::string(hint));
    return {};
  }
  std::string text = read_string(root, key, diagnostics);
  if (node->is_string() && trim(text).empty()) {
    diagnostics.add(place_of(*node), fmt::format("{} is empty", key), std::string(hint));
  }
  return text;
}

std::vector<std::string> read_tags(const toml::table& root, Diagnostics& diagnostics) {
  std::vector<std::string> tags;
  const toml::node* const node = root.get("tags");
  if (node == nullptr) return tags;
  const toml::array* const array = as_array(*node, "tags", "an array of strings", diagnostics);
  if (array == nullptr) return tags;
  for (const toml::node& tag : *array) {
    if (!tag.is_string()) wrong_type(tag, "a tag", "a string", diagnostics);
    tags.push_back(tag.value_or(std::string()));
  }
  return tags;
}

std::vector<OptOut> read_opt_outs(const toml::table& root, Diagnostics& diagnostics) {
  std::vector<OptOut> opt_outs;
  const toml::node* const node = root.get("opt_out");
  const toml::table* const table = node == nullptr ? nullptr : as_table(*node, "opt_out", diagnostics);
  if (table == nullptr) return opt_outs;
  for (const Entry& entry : in_file_order(*table)) {
    const std::string check = entry.name();
    if (std::find(kChecks.begin(), kChecks.end(), check) == kChecks.end()) {
      diagnostics.add(place_of(*entry.key), fmt::format("there is no check \"{}\"", check),
                      fmt::format("the checks are: {}", fmt::join(kChecks, ", ")));
      continue;
    }
    if (!entry.value->is_string()) wrong_type(*entry.value, check, "a string, the reason", diagnostics);
    const std::string reason = entry.value->value_or(std::string());
    if (entry.value->is_string() && trim(reason).empty()) {
      diagnostics.add(place_of(*entry.value), fmt::format("{} is empty", check),
                      "give the reason why the check does not fit this case");
    }
    opt_outs.push_back({.check = check, .reason = reason});
  }
  return opt_outs;
}

}  // namespace

void read_head(const toml::table& root, Diagnostics& diagnostics, Case& head) {
  head.title = read_required(root, "title", "say what is drawn: title = \"...\"", diagnostics);
  head.why = read_required(root, "why", "say what a failure would mean: why = \"...\"", diagnostics);
  head.spec =
      read_required(root, "spec", "name the section of the Vulkan specification: spec = \"...\"", diagnostics);
  head.origin = root.contains("origin") ? read_string(root, "origin", diagnostics) : "constructed";
  head.tags = read_tags(root, diagnostics);
  head.opt_outs = read_opt_outs(root, diagnostics);
}

}  // namespace fillrule::format
