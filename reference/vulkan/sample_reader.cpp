#include "reference/vulkan/sample_reader.h"

#include <string>

#include "reference/vulkan/shader.h"

namespace fillrule::vulkan {
namespace {

// Pixels that one workgroup reads, in x and in y.
constexpr uint32_t kGroupSize = 8;

// The push constants.
struct Size {
  uint32_t width = 0;   // pixels
  uint32_t height = 0;  // pixels
  uint32_t samples = 0;
};

// SAMPLER is the image's type, BITS(x) a texel's bits and LANES the words that are stored of it.
constexpr const char* kGlsl = R"(#version 450
layout(local_size_x = GROUP_SIZE, local_size_y = GROUP_SIZE) in;
layout(binding = 0) uniform SAMPLER attachment;
layout(binding = 1) writeonly buffer Readback { uint words[]; };
layout(push_constant) uniform Size { uint width; uint height; uint samples; };

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= width || pixel.y >= height) return;
  const uint first = (pixel.y * width + pixel.x) * samples;
  for (uint i = 0; i < samples; ++i) {
    const uvec4 bits = BITS(texelFetch(attachment, ivec2(pixel), int(i)));
    for (uint lane = 0; lane < LANES; ++lane) words[(first + i) * LANES + lane] = bits[lane];
  }
}
)";

constexpr std::array kDefines = {
    "#define SAMPLER sampler2DMS\n#define BITS(x) floatBitsToUint(x)\n#define LANES 1\n",
    "#define SAMPLER usampler2DMS\n#define BITS(x) x\n#define LANES 1\n",
    "#define SAMPLER sampler2DMS\n#define BITS(x) floatBitsToUint(x)\n#define LANES 4\n",
};

}  // namespace

Result<void> SampleReader::create() {
  Result<void> created = create_layout();
  for (const Kind kind : {Kind::kScalar, Kind::kInteger, Kind::kVector}) {
    if (created) created = create_pipeline(kind);
  }
  return created;
}

Result<void> SampleReader::create_layout() {
  // Texel fetches ignore the sampler, but sampler2DMS is image and sampler in one.
  const VkSamplerCreateInfo sampler_info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  VkSampler sampler = VK_NULL_HANDLE;
  VkResult result = vkCreateSampler(device_->get(), &sampler_info, nullptr, &sampler);
  if (result != VK_SUCCESS) return failed_call("vkCreateSampler", result);
  sampler_ = Sampler(device_->get(), sampler);

  const std::array bindings = {
      VkDescriptorSetLayoutBinding{.binding = 0,
                                   .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                   .descriptorCount = 1,
                                   .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT},
      VkDescriptorSetLayoutBinding{.binding = 1,
                                   .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                   .descriptorCount = 1,
                                   .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT}};
  const VkDescriptorSetLayoutCreateInfo set_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                                 .bindingCount = static_cast<uint32_t>(bindings.size()),
                                                 .pBindings = bindings.data()};
  VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
  result = vkCreateDescriptorSetLayout(device_->get(), &set_info, nullptr, &set_layout);
  if (result != VK_SUCCESS) return failed_call("vkCreateDescriptorSetLayout", result);
  set_layout_ = DescriptorSetLayout(device_->get(), set_layout);

  const VkPushConstantRange range{.stageFlags = VK_SHADER_STAGE_COMPUTE_BIT, .size = sizeof(Size)};
  const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                        .setLayoutCount = 1,
                                        .pSetLayouts = &set_layout,
                                        .pushConstantRangeCount = 1,
                                        .pPushConstantRanges = &range};
  VkPipelineLayout layout = VK_NULL_HANDLE;
  result = vkCreatePipelineLayout(device_->get(), &info, nullptr, &layout);
  if (result != VK_SUCCESS) return failed_call("vkCreatePipelineLayout", result);
  layout_ = PipelineLayout(device_->get(), layout);
  return {};
}

