#include "reference/vulkan/features.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "reference/vulkan/targets.h"

namespace fillrule::vulkan {
namespace {

// Of the core features, those that cases or the reference itself need.
VkPhysicalDeviceFeatures used(const VkPhysicalDeviceFeatures& offered) {
  return {.fullDrawIndexUint32 = offered.fullDrawIndexUint32,
          .independentBlend = offered.independentBlend,
          .geometryShader = offered.geometryShader,
          .sampleRateShading = offered.sampleRateShading,
          .depthClamp = offered.depthClamp,
          .depthBiasClamp = offered.depthBiasClamp,
          .fillModeNonSolid = offered.fillModeNonSolid,
          .depthBounds = offered.depthBounds,
          .wideLines = offered.wideLines,
          .largePoints = offered.largePoints,
          .shaderClipDistance = offered.shaderClipDistance,
          .shaderCullDistance = offered.shaderCullDistance};
}

// The same of what draws may set by themselves.
VkPhysicalDeviceExtendedDynamicState3FeaturesEXT used(
    const VkPhysicalDeviceExtendedDynamicState3FeaturesEXT& offered) {
  return {.sType = offered.sType,
          .pNext = offered.pNext,
          .extendedDynamicState3DepthClampEnable = offered.extendedDynamicState3DepthClampEnable,
          .extendedDynamicState3PolygonMode = offered.extendedDynamicState3PolygonMode,
          .extendedDynamicState3SampleMask = offered.extendedDynamicState3SampleMask,
          .extendedDynamicState3DepthClipEnable = offered.extendedDynamicState3DepthClipEnable,
          .extendedDynamicState3ProvokingVertexMode = offered.extendedDynamicState3ProvokingVertexMode,
          .extendedDynamicState3LineRasterizationMode = offered.extendedDynamicState3LineRasterizationMode,
          .extendedDynamicState3DepthClipNegativeOneToOne = offered.extendedDynamicState3DepthClipNegativeOneToOne};
}

// 0 where the format is no attachment that can be read back.
VkSampleCountFlags sample_counts(VkPhysicalDevice device, VkFormat format, VkSampleCountFlagBits wanted) {
  VkImageFormatProperties properties{};
  const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
      device, format, VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL, attachment_usage(format, wanted), 0, &properties);
  return result == VK_SUCCESS ? properties.sampleCounts : 0;
}

}  // namespace

bool has_extension(VkPhysicalDevice device, const char* name) {
  uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
  extensions.resize(count);
  return std::ranges::any_of(
      extensions, [&](const VkExtensionProperties& e) { return std::string_view(e.extensionName) == name; });
}

DeviceFeatures::DeviceFeatures(VkPhysicalDevice device) : device_(device) {
  vkGetPhysicalDeviceProperties(device, &properties_);
  all_.pNext = &vulkan13_;
  add_if_present(VK_EXT_LINE_RASTERIZATION_EXTENSION_NAME, lines_);
  add_if_present(VK_EXT_INDEX_TYPE_UINT8_EXTENSION_NAME, index_type_uint8_);
  add_if_present(VK_EXT_PROVOKING_VERTEX_EXTENSION_NAME, provoking_vertex_);
  add_if_present(VK_EXT_DEPTH_CLIP_ENABLE_EXTENSION_NAME, depth_clip_enable_);
  add_if_present(VK_EXT_DEPTH_CLIP_CONTROL_EXTENSION_NAME, depth_clip_control_);
  add_if_present(VK_EXT_EXTENDED_DYNAMIC_STATE_3_EXTENSION_NAME, dynamic_state3_);
  vkGetPhysicalDeviceFeatures2(device, &all_);

  all_.features = used(all_.features);
  vulkan13_ = {.sType = vulkan13_.sType,
               .pNext = vulkan13_.pNext,
               .synchronization2 = vulkan13_.synchronization2,
               .dynamicRendering = vulkan13_.dynamicRendering,
               .maintenance4 = vulkan13_.maintenance4};
  provoking_vertex_.transformFeedbackPreservesProvokingVertex = VK_FALSE;
  dynamic_state3_ = used(dynamic_state3_);
}

template <typename Structure>
void DeviceFeatures::add_if_present(const char* extension, Structure& structure) {
  if (!has_extension(device_, extension)) return;
  extensions_.push_back(extension);
  structure.pNext = vulkan13_.pNext;
  vulkan13_.pNext = &structure;
}

