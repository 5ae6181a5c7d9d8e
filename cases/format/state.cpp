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
  const bool height_good = read("height", is_height, "nonzero, from -16384 to 16384", viewport.height);
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

DepthBias read_depth_bias(const toml::node& node, Values& values) {
  DepthBias bias;
  const toml::table* const table = as_table(node, "depth_bias", values.diagnostics());
  if (table == nullptr) return bias;
  check_keys({*table, "depth_bias"}, {"constant", "slope", "clamp"}, values.diagnostics());
  const auto read = [&](std::string_view key, float& field) {
    const toml::node* const number = table->get(key);
    if (number == nullptr) return;
    field = values.finite_float32(*number, fmt::format("depth_bias {}", key)).value_or(field);
  };
  read("constant", bias.constant_factor);
  read("slope", bias.slope_factor);
  read("clamp", bias.clamp);
  return bias;
}

DepthBounds read_depth_bounds(const toml::node& node, Values& values) {
  DepthBounds bounds;
  const toml::table* const table = as_table(node, "depth_bounds", values.diagnostics());
  if (table == nullptr) return bounds;
  check_keys({*table, "depth_bounds"}, {"min", "max"}, values.diagnostics());
  const auto read = [&](std::string_view key, float& field) {
    const toml::node* const number = table->get(key);
    if (number == nullptr) return;
    const auto bound = values.finite_float32(*number, fmt::format("depth_bounds {}", key));
    if (bound && (*bound < 0.0F || *bound > 1.0F)) {
      values.diagnostics().add(place_of(*number), fmt::format("depth_bounds {} must be 0 to 1, not {}", key, *bound));
    } else {
      field = bound.value_or(field);
    }
  };
  read("min", bounds.min);
  read("max", bounds.max);
  if (bounds.min > bounds.max) {
    values.diagnostics().add(place_of(node),
                             fmt::format("depth_bounds: min {} is above max {}", bounds.min, bounds.max),
                             "no fragment could pass");
  }
  return bounds;
}

void read_line_width(const toml::node& node, Values& values, float& width) {
  const auto number = values.finite_float32(node, "line_width");
  if (!number) return;
  if (*number <= 0.0F) {
    values.diagnostics().add(place_of(node), fmt::format("line_width must be above 0, not {}", *number));
    return;
  }
  width = *number;
}

void read_depth_state(const toml::table& table, Values& values, RasterState& state) {
  if (const toml::node* const node = table.get("depth_bias")) state.depth_bias = read_depth_bias(*node, values);
  if (const toml::node* const node = table.get("depth_bounds")) state.depth_bounds = read_depth_bounds(*node, values);
  if (const toml::node* const node = table.get("depth_clamp")) {
    state.depth_clamp = values.boolean(*node, "depth_clamp").value_or(state.depth_clamp);
    // What Vulkan does where nothing is said about clipping.
    state.depth_clip = !state.depth_clamp;
  }
  if (const toml::node* const node = table.get("depth_clip")) {
    state.depth_clip = values.boolean(*node, "depth_clip").value_or(state.depth_clip);
  }
}

}  // namespace

RasterState default_state(const Target& target) {
  return RasterState{
      .viewport = whole_viewport(target),
      .scissor = {.offset = {.x = 0, .y = 0}, .extent = {.width = target.width, .height = target.height}}};
}

void read_state(const Section& section, const Target& target, Values& values, RasterState& state) {
  check_keys(section,
             {"cull_mode", "front_face", "depth_test", "depth_write", "depth_compare", "depth_bias", "depth_bounds",
              "depth_clamp", "depth_clip", "negative_one_to_one", "polygon_mode", "line_mode", "line_width",
              "provoking_vertex", "sample_mask", "viewport", "scissor"},
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
  read_depth_state(section.table, values, state);
  read("negative_one_to_one", read_boolean(state.negative_one_to_one));
  read("polygon_mode", read_enumerator(kPolygonModes, state.polygon_mode));
  read("line_mode", read_enumerator(kLineModes, state.line_mode));
  read("line_width", [&](const toml::node& node, auto) { read_line_width(node, values, state.line_width); });
  read("provoking_vertex", read_enumerator(kProvokingVertices, state.provoking_vertex));
  read("sample_mask", [&](const toml::node& node, std::string_view key) {
    const auto mask = values.integer(node, key, {.min = 0, .max = std::numeric_limits<uint32_t>::max()});
    state.sample_mask = static_cast<uint32_t>(mask.value_or(state.sample_mask));
  });
  read("viewport", [&](const toml::node& node, auto) { state.viewport = read_viewport(node, target, values); });
  read("scissor", [&](const toml::node& node, auto) { state.scissor = read_scissor(node, target, values); });
}

}  // namespace fillrule::format
