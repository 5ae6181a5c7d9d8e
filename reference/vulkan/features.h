// What a device can do beyond what every case needs, as it says itself, and the switches for it. Vulkan
// specification, "Features", "Limits", "Formats".
#pragma once

#include <vulkan/vulkan_core.h>

#include <vector>

#include "cases/model/features.h"

namespace fillrule::vulkan {

// The device's answer to vkGetPhysicalDeviceFeatures2, cut to what cases ask for; structures of extensions that the
// device lacks stay unset. They point to each other, so it never moves.
class DeviceFeatures {
 public:
  // The device must have Vulkan 1.3.
  explicit DeviceFeatures(VkPhysicalDevice device);
  DeviceFeatures(const DeviceFeatures&) = delete;
  DeviceFeatures(DeviceFeatures&&) = delete;
  DeviceFeatures& operator=(const DeviceFeatures&) = delete;
  DeviceFeatures& operator=(DeviceFeatures&&) = delete;
  ~DeviceFeatures() = default;

  [[nodiscard]] const VkPhysicalDeviceFeatures& core() const { return all_.features; }
  [[nodiscard]] const VkPhysicalDeviceVulkan13Features& vulkan13() const { return vulkan13_; }
  // For VkDeviceCreateInfo: everything here, switched on.
  [[nodiscard]] const VkPhysicalDeviceFeatures2& chain() const { return all_; }
  [[nodiscard]] const std::vector<const char*>& extensions() const { return extensions_; }
  // Whether every state of DynamicState is dynamic.
  [[nodiscard]] bool has_dynamic_state() const;
  // What cases may ask of the device.
  [[nodiscard]] FeatureSet for_cases() const;

 private:
  template <typename Structure>
  void add_if_present(const char* extension, Structure& structure);
  void add_lines_and_points(FeatureSet& set) const;
  void add_depth(FeatureSet& set) const;
  void add_samples(FeatureSet& set) const;

  VkPhysicalDevice device_;
  VkPhysicalDeviceProperties properties_{};
  VkPhysicalDeviceFeatures2 all_{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  VkPhysicalDeviceVulkan13Features vulkan13_{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceLineRasterizationFeaturesEXT lines_{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_LINE_RASTERIZATION_FEATURES_EXT};
  VkPhysicalDeviceIndexTypeUint8FeaturesEXT index_type_uint8_{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_INDEX_TYPE_UINT8_FEATURES_EXT};
  VkPhysicalDeviceProvokingVertexFeaturesEXT provoking_vertex_{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROVOKING_VERTEX_FEATURES_EXT};
  VkPhysicalDeviceDepthClipEnableFeaturesEXT depth_clip_enable_{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DEPTH_CLIP_ENABLE_FEATURES_EXT};
  VkPhysicalDeviceDepthClipControlFeaturesEXT depth_clip_control_{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DEPTH_CLIP_CONTROL_FEATURES_EXT};
  VkPhysicalDeviceExtendedDynamicState3FeaturesEXT dynamic_state3_{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTENDED_DYNAMIC_STATE_3_FEATURES_EXT};
  std::vector<const char*> extensions_;
};

bool has_extension(VkPhysicalDevice device, const char* name);

}  // namespace fillrule::vulkan
