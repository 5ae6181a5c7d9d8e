#include "reference/vulkan/graphics_pipeline.h"

#include <array>
#include <vector>

namespace fillrule::vulkan {
namespace {

constexpr std::array kDynamicStates = {
    VK_DYNAMIC_STATE_VIEWPORT,
    VK_DYNAMIC_STATE_SCISSOR,
    VK_DYNAMIC_STATE_CULL_MODE,
    VK_DYNAMIC_STATE_FRONT_FACE,
    VK_DYNAMIC_STATE_PRIMITIVE_TOPOLOGY,
    VK_DYNAMIC_STATE_PRIMITIVE_RESTART_ENABLE,
    VK_DYNAMIC_STATE_VERTEX_INPUT_BINDING_STRIDE,
    VK_DYNAMIC_STATE_LINE_WIDTH,
    VK_DYNAMIC_STATE_DEPTH_TEST_ENABLE,
    VK_DYNAMIC_STATE_DEPTH_WRITE_ENABLE,
    VK_DYNAMIC_STATE_DEPTH_COMPARE_OP,
    VK_DYNAMIC_STATE_DEPTH_BIAS_ENABLE,
    VK_DYNAMIC_STATE_DEPTH_BIAS,
    VK_DYNAMIC_STATE_DEPTH_BOUNDS_TEST_ENABLE,
    VK_DYNAMIC_STATE_DEPTH_BOUNDS,
};

class VertexInput {
 public:
  explicit VertexInput(const PipelineKey& key);
  [[nodiscard]] VkPipelineVertexInputStateCreateInfo info() const;

 private:
  // Attributes of the binding one after another, from `location` on.
  void add(uint32_t binding, uint32_t location, uint32_t count, VkFormat format, uint32_t bytes_each);

  std::vector<VkVertexInputBindingDescription> bindings_;
  std::vector<VkVertexInputAttributeDescription> attributes_;
};

VertexInput::VertexInput(const PipelineKey& key) {
  const VkFormat vec4 = VK_FORMAT_R32G32B32A32_SFLOAT;
  const uint32_t slots = key.slots.interpolated();
  add(kPositionBinding, 0, 1, vec4, kVec4Bytes);
  add(kSlotBinding, 1, slots, vec4, kVec4Bytes);
  add(kPointSizeBinding, 1 + slots, 1, VK_FORMAT_R32_SFLOAT, sizeof(float));
  add(kDistanceBinding, 2 + slots, key.clip_distances + key.cull_distances, VK_FORMAT_R32_SFLOAT, sizeof(float));
}

void VertexInput::add(uint32_t binding, uint32_t location, uint32_t count, VkFormat format, uint32_t bytes_each) {
  if (count == 0) return;
  bindings_.push_back({.binding = binding, .stride = count * bytes_each});
  for (uint32_t i = 0; i < count; ++i) {
    attributes_.push_back({.location = location + i, .binding = binding, .format = format, .offset = i * bytes_each});
  }
}

VkPipelineVertexInputStateCreateInfo VertexInput::info() const {
  return {.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
          .vertexBindingDescriptionCount = static_cast<uint32_t>(bindings_.size()),
          .pVertexBindingDescriptions = bindings_.data(),
          .vertexAttributeDescriptionCount = static_cast<uint32_t>(attributes_.size()),
          .pVertexAttributeDescriptions = attributes_.data()};
}

// The structures point to each other, so it never moves.
class Rasterization {
 public:
  explicit Rasterization(const PipelineKey& key);
  Rasterization(const Rasterization&) = delete;
  Rasterization(Rasterization&&) = delete;
  Rasterization& operator=(const Rasterization&) = delete;
  Rasterization& operator=(Rasterization&&) = delete;
  ~Rasterization() = default;

  [[nodiscard]] const VkPipelineRasterizationStateCreateInfo& info() const { return info_; }

 private:
  template <typename Structure>
  void chain(Structure& structure) {
    structure.pNext = info_.pNext;
    info_.pNext = &structure;
  }

