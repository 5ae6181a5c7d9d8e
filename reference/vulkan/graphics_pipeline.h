// The fixed-function state around the program's stages. Vulkan specification, "Graphics Pipelines", "Dynamic State".
#pragma once

#include <cstdint>
#include <span>

#include "reference/vulkan/device.h"
#include "reference/vulkan/pipeline_key.h"

namespace fillrule::vulkan {

// Vertex buffer bindings: positions, slots, point sizes, and user clip and cull distances. The strides are dynamic.
inline constexpr uint32_t kPositionBinding = 0;
inline constexpr uint32_t kSlotBinding = 1;
inline constexpr uint32_t kPointSizeBinding = 2;
inline constexpr uint32_t kDistanceBinding = 3;
inline constexpr uint32_t kBindings = 4;
inline constexpr uint32_t kVec4Bytes = 16;

// The key's needs must be among the device's features. `dynamic` is what draws set besides the state that is dynamic
// on every device.
Result<Pipeline> create_graphics_pipeline(VkDevice device, VkPipelineLayout layout, const PipelineKey& key,
                                          std::span<const VkDynamicState> dynamic, VkShaderModule vertex,
                                          VkShaderModule fragment);

}  // namespace fillrule::vulkan
