// The fixed-function state around the program's stages. Vulkan specification, "Graphics Pipelines", "Dynamic State".
#pragma once

#include <cstdint>
#include <span>

#include "reference/vulkan/device.h"
#include "reference/vulkan/pipeline_key.h"

namespace fillrule::vulkan {

// Vertex buffer bindings: positions, slots, and floats beside them (point size, clip and cull distances). The strides
// are dynamic.
inline constexpr uint32_t kPositionBinding = 0;
inline constexpr uint32_t kSlotBinding = 1;
inline constexpr uint32_t kExtraBinding = 2;
inline constexpr uint32_t kBindings = 3;
inline constexpr uint32_t kVec4Bytes = 16;

// The floats of kExtraBinding for each vertex.
uint32_t extra_count(const PipelineKey& key);

// The key's needs must be among the device's features. `dynamic` is what draws set besides the state that is dynamic
// on every device.
Result<Pipeline> create_graphics_pipeline(VkDevice device, VkPipelineLayout layout, const PipelineKey& key,
                                          std::span<const VkDynamicState> dynamic, VkShaderModule vertex,
                                          VkShaderModule fragment);

}  // namespace fillrule::vulkan
