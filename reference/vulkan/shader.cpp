#include "reference/vulkan/shader.h"

#include <fmt/format.h>
// glslang's C interface, since its classes come without the type information that the sanitizers ask for.
#include <glslang/Include/glslang_c_interface.h>
#include <glslang/Public/resource_limits_c.h>

#include <algorithm>
#include <array>
#include <memory>

namespace fillrule::vulkan {
namespace {

struct ShaderDelete {
  void operator()(glslang_shader_t* shader) const { glslang_shader_delete(shader); }
};
struct ProgramDelete {
  void operator()(glslang_program_t* program) const { glslang_program_delete(program); }
};
using GlslangShader = std::unique_ptr<glslang_shader_t, ShaderDelete>;
using GlslangProgram = std::unique_ptr<glslang_program_t, ProgramDelete>;

// glslang wants one call of each for a process.
class GlslangProcess {
 public:
  GlslangProcess() { glslang_initialize_process(); }
  ~GlslangProcess() { glslang_finalize_process(); }
  GlslangProcess(const GlslangProcess&) = delete;
  GlslangProcess(GlslangProcess&&) = delete;
  GlslangProcess& operator=(const GlslangProcess&) = delete;
  GlslangProcess& operator=(GlslangProcess&&) = delete;
};

struct Stage {
  VkShaderStageFlagBits vulkan;
  glslang_stage_t glslang;
  const char* name;
};
constexpr std::array kStages = {
    Stage{VK_SHADER_STAGE_VERTEX_BIT, GLSLANG_STAGE_VERTEX, "vertex"},
    Stage{VK_SHADER_STAGE_FRAGMENT_BIT, GLSLANG_STAGE_FRAGMENT, "fragment"},
    Stage{VK_SHADER_STAGE_COMPUTE_BIT, GLSLANG_STAGE_COMPUTE, "compute"},
};

}  // namespace

Result<std::vector<uint32_t>> compile_glsl(VkShaderStageFlagBits stage, const std::string& glsl,
                                           const std::string& defines) {
  static const GlslangProcess process;
  const Stage& kind = *std::ranges::find(kStages, stage, &Stage::vulkan);
  const char* const stage_name = kind.name;
  const int rules = GLSLANG_MSG_SPV_RULES_BIT | GLSLANG_MSG_VULKAN_RULES_BIT;
  const glslang_input_t input{.language = GLSLANG_SOURCE_GLSL,
                              .stage = kind.glslang,
                              .client = GLSLANG_CLIENT_VULKAN,
                              .client_version = GLSLANG_TARGET_VULKAN_1_3,
                              .target_language = GLSLANG_TARGET_SPV,
                              .target_language_version = GLSLANG_TARGET_SPV_1_6,
                              .code = glsl.c_str(),
                              .default_version = 450,
                              .default_profile = GLSLANG_NO_PROFILE,
                              .messages = static_cast<glslang_messages_t>(rules),
                              .resource = glslang_default_resource()};
  const GlslangShader shader(glslang_shader_create(&input));
  if (!shader) return failure(fmt::format("glslang cannot make a {} shader", stage_name));
  glslang_shader_set_preamble(shader.get(), defines.c_str());
  if (glslang_shader_preprocess(shader.get(), &input) == 0 || glslang_shader_parse(shader.get(), &input) == 0) {
    return failure(
        fmt::format("the {} shader does not compile: {}", stage_name, glslang_shader_get_info_log(shader.get())));
  }
  const GlslangProgram program(glslang_program_create());
  glslang_program_add_shader(program.get(), shader.get());
  if (glslang_program_link(program.get(), rules) == 0) {
    return failure(
        fmt::format("the {} shader does not link: {}", stage_name, glslang_program_get_info_log(program.get())));
  }
  glslang_program_SPIRV_generate(program.get(), input.stage);
  std::vector<uint32_t> spirv(glslang_program_SPIRV_get_size(program.get()));
  glslang_program_SPIRV_get(program.get(), spirv.data());
  return spirv;
}

Result<ShaderModule> create_shader(VkDevice device, VkShaderStageFlagBits stage, const std::string& glsl,
                                   const std::string& defines) {
  const auto spirv = compile_glsl(stage, glsl, defines);
  if (!spirv) return tl::unexpected(spirv.error());
  const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                      .codeSize = spirv->size() * sizeof(uint32_t),
                                      .pCode = spirv->data()};
  VkShaderModule module = VK_NULL_HANDLE;
  const VkResult result = vkCreateShaderModule(device, &info, nullptr, &module);
  if (result != VK_SUCCESS) return failed_call("vkCreateShaderModule", result);
  return ShaderModule(device, module);
}

}  // namespace fillrule::vulkan