Result<void> SampleReader::create_pipeline(Kind kind) {
  const std::string defines =
      kDefines.at(static_cast<size_t>(kind)) + ("#define GROUP_SIZE " + std::to_string(kGroupSize) + '\n');
  const Result<ShaderModule> module = create_shader(device_->get(), VK_SHADER_STAGE_COMPUTE_BIT, kGlsl, defines);
  if (!module) return tl::unexpected(module.error());
  const VkComputePipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                         .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                   .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                                                   .module = module->get(),
                                                   .pName = "main"},
                                         .layout = layout_.get()};
  VkPipeline pipeline = VK_NULL_HANDLE;
  const VkResult result = vkCreateComputePipelines(device_->get(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
  if (result != VK_SUCCESS) return failed_call("vkCreateComputePipelines", result);
  pipelines_.at(static_cast<size_t>(kind)) = Pipeline(device_->get(), pipeline);
  return {};
}

Result<void> SampleReader::reserve(uint32_t attachments) {
  if (attachments <= capacity_) {
    const VkResult result = vkResetDescriptorPool(device_->get(), descriptors_.get(), 0);
    if (result != VK_SUCCESS) return failed_call("vkResetDescriptorPool", result);
    return {};
  }
  const std::array sizes = {VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, attachments},
                            VkDescriptorPoolSize{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, attachments}};
  const VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                        .maxSets = attachments,
                                        .poolSizeCount = static_cast<uint32_t>(sizes.size()),
                                        .pPoolSizes = sizes.data()};
  VkDescriptorPool pool = VK_NULL_HANDLE;
  const VkResult result = vkCreateDescriptorPool(device_->get(), &info, nullptr, &pool);
  if (result != VK_SUCCESS) return failed_call("vkCreateDescriptorPool", result);
  descriptors_ = DescriptorPool(device_->get(), pool);
  capacity_ = attachments;
  return {};
}

Result<void> SampleReader::bind(std::span<const CaseJob> jobs, VkBuffer readback) {
  reads_.clear();
  std::vector<const Pass*> passes;
  size_t attachments = 0;
  for (const CaseJob& job : jobs) {
    for (const Pass& pass : job.passes) {
      if (!pass.target.is_multisampled()) continue;
      passes.push_back(&pass);
      attachments += pass.target.attachments().size();
    }
  }
  if (attachments == 0) return {};
  if (layout_.get() == VK_NULL_HANDLE) {
    if (auto created = create(); !created) return created;
  }
  Result<void> bound = reserve(static_cast<uint32_t>(attachments));
  for (const Pass* const pass : passes) {
    for (uint32_t i = 0; bound && i < pass->target.attachments().size(); ++i) {
      bound = bind_attachment(*pass, i, readback);
    }
  }
  return bound;
}

Result<void> SampleReader::bind_attachment(const Pass& pass, uint32_t attachment, VkBuffer readback) {
  VkDescriptorSetLayout set_layout = set_layout_.get();
  const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                         .descriptorPool = descriptors_.get(),
                                         .descriptorSetCount = 1,
                                         .pSetLayouts = &set_layout};
  VkDescriptorSet set = VK_NULL_HANDLE;
  const VkResult result = vkAllocateDescriptorSets(device_->get(), &info, &set);
  if (result != VK_SUCCESS) return failed_call("vkAllocateDescriptorSets", result);

  const TargetKey& key = pass.target.key();
  const Attachment& source = pass.target.attachments()[attachment];
  const VkDescriptorImageInfo image{
      .sampler = sampler_.get(), .imageView = source.view.get(), .imageLayout = VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL};
  const uint64_t offset = attachment_offset(key, attachment);
  const VkDescriptorBufferInfo buffer{.buffer = readback,
                                      .offset = pass.readback_offset + offset,
                                      .range = attachment_offset(key, attachment + 1) - offset};
  const std::array writes = {VkWriteDescriptorSet{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                                  .dstSet = set,
                                                  .dstBinding = 0,
                                                  .descriptorCount = 1,
                                                  .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                                  .pImageInfo = &image},
                             VkWriteDescriptorSet{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                                  .dstSet = set,
                                                  .dstBinding = 1,
                                                  .descriptorCount = 1,
                                                  .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                                  .pBufferInfo = &buffer}};
  vkUpdateDescriptorSets(device_->get(), static_cast<uint32_t>(writes.size()), writes.data(), 0, nullptr);
  const Kind scalar = source.format == kOwnerFormat ? Kind::kInteger : Kind::kScalar;
  reads_.push_back({.kind = source.format == kSlotFormat ? Kind::kVector : scalar, .set = set, .target = key});
  return {};
}

void SampleReader::record(VkCommandBuffer commands) const {
  for (const Read& read : reads_) {
    const Size size{.width = read.target.width, .height = read.target.height, .samples = read.target.samples};
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipelines_.at(static_cast<size_t>(read.kind)).get());
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &read.set, 0, nullptr);
    vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(Size), &size);
    vkCmdDispatch(commands, (size.width + kGroupSize - 1) / kGroupSize, (size.height + kGroupSize - 1) / kGroupSize,
                  1);
  }
}

}  // namespace fillrule::vulkan
