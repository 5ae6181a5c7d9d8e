#include "reference/vulkan/hit_pipeline.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "reference/vulkan/hit_draw.h"
#include "reference/vulkan/shader.h"

namespace fillrule::vulkan {
namespace {

constexpr const char* kVertexGlsl = R"(#version 450
layout(location = 0) in vec2 pos_clip;
void main() {
  gl_Position = vec4(pos_clip, 0.5, 1.0);
}
)";

// FRONT and BACK are what a fragment adds, of 255.
constexpr const char* kFragmentGlsl = R"(#version 450
layout(location = 0) out float hit;
void main() {
  hit = (gl_FrontFacing ? FRONT : BACK) / 255.0;
}
)";

Result<ShaderModule> compile(const Device& device, VkShaderStageFlagBits stage, const char* glsl) {
  const std::string defines =
      fmt::format("#define FRONT {}.0\n#define BACK {}.0\n", uint32_t{kFrontHit}, uint32_t{kHit});
  return create_shader(device.get(), stage, glsl, defines);
}

Result<Pipeline> create_pipeline(VkDevice device, VkPipelineLayout layout, uint32_t target_size,
                                 VkShaderModule vertex, VkShaderModule fragment) {
  const std::array stages = {
      VkPipelineShaderStageCreateInfo{.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                      .stage = VK_SHADER_STAGE_VERTEX_BIT,
                                      .module = vertex,
                                      .pName = "main"},
      VkPipelineShaderStageCreateInfo{.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                      .stage = VK_SHADER_STAGE_FRAGMENT_BIT,
                                      .module = fragment,
                                      .pName = "main"}};
  const VkVertexInputBindingDescription binding{.stride = sizeof(PlanePosition)};
  const VkVertexInputAttributeDescription attribute{.format = VK_FORMAT_R32G32_SFLOAT};
  const VkPipelineVertexInputStateCreateInfo vertex_input{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
      .vertexBindingDescriptionCount = 1,
      .pVertexBindingDescriptions = &binding,
      .vertexAttributeDescriptionCount = 1,
      .pVertexAttributeDescriptions = &attribute};
  const VkPipelineInputAssemblyStateCreateInfo assembly{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
      .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
  const auto size = static_cast<float>(target_size);
  const VkViewport viewport{.width = size, .height = size, .maxDepth = 1.0F};
  const VkRect2D scissor{.extent = {target_size, target_size}};
  const VkPipelineViewportStateCreateInfo viewport_state{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
      .viewportCount = 1,
      .pViewports = &viewport,
      .scissorCount = 1,
      .pScissors = &scissor};
  const VkPipelineRasterizationStateCreateInfo rasterization{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
      .polygonMode = VK_POLYGON_MODE_FILL,
      .frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE,
      .lineWidth = 1.0F};
  const VkPipelineMultisampleStateCreateInfo multisample{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
      .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
  const VkPipelineColorBlendAttachmentState adding{.blendEnable = VK_TRUE,
                                                   .srcColorBlendFactor = VK_BLEND_FACTOR_ONE,
                                                   .dstColorBlendFactor = VK_BLEND_FACTOR_ONE,
                                                   .colorBlendOp = VK_BLEND_OP_ADD,
                                                   .srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE,
                                                   .dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE,
                                                   .alphaBlendOp = VK_BLEND_OP_ADD,
                                                   .colorWriteMask = VK_COLOR_COMPONENT_R_BIT};
  const VkPipelineColorBlendStateCreateInfo blend{.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
                                                  .attachmentCount = 1,
                                                  .pAttachments = &adding};
  const VkDynamicState cull_mode = VK_DYNAMIC_STATE_CULL_MODE;
  const VkPipelineDynamicStateCreateInfo dynamic{.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                                 .dynamicStateCount = 1,
                                                 .pDynamicStates = &cull_mode};
  const VkPipelineRenderingCreateInfo rendering{.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
                                                .colorAttachmentCount = 1,
                                                .pColorAttachmentFormats = &kHitCountFormat};
  const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                          .pNext = &rendering,
                                          .stageCount = static_cast<uint32_t>(stages.size()),
                                          .pStages = stages.data(),
                                          .pVertexInputState = &vertex_input,
                                          .pInputAssemblyState = &assembly,
                                          .pViewportState = &viewport_state,
                                          .pRasterizationState = &rasterization,
                                          .pMultisampleState = &multisample,
                                          .pColorBlendState = &blend,
                                          .pDynamicState = &dynamic,
                                          .layout = layout};
  VkPipeline pipeline = VK_NULL_HANDLE;
  const VkResult result = vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
  if (result != VK_SUCCESS) return failed_call("vkCreateGraphicsPipelines", result);
  return Pipeline(device, pipeline);
}

}  // namespace

Result<HitPipeline> create_hit_pipeline(const Device& device, uint32_t target_size) {
  const Result<ShaderModule> vertex = compile(device, VK_SHADER_STAGE_VERTEX_BIT, kVertexGlsl);
  if (!vertex) return tl::unexpected(vertex.error());
  const Result<ShaderModule> fragment = compile(device, VK_SHADER_STAGE_FRAGMENT_BIT, kFragmentGlsl);
  if (!fragment) return tl::unexpected(fragment.error());
  const VkPipelineLayoutCreateInfo layout_info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  VkPipelineLayout layout = VK_NULL_HANDLE;
  const VkResult result = vkCreatePipelineLayout(device.get(), &layout_info, nullptr, &layout);
  if (result != VK_SUCCESS) return failed_call("vkCreatePipelineLayout", result);
  HitPipeline made;
  made.layout = PipelineLayout(device.get(), layout);
  Result<Pipeline> pipeline = create_pipeline(device.get(), layout, target_size, vertex->get(), fragment->get());
  if (!pipeline) return tl::unexpected(pipeline.error());
  made.pipeline = std::move(*pipeline);
  return made;
}

}  // namespace fillrule::vulkan
