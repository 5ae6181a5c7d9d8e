#include "reference/vulkan/pipeline_key.h"

#include <algorithm>

namespace fillrule::vulkan {
namespace {

VkPrimitiveTopology class_of(VkPrimitiveTopology topology) {
  switch (topology) {
    case VK_PRIMITIVE_TOPOLOGY_POINT_LIST:
      return VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
    case VK_PRIMITIVE_TOPOLOGY_LINE_LIST:
    case VK_PRIMITIVE_TOPOLOGY_LINE_STRIP:
      return VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
    default:
      return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  }
}

}  // namespace

bool PipelineKey::draws_points() const {
  return topology_class == VK_PRIMITIVE_TOPOLOGY_POINT_LIST || polygon_mode == VK_POLYGON_MODE_POINT;
}

bool PipelineKey::draws_lines() const {
  return topology_class == VK_PRIMITIVE_TOPOLOGY_LINE_LIST || polygon_mode == VK_POLYGON_MODE_LINE;
}

bool has_sample_shading(const Case& drawn) {
  return std::ranges::any_of(drawn.varyings,
                             [](const Varying& varying) { return varying.sampling == Sampling::kSample; });
}

PipelineKey pipeline_key(const Case& drawn, const Draw& draw, const SlotRange& slots) {
  const RasterState& state = draw.state;
  PipelineKey key{.slots = slots.counts,
                  .outputs = slots.outputs,
                  .topology_class = class_of(draw.topology),
                  .provoking_vertex = state.provoking_vertex,
                  .depth_clamp = state.depth_clamp,
                  .depth_clip = state.depth_clip,
                  .negative_one_to_one = state.negative_one_to_one,
                  .clip_distances = draw.clip_distance_count,
                  .cull_distances = draw.cull_distance_count,
                  .depth_format = drawn.target.depth_format,
                  .samples = drawn.target.samples,
                  .sample_mask = state.sample_mask & ((1U << drawn.target.samples) - 1),
                  .sample_shading = has_sample_shading(drawn)};
  if (key.topology_class == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST) key.polygon_mode = state.polygon_mode;
  if (key.draws_lines()) key.line_mode = state.line_mode;
  return key;
}

}  // namespace fillrule::vulkan