  VkPipelineRasterizationStateCreateInfo info_{.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  VkPipelineRasterizationLineStateCreateInfoEXT lines_{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_LINE_STATE_CREATE_INFO_EXT};
  VkPipelineRasterizationProvokingVertexStateCreateInfoEXT provoking_{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_PROVOKING_VERTEX_STATE_CREATE_INFO_EXT};
  VkPipelineRasterizationDepthClipStateCreateInfoEXT depth_clip_{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_DEPTH_CLIP_STATE_CREATE_INFO_EXT};
};

Rasterization::Rasterization(const PipelineKey& key) {
  info_.polygonMode = key.polygon_mode;
  info_.depthClampEnable = key.depth_clamp ? VK_TRUE : VK_FALSE;
  info_.lineWidth = 1.0F;
  // What says no more than the default is left out, so that a device without the extension can draw it.
  if (key.line_mode != VK_LINE_RASTERIZATION_MODE_DEFAULT_EXT) {
    lines_.lineRasterizationMode = key.line_mode;
    chain(lines_);
  }
  if (key.provoking_vertex != VK_PROVOKING_VERTEX_MODE_FIRST_VERTEX_EXT) {
    provoking_.provokingVertexMode = key.provoking_vertex;
    chain(provoking_);
  }
  if (key.depth_clip == key.depth_clamp) {
    depth_clip_.depthClipEnable = key.depth_clip ? VK_TRUE : VK_FALSE;
    chain(depth_clip_);
  }
}

// Hits add up; the other attachments keep the last fragment that landed.
std::vector<VkPipelineColorBlendAttachmentState> describe_blending(uint32_t outputs) {
  const VkColorComponentFlags all =
      VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  std::vector<VkPipelineColorBlendAttachmentState> attachments(kFirstSlotAttachment + outputs,
                                                               {.colorWriteMask = all});
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

std::vector<VkFormat> color_formats(uint32_t outputs) {
  std::vector<VkFormat> formats(kFirstSlotAttachment + outputs, kSlotFormat);
  formats[0] = kHitsFormat;
  formats[1] = kOwnerFormat;
  return formats;
}

}  // namespace

Result<Pipeline> create_graphics_pipeline(VkDevice device, VkPipelineLayout layout, const PipelineKey& key,
                                          std::span<const VkDynamicState> dynamic, VkShaderModule vertex,
                                          VkShaderModule fragment) {
  const std::array stages = {
      VkPipelineShaderStageCreateInfo{.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                      .stage = VK_SHADER_STAGE_VERTEX_BIT,
                                      .module = vertex,
                                      .pName = "main"},
      VkPipelineShaderStageCreateInfo{.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                      .stage = VK_SHADER_STAGE_FRAGMENT_BIT,
                                      .module = fragment,
                                      .pName = "main"}};
  const VertexInput input(key);
  const VkPipelineVertexInputStateCreateInfo vertex_input = input.info();
  const VkPipelineInputAssemblyStateCreateInfo assembly{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO, .topology = key.topology_class};
  const VkPipelineViewportDepthClipControlCreateInfoEXT clip_control{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_DEPTH_CLIP_CONTROL_CREATE_INFO_EXT, .negativeOneToOne = VK_TRUE};
  const VkPipelineViewportStateCreateInfo viewport{.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
                                                   .pNext = key.negative_one_to_one ? &clip_control : nullptr,
                                                   .viewportCount = 1,
                                                   .scissorCount = 1};
  const Rasterization rasterization(key);
  const VkPipelineMultisampleStateCreateInfo multisample{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
      .rasterizationSamples = key.samples,
      .sampleShadingEnable = key.sample_shading ? VK_TRUE : VK_FALSE,
      .minSampleShading = 1.0F,
      .pSampleMask = &key.sample_mask};
  const VkPipelineDepthStencilStateCreateInfo depth{.sType =
                                                        VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  const auto blending = describe_blending(key.outputs);
  const VkPipelineColorBlendStateCreateInfo blend{.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
                                                  .attachmentCount = static_cast<uint32_t>(blending.size()),
                                                  .pAttachments = blending.data()};
  std::vector<VkDynamicState> states(kDynamicStates.begin(), kDynamicStates.end());
  states.insert(states.end(), dynamic.begin(), dynamic.end());
  const VkPipelineDynamicStateCreateInfo dynamic_info{.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                                      .dynamicStateCount = static_cast<uint32_t>(states.size()),
                                                      .pDynamicStates = states.data()};
  const std::vector<VkFormat> formats = color_formats(key.outputs);
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
                                          .pRasterizationState = &rasterization.info(),
                                          .pMultisampleState = &multisample,
                                          .pDepthStencilState = &depth,
                                          .pColorBlendState = &blend,
                                          .pDynamicState = &dynamic_info,
                                          .layout = layout};
  VkPipeline pipeline = VK_NULL_HANDLE;
  const VkResult result = vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
  if (result != VK_SUCCESS) return failed_call("vkCreateGraphicsPipelines", result);
  return Pipeline(device, pipeline);
}

}  // namespace fillrule::vulkan
