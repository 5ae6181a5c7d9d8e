// State that a device lets each draw set for itself beyond what Vulkan 1.3 does, so that draws share pipelines: a new
// pipeline costs lavapipe tens of milliseconds. Vulkan specification, "Dynamic State",
// VK_EXT_extended_dynamic_state3.
#pragma once

#include <vulkan/vulkan_core.h>

#include <span>

#include "reference/vulkan/pipeline_key.h"

namespace fillrule::vulkan {

class Device;

// All of the states below, or none of them where the device lacks one.
class DynamicState {
 public:
  DynamicState() = default;
  explicit DynamicState(const Device& device);

  [[nodiscard]] std::span<const VkDynamicState> states() const;
  // The key with all that set() sets at its default.
  [[nodiscard]] PipelineKey without(PipelineKey key) const;
  void set(VkCommandBuffer commands, const PipelineKey& key) const;

 private:
  bool available_ = false;
  PFN_vkCmdSetDepthClampEnableEXT set_depth_clamp_ = nullptr;
  PFN_vkCmdSetDepthClipEnableEXT set_depth_clip_ = nullptr;
  PFN_vkCmdSetDepthClipNegativeOneToOneEXT set_negative_one_to_one_ = nullptr;
  PFN_vkCmdSetPolygonModeEXT set_polygon_mode_ = nullptr;
  PFN_vkCmdSetLineRasterizationModeEXT set_line_mode_ = nullptr;
  PFN_vkCmdSetProvokingVertexModeEXT set_provoking_vertex_ = nullptr;
  PFN_vkCmdSetSampleMaskEXT set_sample_mask_ = nullptr;
};

}  // namespace fillrule::vulkan
