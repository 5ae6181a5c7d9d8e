#include "reference/vulkan/pipeline.h"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

#include "reference/vulkan/shader.h"

namespace fillrule::vulkan {
namespace {

constexpr std::array kDynamicStates = {
    VK_DYNAMIC_STATE_VIEWPORT,           VK_DYNAMIC_STATE_SCISSOR,
    VK_DYNAMIC_STATE_CULL_MODE,          VK_DYNAMIC_STATE_FRONT_FACE,
    VK_DYNAMIC_STATE_PRIMITIVE_TOPOLOGY, VK_DYNAMIC_STATE_VERTEX_INPUT_BINDING_STRIDE,
    VK_DYNAMIC_STATE_DEPTH_TEST_ENABLE,  VK_DYNAMIC_STATE_DEPTH_WRITE_ENABLE,
    VK_DYNAMIC_STATE_DEPTH_COMPARE_OP,
};

struct VertexInput {
  std::vector<VkVertexInputBindingDescription> bindings;
  std::vector<VkVertexInputAttributeDescription> attributes;
};

VertexInput describe_vertex_input(uint32_t slots) {
  const VkFormat vec4 = VK_FORMAT_R32G32B32A32_SFLOAT;
  VertexInput input;
  input.bindings.push_back({.binding = kPositionBinding, .stride = kVec4Bytes});
  input.attributes.push_back({.location = 0, .binding = kPositionBinding, .format = vec4, .offset = 0});
  if (slots > 0) input.bindings.push_back({.binding = kSlotBinding, .stride = kVec4Bytes * slots});
  for (uint32_t i = 0; i < slots; ++i) {
    input.attributes.push_back(
        {.location = 1 + i, .binding = kSlotBinding, .format = vec4, .offset = kVec4Bytes * i});
  }
  return input;
}

// Hits add up; the other attachments keep the last fragment that landed.
std::vector<VkPipelineColorBlendAttachmentState> describe_blending(uint32_t slots) {
  const VkColorComponentFlags all =
      VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  std::vector<VkPipelineColorBlendAttachmentState> attachments(kFirstSlotAttachment + slots, {.colorWriteMask = all});
  attachments[0] = {.blendEnable = VK_TRUE,
                    .srcColorBlendFactor = VK_BLEND_FACTOR_ONE,
                    .dstColorBlendFactor = VK_BLEND_FACTOR_ONE,
                    .colorBlendOp = VK_BLEND_OP_ADD,
                    .srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE,
                    .dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE,
                    .alphaBlendOp = VK_BLEND_OP_ADD,
                    .colorWriteMask = all};
  return attachments;
}

std::vector<VkFormat> color_formats(uint32_t slots) {
  std::vector<VkFormat> formats(kFirstSlotAttachment + slots, kSlotFormat);
  formats[0] = kHitsFormat;
  formats[1] = kOwnerFormat;
  return formats;
}

Result<Pipeline> create_pipeline(VkDevice device, VkPipelineLayout layout, const PipelineKey& key,
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
  const uint32_t slots = key.slots.total();
  const VertexInput input = describe_vertex_input(slots);
  const VkPipelineVertexInputStateCreateInfo vertex_input{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
      .vertexBindingDescriptionCount = static_cast<uint32_t>(input.bindings.size()),
      .pVertexBindingDescriptions = input.bindings.data(),
      .vertexAttributeDescriptionCount = static_cast<uint32_t>(input.attributes.size()),
      .pVertexAttributeDescriptions = input.attributes.data()};
  const VkPipelineInputAssemblyStateCreateInfo assembly{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO, .topology = key.topology_class};
  const VkPipelineViewportStateCreateInfo viewport{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1};
  const VkPipelineRasterizationStateCreateInfo rasterization{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
      .polygonMode = VK_POLYGON_MODE_FILL,
      .lineWidth = 1.0F};
  const VkPipelineMultisampleStateCreateInfo multisample{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO, .rasterizationSamples = key.samples};
  const VkPipelineDepthStencilStateCreateInfo depth{.sType =
                                                        VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  const auto blending = describe_blending(slots);
  const VkPipelineColorBlendStateCreateInfo blend{.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
                                                  .attachmentCount = static_cast<uint32_t>(blending.size()),
                                                  .pAttachments = blending.data()};
  const VkPipelineDynamicStateCreateInfo dynamic{.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                                 .dynamicStateCount = static_cast<uint32_t>(kDynamicStates.size()),
                                                 .pDynamicStates = kDynamicStates.data()};
  const std::vector<VkFormat> formats = color_formats(slots);
  const VkPipelineRenderingCreateInfo rendering{.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
                                                .colorAttachmentCount = static_cast<uint32_t>(formats.size()),
                                                .pColorAttachmentFormats = formats.data(),
                                                .depthAttachmentFormat = key.depth_format};
  const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                          .pNext = &rendering,
                                          .stageCount = static_cast<uint32_t>(stages.size()),
                                          .pStages = stages.data(),
                                          .pVertexInputState = &vertex_input,
                                          .pInputAssemblyState = &assembly,
                                          .pViewportState = &viewport,
                                          .pRasterizationState = &rasterization,
                                          .pMultisampleState = &multisample,
                                          .pDepthStencilState = &depth,
                                          .pColorBlendState = &blend,
                                          .pDynamicState = &dynamic,
                                          .layout = layout};
  VkPipeline pipeline = VK_NULL_HANDLE;
  const VkResult result = vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
  if (result != VK_SUCCESS) return failed_call("vkCreateGraphicsPipelines", result);
  return Pipeline(device, pipeline);
}

}  // namespace

Result<PipelineCache> PipelineCache::create(const Device& device, Program program, bool use_primitive_id) {
  PipelineCache cache;
  cache.device_ = &device;
  cache.program_ = std::move(program);
  cache.use_primitive_id_ = use_primitive_id;
  const VkPushConstantRange range{.stageFlags = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT,
                                  .size = sizeof(Numbering)};
  const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                        .pushConstantRangeCount = 1,
                                        .pPushConstantRanges = &range};
  VkPipelineLayout layout = VK_NULL_HANDLE;
  const VkResult result = vkCreatePipelineLayout(device.get(), &info, nullptr, &layout);
  if (result != VK_SUCCESS) return failed_call("vkCreatePipelineLayout", result);
  cache.layout_ = PipelineLayout(device.get(), layout);

