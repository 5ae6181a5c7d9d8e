// The pipeline of hit_draw.h: positions from a vertex buffer of (x, y), a constant added to an R8_UNORM target for
// each fragment. Vulkan specification, "Graphics Pipelines".
#pragma once

#include <cstdint>

#include "reference/vulkan/device.h"

namespace fillrule::vulkan {

inline constexpr VkFormat kHitCountFormat = VK_FORMAT_R8_UNORM;

struct HitPipeline {
  PipelineLayout layout;
  Pipeline pipeline;
};

// Viewport and scissor are the square target; the cull mode is dynamic.
Result<HitPipeline> create_hit_pipeline(const Device& device, uint32_t target_size);

}  // namespace fillrule::vulkan
