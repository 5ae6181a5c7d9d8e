#include "reference/vulkan/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fillrule::vulkan {
namespace {

// False for NaN.
bool is_between(float value, float low, float high) {
  return value >= low && value <= high;
}

Result<void> check_target(const DeviceInfo& device, const Target& target) {
  if (target.width == 0 || target.height == 0) {
    return failure(fmt::format("target.size: {} x {} pixels is empty", target.width, target.height));
  }
  if (std::max(target.width, target.height) > device.max_target_size) {
    return failure(fmt::format("target.size: {} x {} pixels is beyond the {} pixels that {} can draw to",
                               target.width, target.height, device.max_target_size, device.driver),
                   "make the target smaller, or choose another reference");
  }
  if (target.samples != VK_SAMPLE_COUNT_1_BIT) {
    return failure(fmt::format("target.samples: the Vulkan reference draws 1 sample per pixel, not {}",
                               static_cast<uint32_t>(target.samples)));
  }
  if (target.depth_format != VK_FORMAT_D32_SFLOAT && target.depth_format != VK_FORMAT_UNDEFINED) {
    return failure("target.depth_format: the Vulkan reference draws with D32_SFLOAT or without depth");
  }
  if (!is_between(target.clear_depth, 0.0F, 1.0F)) {
    return failure(fmt::format("target.clear_depth: {} is outside [0, 1]", target.clear_depth));
  }
  return {};
}

Result<void> check_viewport(const DeviceInfo& device, const VkViewport& viewport) {
  const auto max_width = static_cast<float>(device.max_viewport_size[0]);
  const auto max_height = static_cast<float>(device.max_viewport_size[1]);
  if (!(viewport.width > 0.0F && viewport.width <= max_width) || !(std::abs(viewport.height) <= max_height)) {
    return failure(fmt::format("viewport: {} x {} pixels; {} takes a width above 0 and at most {} x {}",
                               viewport.width, viewport.height, device.driver, max_width, max_height));
  }
  const auto [low, high] = device.viewport_bounds;
  if (!is_between(viewport.x, low, high) || !is_between(viewport.x + viewport.width, low, high) ||
      !is_between(viewport.y, low, high) || !is_between(viewport.y + viewport.height, low, high)) {
    return failure(fmt::format("viewport: ({}, {}) to ({}, {}) is not within [{}, {}], the bounds of {}", viewport.x,
                               viewport.y, viewport.x + viewport.width, viewport.y + viewport.height, low, high,
                               device.driver));
  }
  if (!is_between(viewport.minDepth, 0.0F, 1.0F) || !is_between(viewport.maxDepth, 0.0F, 1.0F)) {
    return failure(
        fmt::format("viewport: the depth range {} to {} is not within [0, 1]", viewport.minDepth, viewport.maxDepth));
  }
  return {};
}

Result<void> check_scissor(const VkRect2D& scissor) {
  if (scissor.offset.x < 0 || scissor.offset.y < 0 || int64_t{scissor.offset.x} + scissor.extent.width > INT32_MAX ||
      int64_t{scissor.offset.y} + scissor.extent.height > INT32_MAX) {
    return failure(
        fmt::format("scissor: {} x {} pixels at ({}, {}): Vulkan takes no negative offset, and an end "
                    "below 2^31",
                    scissor.extent.width, scissor.extent.height, scissor.offset.x, scissor.offset.y));
  }
  return {};
}

Result<void> check_vertices(const Draw& draw, uint32_t components) {
  if (draw.topology != VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST && draw.topology != VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP &&
      draw.topology != VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN) {
    return failure("topology: the Vulkan reference draws triangle lists, strips and fans");
  }
  if (draw.varyings.size() != draw.positions.size() * components) {
    return failure(fmt::format("vertices: {} varying components for {} vertices of {} each", draw.varyings.size(),
                               draw.positions.size(), components));
  }
  if (!draw.indices) return {};
  const auto beyond =
      std::ranges::find_if(*draw.indices, [&](uint32_t index) { return index >= draw.positions.size(); });
  if (beyond != draw.indices->end()) {
    return failure(fmt::format("indices: {} is beyond the last of {} vertices", *beyond, draw.positions.size()));
  }
  return {};
}

}  // namespace

Result<void> check_case(const DeviceInfo& device, const Case& drawn) {
  const FeatureSet missing = features_of(drawn).without(device.features);
  if (!missing.empty()) return failure(fmt::format("{} lacks {}", device.driver, to_string(missing)));
  if (auto checked = check_target(device, drawn.target); !checked) return checked;
  if (drawn.varyings.size() > kMaxVaryings) {
    return failure(fmt::format("varyings: {} are more than {}", drawn.varyings.size(), kMaxVaryings));
  }
  const uint32_t components = component_count(drawn.varyings);
  for (const Draw& draw : drawn.draws) {
    if (auto checked = check_viewport(device, draw.state.viewport); !checked) return checked;
    if (auto checked = check_scissor(draw.state.scissor); !checked) return checked;
    if (auto checked = check_vertices(draw, components); !checked) return checked;
  }
  return {};
}

}  // namespace fillrule::vulkan