  for (const VkShaderStageFlagBits stage : {VK_SHADER_STAGE_VERTEX_BIT, VK_SHADER_STAGE_FRAGMENT_BIT}) {
    if (const auto module = cache.compile(stage, {}); !module) return tl::unexpected(module.error());
  }
  return cache;
}

Result<ShaderModule> PipelineCache::compile(VkShaderStageFlagBits stage, const SlotCounts& slots) const {
  const std::string defines = fmt::format(
      "#define NUM_SMOOTH {}\n#define NUM_NOPERSPECTIVE {}\n#define NUM_FLAT {}\n#define PRIMITIVE_ID {}\n",
      slots.smooth, slots.noperspective, slots.flat, use_primitive_id_ ? 1 : 0);
  const bool is_vertex = stage == VK_SHADER_STAGE_VERTEX_BIT;
  const auto spirv = compile_glsl(stage, is_vertex ? program_.vertex_glsl : program_.fragment_glsl, defines);
  if (!spirv) return tl::unexpected(spirv.error());
  const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                      .codeSize = spirv->size() * sizeof(uint32_t),
                                      .pCode = spirv->data()};
  VkShaderModule module = VK_NULL_HANDLE;
  const VkResult result = vkCreateShaderModule(device_->get(), &info, nullptr, &module);
  if (result != VK_SUCCESS) return failed_call("vkCreateShaderModule", result);
  return ShaderModule(device_->get(), module);
}

Result<VkPipeline> PipelineCache::find_or_create(const PipelineKey& key) {
  if (const auto found = pipelines_.find(key); found != pipelines_.end()) return found->second.get();
  const Result<ShaderModule> vertex = compile(VK_SHADER_STAGE_VERTEX_BIT, key.slots);
  if (!vertex) return tl::unexpected(vertex.error());
  const Result<ShaderModule> fragment = compile(VK_SHADER_STAGE_FRAGMENT_BIT, key.slots);
  if (!fragment) return tl::unexpected(fragment.error());
  Result<Pipeline> pipeline = create_pipeline(device_->get(), layout_.get(), key, vertex->get(), fragment->get());
  if (!pipeline) return tl::unexpected(pipeline.error());
  return pipelines_.emplace(key, std::move(*pipeline)).first->second.get();
}

}  // namespace fillrule::vulkan
