#include "reference/vulkan/color_pipeline.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "reference/vulkan/shader.h"

namespace fillrule::vulkan {
namespace {

// COUNT is the number of attributes, QUALIFIER smooth or flat.
constexpr const char* kVertexGlsl = R"(#version 450
layout(location = 0) in vec4 pos_clip;
layout(location = 1) in vec4 attributes[COUNT];
layout(location = 0) QUALIFIER out vec4 values[COUNT];
void main() {
  gl_Position = pos_clip;
  for (int i = 0; i < COUNT; ++i) values[i] = attributes[i];
}
)";

constexpr const char* kFragmentGlsl = R"(#version 450
layout(location = 0) QUALIFIER in vec4 values[COUNT];
layout(location = 0) out vec4 color;
void main() {
  vec4 sum = values[0];
  for (int i = 1; i < COUNT; ++i) sum += values[i];
  color = sum * (1.0 / COUNT);
}
)";

// What the vertex buffers hold; the members refer to each other.
struct VertexInput {
  std::array<VkVertexInputBindingDescription, 2> bindings{};
  std::vector<VkVertexInputAttributeDescription> attributes;

  explicit VertexInput(uint32_t attribute_count) {
    constexpr uint32_t kVec4Bytes = 16;
    bindings[0] = {.binding = 0, .stride = sizeof(ClipPosition)};
    bindings[1] = {.binding = 1, .stride = attribute_count * kVec4Bytes};
    attributes.push_back({.location = 0, .binding = 0, .format = VK_FORMAT_R32G32B32A32_SFLOAT});
    for (uint32_t i = 0; i < attribute_count; ++i) {
      attributes.push_back(
          {.location = 1 + i, .binding = 1, .format = VK_FORMAT_R32G32B32A32_SFLOAT, .offset = i * kVec4Bytes});
    }
  }

  [[nodiscard]] VkPipelineVertexInputStateCreateInfo info() const {
    return {.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
            .vertexBindingDescriptionCount = static_cast<uint32_t>(bindings.size()),
            .pVertexBindingDescriptions = bindings.data(),
            .vertexAttributeDescriptionCount = static_cast<uint32_t>(attributes.size()),
            .pVertexAttributeDescriptions = attributes.data()};
  }
};

Result<Pipeline> create_pipeline(VkDevice device, VkPipelineLayout layout, const ColorScene& scene,
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
  const VertexInput input(scene.attribute_count);
  const VkPipelineVertexInputStateCreateInfo vertex_input = input.info();
  const VkPipelineInputAssemblyStateCreateInfo assembly{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO, .topology = scene.topology};
  const auto size = static_cast<float>(scene.target_size);
  const VkViewport viewport{.width = size, .height = size, .maxDepth = 1.0F};
  const VkRect2D scissor{.extent = {scene.target_size, scene.target_size}};
  const VkPipelineViewportStateCreateInfo viewport_state{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
      .viewportCount = 1,
      .pViewports = &viewport,
      .scissorCount = 1,
      .pScissors = &scissor};
  const VkPipelineRasterizationStateCreateInfo rasterization{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
      .polygonMode = VK_POLYGON_MODE_FILL,
      .cullMode = scene.cull_mode,
      .frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE,
      .lineWidth = 1.0F};
  const VkPipelineMultisampleStateCreateInfo multisample{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
      .rasterizationSamples = static_cast<VkSampleCountFlagBits>(scene.samples)};
  const VkPipelineDepthStencilStateCreateInfo depth{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
      .depthTestEnable = VK_TRUE,
      .depthWriteEnable = VK_TRUE,
      .depthCompareOp = VK_COMPARE_OP_LESS};
  const VkPipelineColorBlendAttachmentState replacing{.colorWriteMask =
                                                          VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                                          VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT};
  const VkPipelineColorBlendStateCreateInfo blend{.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
                                                  .attachmentCount = 1,
                                                  .pAttachments = &replacing};
  const VkPipelineRenderingCreateInfo rendering{.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
                                                .colorAttachmentCount = 1,
                                                .pColorAttachmentFormats = &kColorFormat,
                                                .depthAttachmentFormat = kColorDepthFormat};
  const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                          .pNext = &rendering,
                                          .stageCount = static_cast<uint32_t>(stages.size()),
                                          .pStages = stages.data(),
                                          .pVertexInputState = &vertex_input,
                                          .pInputAssemblyState = &assembly,
                                          .pViewportState = &viewport_state,
                                          .pRasterizationState = &rasterization,
                                          .pMultisampleState = &multisample,
                                          .pDepthStencilState = &depth,
                                          .pColorBlendState = &blend,
                                          .layout = layout};
  VkPipeline pipeline = VK_NULL_HANDLE;
  const VkResult result = vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
  if (result != VK_SUCCESS) return failed_call("vkCreateGraphicsPipelines", result);
  return Pipeline(device, pipeline);
}

}  // namespace

Result<ColorPipeline> create_color_pipeline(const Device& device, const ColorScene& scene) {
  const std::string defines = fmt::format("#define COUNT {}\n#define QUALIFIER {}\n", scene.attribute_count,
                                          scene.is_flat ? "flat" : "smooth");
  const Result<ShaderModule> vertex = create_shader(device.get(), VK_SHADER_STAGE_VERTEX_BIT, kVertexGlsl, defines);
  if (!vertex) return tl::unexpected(vertex.error());
  const Result<ShaderModule> fragment =
      create_shader(device.get(), VK_SHADER_STAGE_FRAGMENT_BIT, kFragmentGlsl, defines);
  if (!fragment) return tl::unexpected(fragment.error());
  const VkPipelineLayoutCreateInfo layout_info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  VkPipelineLayout layout = VK_NULL_HANDLE;
  const VkResult result = vkCreatePipelineLayout(device.get(), &layout_info, nullptr, &layout);
  if (result != VK_SUCCESS) return failed_call("vkCreatePipelineLayout", result);
  ColorPipeline made;
  made.layout = PipelineLayout(device.get(), layout);
  Result<Pipeline> pipeline = create_pipeline(device.get(), layout, scene, vertex->get(), fragment->get());
  if (!pipeline) return tl::unexpected(pipeline.error());
  made.pipeline = std::move(*pipeline);
  return made;
}

}  // namespace fillrule::vulkan
