#include <fmt/format.h>

#include <algorithm>

#include "cases/format/sections.h"

namespace fillrule::format {
namespace {

void read_size(const toml::node& node, Values& values, Target& target) {
  const toml::array* const array = as_array(node, "size", "[width, height]", values.diagnostics());
  if (array == nullptr) return;
  if (array->size() != 2) {
    values.diagnostics().add(place_of(node),
                             fmt::format("size must be [width, height], not {} numbers", array->size()));
    return;
  }
  const IntegerRange range{.min = 1, .max = kMaxTargetSize};
  if (const auto width = values.integer(*array->get(0), "width", range)) target.width = static_cast<uint32_t>(*width);
  if (const auto height = values.integer(*array->get(1), "height", range)) {
    target.height = static_cast<uint32_t>(*height);
  }
}

void read_depth_format(const toml::node& node, Values& values, Target& target) {
  const auto name = values.text(node, "depth_format");
  if (!name) return;
  if (const auto format = enum_value(kDepthFormats, *name)) {
    target.depth_format = *format;
    return;
  }
  const bool known = std::find(kUnsupportedDepthFormats.begin(), kUnsupportedDepthFormats.end(), *name) !=
                     kUnsupportedDepthFormats.end();
  values.diagnostics().add(place_of(node),
                           fmt::format("{} \"{}\"{}", known ? "depth_format" : "unknown depth_format", *name,
                                       known ? " is not supported" : ""),
                           fmt::format("supported: {}", fmt::join(enum_names(kDepthFormats), ", ")));
}

// VkSampleCountFlagBits are the numbers themselves.
void read_samples(const toml::node& node, Values& values, Target& target) {
  const auto count = values.integer(node, "samples", {.min = 1, .max = kMaxSamples});
  if (!count) return;
  if ((*count & (*count - 1)) != 0) {
    values.diagnostics().add(place_of(node), fmt::format("samples must be a power of two, not {}", *count),
                             fmt::format("supported: 1, 2, 4, 8, {}", kMaxSamples));
    return;
  }
  target.samples = static_cast<VkSampleCountFlagBits>(*count);
}

void read_clear_depth(const toml::node& node, Values& values, Target& target) {
  const auto depth = values.finite_float32(node, "clear_depth");
  if (!depth) return;
  if (*depth < 0.0F || *depth > 1.0F) {
    values.diagnostics().add(place_of(node), fmt::format("clear_depth must be 0 to 1, not {}", *depth));
    return;
  }
  target.clear_depth = *depth;
}

}  // namespace

Target read_target(const toml::table& root, Values& values) {
  Target target;
  const toml::node* const node = root.get("target");
  if (node == nullptr) return target;
  const toml::table* const table = as_table(*node, "target", values.diagnostics());
  if (table == nullptr) return target;
  check_keys({*table, "[target]"}, {"size", "depth_format", "samples", "clear_depth"}, values.diagnostics());
  if (const toml::node* const size = table->get("size")) read_size(*size, values, target);
  if (const toml::node* const format = table->get("depth_format")) read_depth_format(*format, values, target);
  if (const toml::node* const clear = table->get("clear_depth")) read_clear_depth(*clear, values, target);
  if (const toml::node* const samples = table->get("samples")) read_samples(*samples, values, target);
  return target;
}

}  // namespace fillrule::format
