#include "reference/vulkan/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "reference/vulkan/pipeline_key.h"

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

// The values of something that each vertex has so many of.
Result<void> check_count(std::string_view what, size_t values, size_t vertices, uint32_t each) {
  if (values == vertices * each) return {};
  return failure(fmt::format("vertices: {} {} for {} vertices of {} each", values, what, vertices, each));
}

Result<void> check_vertices(const Draw& draw, uint32_t components) {
  if (draw.topology > VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN) {
    return failure("topology: the Vulkan reference draws points, lines and triangles");
  }
  const size_t vertices = draw.positions.size();
  Result<void> checked = check_count("varying components", draw.varyings.size(), vertices, components);
  if (checked && !draw.point_sizes.empty()) {
    checked = check_count("point sizes", draw.point_sizes.size(), vertices, 1);
  }
  if (checked) {
    checked = check_count("clip distances", draw.clip_distances.size(), vertices, draw.clip_distance_count);
  }
  if (checked) {
    checked = check_count("cull distances", draw.cull_distances.size(), vertices, draw.cull_distance_count);
  }
  if (checked && draw.clip_distance_count + draw.cull_distance_count > kMaxClipAndCullDistances) {
    return failure(fmt::format("clip_distances: {} and {} cull distances are together more than {}",
                               draw.clip_distance_count, draw.cull_distance_count, kMaxClipAndCullDistances));
  }
  return checked;
}

Result<void> check_indices(const Draw& draw) {
  if (draw.primitive_restart &&
      (draw.topology == VK_PRIMITIVE_TOPOLOGY_POINT_LIST || draw.topology == VK_PRIMITIVE_TOPOLOGY_LINE_LIST ||
       draw.topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST)) {
    return failure("primitive_restart: Vulkan restarts strips and fans, not lists");
  }
  if (!draw.indices) return {};
  const uint32_t largest = restart_index(draw.index_type);
  for (const uint32_t index : *draw.indices) {
    if (draw.primitive_restart && index == largest) continue;
    if (index > largest) {
      return failure(fmt::format("indices: {} is beyond the {} of their type", index, largest));
    }
    const int64_t vertex = int64_t{index} + draw.vertex_offset;
    if (vertex < 0 || vertex >= static_cast<int64_t>(draw.positions.size())) {
      return failure(fmt::format("indices: {} is beyond the last of {} vertices", vertex, draw.positions.size()));
    }
  }
  return {};
}

// Sizes off a device's steps are rounded as it likes.
Result<void> check_size(const DeviceInfo& device, std::string_view key, float size, const SizeRange& range) {
  if (size == 1) return {};
  if (!is_between(size, range.min, range.max)) {
    return failure(
        fmt::format("{}: {} is beyond the {} to {} of {}", key, size, range.min, range.max, device.driver));
  }
  const double steps = range.step == 0 ? 0 : (double{size} - double{range.min}) / double{range.step};
  if (steps != std::floor(steps)) {
    return failure(fmt::format("{}: {} is not in {}'s steps of {}", key, size, device.driver, range.step));
  }
  return {};
}

Result<void> check_sizes(const DeviceInfo& device, const Case& drawn, const Draw& draw) {
  const PipelineKey key = pipeline_key(drawn, draw, {});
  if (key.draws_lines()) {
    if (auto checked = check_size(device, "line_width", draw.state.line_width, device.line_widths); !checked) {
      return checked;
    }
    if (draw.state.line_mode == VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT && key.sample_shading) {
      return failure("line_mode: Vulkan has no Bresenham lines with interpolation at samples");
    }
  }
  if (!key.draws_points()) return {};
  for (const float size : draw.point_sizes) {
    if (auto checked = check_size(device, "point_sizes", size, device.point_sizes); !checked) return checked;
  }
  return {};
}

Result<void> check_depth(const RasterState& state) {
  if (!state.depth_bounds) return {};
  const auto [min, max] = *state.depth_bounds;
  if (is_between(min, 0.0F, 1.0F) && is_between(max, 0.0F, 1.0F)) return {};
  return failure(fmt::format("depth_bounds: {} to {} is not within [0, 1]", min, max));
}

Result<void> check_varyings(const std::vector<Varying>& varyings) {
  if (varyings.size() > kMaxVaryings) {
    return failure(fmt::format("varyings: {} are more than {}", varyings.size(), kMaxVaryings));
  }
  for (const auto& [source, components] :
       {std::pair{VaryingSource::kFragCoord, 4U}, {VaryingSource::kPointCoord, 2U}}) {
    for (const Varying& varying : varyings) {
      if (varying.source != source || varying.components == components) continue;
      return failure(fmt::format("varyings: the built-in of {} has {} components, not {}", varying.name, components,
                                 varying.components));
    }
  }
  return {};
}

}  // namespace

Result<void> check_case(const DeviceInfo& device, const Case& drawn) {
  const FeatureSet missing = features_of(drawn).without(device.features);
  if (!missing.empty()) return failure(fmt::format("{} lacks {}", device.driver, to_string(missing)));
  if (auto checked = check_target(device, drawn.target); !checked) return checked;
  if (auto checked = check_varyings(drawn.varyings); !checked) return checked;
  const uint32_t components = vertex_component_count(drawn.varyings);
  for (const Draw& draw : drawn.draws) {
    if (auto checked = check_viewport(device, draw.state.viewport); !checked) return checked;
    if (auto checked = check_scissor(draw.state.scissor); !checked) return checked;
    if (auto checked = check_depth(draw.state); !checked) return checked;
    if (auto checked = check_vertices(draw, components); !checked) return checked;
    if (auto checked = check_indices(draw); !checked) return checked;
    if (auto checked = check_sizes(device, drawn, draw); !checked) return checked;
  }
  return {};
}

}  // namespace fillrule::vulkan
