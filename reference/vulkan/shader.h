// GLSL to SPIR-V, by the glslang library, and to shader modules.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <string>
#include <vector>

#include "cases/model/result.h"
#include "reference/vulkan/handles.h"

namespace fillrule::vulkan {

// Compiles one stage for Vulkan 1.3. `defines` is put behind the #version line. glslang's own text is the error's.
Result<std::vector<uint32_t>> compile_glsl(VkShaderStageFlagBits stage, const std::string& glsl,
                                           const std::string& defines);

// The same as a module of the device, which must outlive it.
Result<ShaderModule> create_shader(VkDevice device, VkShaderStageFlagBits stage, const std::string& glsl,
                                   const std::string& defines);

}  // namespace fillrule::vulkan
