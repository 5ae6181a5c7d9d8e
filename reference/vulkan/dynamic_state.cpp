#include "reference/vulkan/dynamic_state.h"

#include <array>

#include "reference/vulkan/device.h"

namespace fillrule::vulkan {
namespace {

constexpr std::array kStates = {
    VK_DYNAMIC_STATE_DEPTH_CLAMP_ENABLE_EXT,
    VK_DYNAMIC_STATE_DEPTH_CLIP_ENABLE_EXT,
    VK_DYNAMIC_STATE_DEPTH_CLIP_NEGATIVE_ONE_TO_ONE_EXT,
    VK_DYNAMIC_STATE_POLYGON_MODE_EXT,
    VK_DYNAMIC_STATE_LINE_RASTERIZATION_MODE_EXT,
    VK_DYNAMIC_STATE_PROVOKING_VERTEX_MODE_EXT,
    VK_DYNAMIC_STATE_SAMPLE_MASK_EXT,
};

VkBool32 flag(bool value) {
  return value ? VK_TRUE : VK_FALSE;
}

}  // namespace

DynamicState::DynamicState(const Device& device) : available_(device.has_dynamic_state()) {
  if (!available_) return;
  const auto load = [&device](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(vkGetDeviceProcAddr(device.get(), name));
  };
  load(set_depth_clamp_, "vkCmdSetDepthClampEnableEXT");
  load(set_depth_clip_, "vkCmdSetDepthClipEnableEXT");
  load(set_negative_one_to_one_, "vkCmdSetDepthClipNegativeOneToOneEXT");
  load(set_polygon_mode_, "vkCmdSetPolygonModeEXT");
  load(set_line_mode_, "vkCmdSetLineRasterizationModeEXT");
  load(set_provoking_vertex_, "vkCmdSetProvokingVertexModeEXT");
  load(set_sample_mask_, "vkCmdSetSampleMaskEXT");
}

std::span<const VkDynamicState> DynamicState::states() const {
  if (!available_) return {};
  return kStates;
}

PipelineKey DynamicState::without(PipelineKey key) const {
  if (!available_) return key;
  const PipelineKey plain;
  key.depth_clamp = plain.depth_clamp;
  key.depth_clip = plain.depth_clip;
  key.negative_one_to_one = plain.negative_one_to_one;
  key.line_mode = plain.line_mode;
  key.provoking_vertex = plain.provoking_vertex;
  key.sample_mask = plain.sample_mask;
  key.topology_class = plain.topology_class;
  key.polygon_mode = plain.polygon_mode;
  return key;
}

void DynamicState::set(VkCommandBuffer commands, const PipelineKey& key) const {
  if (!available_) return;
  set_depth_clamp_(commands, flag(key.depth_clamp));
  set_depth_clip_(commands, flag(key.depth_clip));
  set_negative_one_to_one_(commands, flag(key.negative_one_to_one));
  set_polygon_mode_(commands, key.polygon_mode);
  set_line_mode_(commands, key.line_mode);
  set_provoking_vertex_(commands, key.provoking_vertex);
  set_sample_mask_(commands, key.samples, &key.sample_mask);
}

}  // namespace fillrule::vulkan