bool DeviceFeatures::has_dynamic_state() const {
  const auto& offered = dynamic_state3_;
  VkPhysicalDeviceExtendedDynamicState3PropertiesEXT dynamic{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTENDED_DYNAMIC_STATE_3_PROPERTIES_EXT};
  VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &dynamic};
  vkGetPhysicalDeviceProperties2(device_, &properties);
  const std::array needed = {
      // Of any class, whatever the pipeline was made with.
      dynamic.dynamicPrimitiveTopologyUnrestricted,
      // What the states set has to be there too.
      core().depthClamp,
      core().fillModeNonSolid,
      depth_clip_enable_.depthClipEnable,
      depth_clip_control_.depthClipControl,
      provoking_vertex_.provokingVertexLast,
      lines_.rectangularLines,
      offered.extendedDynamicState3DepthClampEnable,
      offered.extendedDynamicState3PolygonMode,
      offered.extendedDynamicState3SampleMask,
      offered.extendedDynamicState3DepthClipEnable,
      offered.extendedDynamicState3ProvokingVertexMode,
      offered.extendedDynamicState3LineRasterizationMode,
      offered.extendedDynamicState3DepthClipNegativeOneToOne,
  };
  return std::ranges::all_of(needed, [](VkBool32 has) { return has == VK_TRUE; });
}

FeatureSet DeviceFeatures::for_cases() const {
  FeatureSet set;
  set.add(Feature::kPoints);
  set.add(Feature::kFragCoord);
  set.add(Feature::kPointCoord);
  set.add(Feature::kPrimitiveRestart);
  set.add(Feature::kSampleMask);
  set.add(Feature::kCentroid);
  if (core().sampleRateShading == VK_TRUE) set.add(Feature::kSampleShading);
  if (index_type_uint8_.indexTypeUint8 == VK_TRUE) set.add(Feature::kIndexTypeUint8);
  if (core().shaderClipDistance == VK_TRUE) set.add(Feature::kClipDistances);
  if (core().shaderCullDistance == VK_TRUE) set.add(Feature::kCullDistances);
  add_lines_and_points(set);
  add_depth(set);
  add_samples(set);
  return set;
}

void DeviceFeatures::add_lines_and_points(FeatureSet& set) const {
  if (lines_.rectangularLines == VK_TRUE) set.add(Feature::kLines);
  if (lines_.bresenhamLines == VK_TRUE) set.add(Feature::kBresenhamLines);
  if (core().wideLines == VK_TRUE) set.add(Feature::kWideLines);
  if (core().largePoints == VK_TRUE) set.add(Feature::kLargePoints);
  if (core().fillModeNonSolid == VK_TRUE) set.add(Feature::kFillModeNonSolid);
  if (provoking_vertex_.provokingVertexLast == VK_TRUE) {
    VkPhysicalDeviceProvokingVertexPropertiesEXT provoking{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROVOKING_VERTEX_PROPERTIES_EXT};
    VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                           .pNext = &provoking};
    vkGetPhysicalDeviceProperties2(device_, &properties);
    // Each draw of a case has its own mode.
    if (provoking.provokingVertexModePerPipeline == VK_TRUE) set.add(Feature::kProvokingVertexLast);
  }
}

void DeviceFeatures::add_depth(FeatureSet& set) const {
  const auto has_format = [&](VkFormat format) { return sample_counts(device_, format, VK_SAMPLE_COUNT_1_BIT) != 0; };
  if (has_format(VK_FORMAT_D16_UNORM)) set.add(Feature::kDepthD16);
  if (has_format(VK_FORMAT_X8_D24_UNORM_PACK32)) set.add(Feature::kDepthX8D24);
  set.add(Feature::kDepthBias);
  if (core().depthBiasClamp == VK_TRUE) set.add(Feature::kDepthBiasClamp);
  if (core().depthBounds == VK_TRUE) set.add(Feature::kDepthBounds);
  if (core().depthClamp == VK_TRUE) set.add(Feature::kDepthClamp);
  // Without clipping, or with both clipping and clamping.
  if (depth_clip_enable_.depthClipEnable == VK_TRUE) set.add(Feature::kDepthClipOff);
  if (depth_clip_control_.depthClipControl == VK_TRUE) set.add(Feature::kNegativeOneToOne);
}

void DeviceFeatures::add_samples(FeatureSet& set) const {
  if (properties_.limits.standardSampleLocations == VK_FALSE) return;
  // What the attachments' formats have in common. framebufferIntegerColorSampleCounts is about all integer formats; a
  // device may do more with this one.
  VkSampleCountFlags counts = ~0U;
  for (const VkFormat format : {kHitsFormat, kOwnerFormat, kSlotFormat, VK_FORMAT_D32_SFLOAT}) {
    counts &= sample_counts(device_, format, VK_SAMPLE_COUNT_4_BIT);
  }
  if ((counts & VK_SAMPLE_COUNT_2_BIT) != 0) set.add(Feature::kSamples2);
  if ((counts & VK_SAMPLE_COUNT_4_BIT) != 0) set.add(Feature::kSamples4);
  if ((counts & VK_SAMPLE_COUNT_8_BIT) != 0) set.add(Feature::kSamples8);
  if ((counts & VK_SAMPLE_COUNT_16_BIT) != 0) set.add(Feature::kSamples16);
}

}  // namespace fillrule::vulkan
