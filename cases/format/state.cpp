#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "cases/format/sections.h"

namespace fillrule::format {
namespace {

constexpr float kMaxViewportSize = 16384.0F;
// viewportBoundsRange of a device with viewports of that size.
constexpr float kMinViewportBound = -32768.0F;
constexpr float kMaxViewportBound = 32767.0F;

VkViewport whole_viewport(const Target& target) {
  return {.x = 0.0F,
          .y = 0.0F,
          .width = static_cast<float>(target.width),
          .height = static_cast<float>(target.height),
          .minDepth = 0.0F,
          .maxDepth = 1.0F};
}

void check_extent(const toml::node& node, std::string_view axis, float begin, float extent, Values& values) {
  const bool bounded =
      std::fmin(begin, begin + extent) >= kMinViewportBound && std::fmax(begin, begin + extent) <= kMaxViewportBound;
  if (bounded) return;
  values.diagnostics().add(place_of(node),
                           fmt::format("viewport reaches from {} = {} to {}", axis, begin, begin + extent),
                           fmt::format("Vulkan's bounds are {} to {}", kMinViewportBound, kMaxViewportBound));
}

VkViewport read_viewport(const toml::node& node, const Target& target, Values& values) {
  VkViewport viewport = whole_viewport(target);
  const toml::table* const table = as_table(node, "viewport", values.diagnostics());
  if (table == nullptr) return viewport;
  check_keys({*table, "viewport"}, {"x", "y", "width", "height", "min_depth", "max_depth"}, values.diagnostics());
  // False if the key is there with a number that will not do.
  const auto read = [&](std::string_view key, auto is_good, std::string_view range, float& value) {
    const toml::node* const node_of_key = table->get(key);
    if (node_of_key == nullptr) return true;
    const auto number = values.finite_float32(*node_of_key, fmt::format("viewport {}", key));
    if (!number) return false;
    if (!is_good(*number)) {
      values.diagnostics().add(place_of(*node_of_key),
                               fmt::format("viewport {} must be {}, not {}", key, range, *number));
      return false;
    }
    value = *number;
    return true;
  };
  const auto in_bounds = [](float x) { return x >= kMinViewportBound && x <= kMaxViewportBound; };
  const auto is_width = [](float x) { return x > 0.0F && x <= kMaxViewportSize; };
  const auto is_height = [](float x) { return x != 0.0F && std::fabs(x) <= kMaxViewportSize; };
  const auto is_depth = [](float x) { return x >= 0.0F && x <= 1.0F; };
  const bool x_good = read("x", in_bounds, "-32768 to 32767", viewport.x);
  const bool y_good = read("y", in_bounds, "-32768 to 32767", viewport.y);
  const bool width_good = read("width", is_width, "above 0 and up to 16384", viewport.width);
  const bool height_good = read("height", is_height, "-16384 to 16384 and not 0", viewport.height);
  read("min_depth", is_depth, "0 to 1", viewport.minDepth);
  read("max_depth", is_depth, "0 to 1", viewport.maxDepth);
  if (x_good && width_good) check_extent(node, "x", viewport.x, viewport.width, values);
  if (y_good && height_good) check_extent(node, "y", viewport.y, viewport.height, values);
  return viewport;
}

VkRect2D read_scissor(const toml::node& node, const Target& target, Values& values) {
  VkRect2D scissor{.offset = {.x = 0, .y = 0}, .extent = {.width = target.width, .height = target.height}};
  const toml::table* const table = as_table(node, "scissor", values.diagnostics());
  if (table == nullptr) return scissor;
  check_keys({*table, "scissor"}, {"x", "y", "width", "height"}, values.diagnostics());
  constexpr int64_t kMaxInt32 = std::numeric_limits<int32_t>::max();
  // Vulkan: the offset is not negative and offset + extent does not overflow int32.
  const auto read = [&](std::string_view key, int64_t fallback) {
    const toml::node* const number = table->get(key);
    if (number == nullptr) return fallback;
    return values.integer(*number, fmt::format("scissor {}", key), {.min = 0, .max = kMaxInt32}).value_or(fallback);
  };
  const int64_t x = read("x", 0);
  const int64_t y = read("y", 0);
  scissor.offset = {.x = static_cast<int32_t>(x), .y = static_cast<int32_t>(y)};
  scissor.extent = {.width = static_cast<uint32_t>(read("width", scissor.extent.width)),
                    .height = static_cast<uint32_t>(read("height", scissor.extent.height))};
  if (x + int64_t{scissor.extent.width} > kMaxInt32 || y + int64_t{scissor.extent.height} > kMaxInt32) {
    values.diagnostics().add(place_of(node), "scissor ends beyond the range of int32",
                             "Vulkan demands x + width and y + height up to 2147483647");
  }
  return scissor;
}

}  // namespace

RasterState default_state(const Target& target) {
  return RasterState{
      .viewport = whole_viewport(target),
      .scissor = {.offset = {.x = 0, .y = 0}, .extent = {.width = target.width, .height = target.height}}};
}

void read_state(const Section& section, const Target& target, Values& values, RasterState& state) {
  check_keys(section,
             {"cull_mode", "front_face", "depth_test", "depth_write", "depth_compare", "viewport", "scissor"},
             values.diagnostics());
  const auto read = [&](std::string_view key, auto read_node) {
    if (const toml::node* const node = section.table.get(key)) read_node(*node, key);
  };
  const auto read_enumerator = [&](const auto& names, auto& field) {
    return [&](const toml::node& node, std::string_view key) {
      field = values.enumerator(node, key, names).value_or(field);
    };
  };
  const auto read_boolean = [&](bool& field) {
    return [&](const toml::node& node, std::string_view key) { field = values.boolean(node, key).value_or(field); };
  };
  read("cull_mode", read_enumerator(kCullModes, state.cull_mode));
  read("front_face", read_enumerator(kFrontFaces, state.front_face));
  read("depth_test", read_boolean(state.depth_test));
  read("depth_write", read_boolean(state.depth_write));
  read("depth_compare", read_enumerator(kCompareOps, state.depth_compare));
  read("viewport", [&](const toml::node& node, auto) { state.viewport = read_viewport(node, target, values); });
  read("scissor", [&](const toml::node& node, auto) { state.scissor = read_scissor(node, target, values); });
}

}  // namespace fillrule::format
