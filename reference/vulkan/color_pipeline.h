// The pipeline of color_draw.h: positions and attributes from two vertex buffers, RGBA8 and D32F with LESS.
// Vulkan specification, "Graphics Pipelines".
#pragma once

#include "reference/vulkan/color_draw.h"
#include "reference/vulkan/device.h"

namespace fillrule::vulkan {

inline constexpr VkFormat kColorFormat = VK_FORMAT_R8G8B8A8_UNORM;
inline constexpr VkFormat kColorDepthFormat = VK_FORMAT_D32_SFLOAT;

struct ColorPipeline {
  PipelineLayout layout;
  Pipeline pipeline;
};

// Vertex buffer 0 holds the positions, 1 the attributes. Viewport and scissor are the square target.
Result<ColorPipeline> create_color_pipeline(const Device& device, const ColorScene& scene);

}  // namespace fillrule::vulkan
