#include <fmt/format.h>

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

}  // namespace

void read_head(const toml::table& root, Diagnostics& diagnostics, Case& head) {
  head.title = read_required(root, "title", "say what is drawn: title = \"...\"", diagnostics);
  head.why = read_required(root, "why", "say what a failure would mean: why = \"...\"", diagnostics);
  head.spec =
      read_required(root, "spec", "name the section of the Vulkan specification: spec = \"...\"", diagnostics);
  head.origin = root.contains("origin") ? read_string(root, "origin", diagnostics) : "constructed";
  head.tags = read_tags(root, diagnostics);
}

}  // namespace fillrule::format
