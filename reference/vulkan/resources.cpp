#include "reference/vulkan/resources.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace fillrule::vulkan {
namespace {

constexpr VkFormat kTextureFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
// The largest alignment that Vulkan lets a device ask of uniform buffers.
constexpr uint64_t kUniformAlignment = 256;

uint64_t uniform_stride(uint32_t bytes) {
  return (bytes + kUniformAlignment - 1) / kUniformAlignment * kUniformAlignment;
}

Result<void> check_texture(const Device& device, const Texture& texture) {
  VkFormatProperties properties;
  vkGetPhysicalDeviceFormatProperties(device.physical(), kTextureFormat, &properties);
  constexpr VkFormatFeatureFlags kNeeded =
      VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
  if ((properties.optimalTilingFeatures & kNeeded) != kNeeded) {
    return failure(device.info().name + " does not filter 32-bit float textures");
  }
  const bool is_complete = std::all_of(texture.levels.begin(), texture.levels.end(), [](const TextureLevel& level) {
    return level.width > 0 && level.height > 0 && level.texels.size() == size_t{level.width} * level.height;
  });
  if (texture.levels.empty() || !is_complete) return failure("a texture whose texels are not those of its size");
  const uint32_t size = std::max(texture.levels[0].width, texture.levels[0].height);
  if (size > device.info().max_target_size) {
    return failure(fmt::format("a texture of {} texels", size),
                   fmt::format("at most {} on {}", device.info().max_target_size, device.info().name));
  }
  return {};
}

VkImageMemoryBarrier2 barrier_of(VkImage image, uint32_t levels) {
  return {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
          .image = image,
          .subresourceRange = {
              .aspectMask = VK_IMAGE_ASPECT_COLOR_BIT, .levelCount = levels, .layerCount = 1}};
}

void record_barrier(VkCommandBuffer commands, const VkImageMemoryBarrier2& barrier) {
  const VkDependencyInfo info{
      .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier};
  vkCmdPipelineBarrier2(commands, &info);
}

// Into the image, level by level, and ready for fragment shaders.
void record_upload(VkCommandBuffer commands, VkBuffer staging, VkImage image, const Texture& texture) {
  const auto levels = static_cast<uint32_t>(texture.levels.size());
  VkImageMemoryBarrier2 barrier = barrier_of(image, levels);
  barrier.dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
  barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  record_barrier(commands, barrier);
  uint64_t offset = 0;
  for (uint32_t i = 0; i < levels; ++i) {
    const TextureLevel& level = texture.levels[i];
    const VkBufferImageCopy region{
        .bufferOffset = offset,
        .imageSubresource = {.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT, .mipLevel = i, .layerCount = 1},
        .imageExtent = {level.width, level.height, 1}};
    vkCmdCopyBufferToImage(commands, staging, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    offset += level.texels.size() * sizeof(Texel);
  }
  barrier = barrier_of(image, levels);
  barrier.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
  barrier.dstStageMask = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
  barrier.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  barrier.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  record_barrier(commands, barrier);
}

}  // namespace

Result<ResourceBinder> ResourceBinder::create(const Device& device, uint32_t uniform_bytes) {
  ResourceBinder binder(device);
  binder.uniform_bytes_ = uniform_bytes;
  binder.white_ = std::make_shared<const Texture>(
      Texture{.levels = {TextureLevel{.width = 1, .height = 1, .texels = {{1, 1, 1, 1}}}}});
  if (const auto created = binder.create_layout(); !created) return tl::unexpected(created.error());
  if (const auto created = binder.create_commands(); !created) return tl::unexpected(created.error());
  return binder;
}

Result<void> ResourceBinder::create_layout() {
  constexpr VkShaderStageFlags kStages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
  const std::array bindings{
      VkDescriptorSetLayoutBinding{.binding = 0,
                                   .descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                                   .descriptorCount = 1,
                                   .stageFlags = kStages},
      VkDescriptorSetLayoutBinding{.binding = 1,
                                   .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                   .descriptorCount = 1,
                                   .stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT}};
  const VkDescriptorSetLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                             .bindingCount = bindings.size(),
                                             .pBindings = bindings.data()};
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  const VkResult result = vkCreateDescriptorSetLayout(device_->get(), &info, nullptr, &layout);
  if (result != VK_SUCCESS) return failed_call("vkCreateDescriptorSetLayout", result);
  layout_ = DescriptorSetLayout(device_->get(), layout);
  return {};
}

Result<void> ResourceBinder::create_commands() {
  const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                          .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                                          .queueFamilyIndex = device_->queue_family()};
  VkCommandPool pool = VK_NULL_HANDLE;
  VkResult result = vkCreateCommandPool(device_->get(), &pool_info, nullptr, &pool);
  if (result != VK_SUCCESS) return failed_call("vkCreateCommandPool", result);
  command_pool_ = CommandPool(device_->get(), pool);
  const VkCommandBufferAllocateInfo commands_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                  .commandPool = pool,
                                                  .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                  .commandBufferCount = 1};
  result = vkAllocateCommandBuffers(device_->get(), &commands_info, &commands_);
  if (result != VK_SUCCESS) return failed_call("vkAllocateCommandBuffers", result);
  return {};
}

Result<std::vector<VkDescriptorSet>> ResourceBinder::bind(std::span<const DrawResources> draws) {
  std::vector<VkDescriptorSet> sets(draws.size(), VK_NULL_HANDLE);
  if (draws.empty()) return sets;
  drop_unused_images();
  if (const auto fitted = fit(static_cast<uint32_t>(draws.size())); !fitted) return tl::unexpected(fitted.error());
  const std::vector<VkDescriptorSetLayout> layouts(draws.size(), layout_.get());
  const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                         .descriptorPool = pool_.get(),
                                         .descriptorSetCount = static_cast<uint32_t>(layouts.size()),
                                         .pSetLayouts = layouts.data()};
  const VkResult result = vkAllocateDescriptorSets(device_->get(), &info, sets.data());
  if (result != VK_SUCCESS) return failed_call("vkAllocateDescriptorSets", result);
  for (size_t i = 0; i < draws.size(); ++i) {
    if (draws[i].uniforms.size() != uniform_bytes_) {
      return failure(fmt::format("uniforms of {} bytes instead of {}", draws[i].uniforms.size(), uniform_bytes_));
    }
    const uint64_t offset = i * uniform_stride(uniform_bytes_);
    std::memcpy(uniforms_.bytes().subspan(offset, uniform_bytes_).data(), draws[i].uniforms.data(), uniform_bytes_);
    const Result<const SampledImage*> image = find_or_create(draws[i].texture ? draws[i].texture : white_);
    if (!image) return tl::unexpected(image.error());
    write(sets[i], offset, **image);
  }
  return sets;
}

void ResourceBinder::drop_unused_images() {
  std::erase_if(images_, [](const auto& entry) { return entry.second.texture.use_count() == 1; });
}

Result<void> ResourceBinder::fit(uint32_t sets) {
  if (sets <= pool_sets_) {
    vkResetDescriptorPool(device_->get(), pool_.get(), 0);
    return {};
  }
  pool_sets_ = std::bit_ceil(sets);
  const std::array sizes{
      VkDescriptorPoolSize{.type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, .descriptorCount = pool_sets_},
      VkDescriptorPoolSize{.type = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, .descriptorCount = pool_sets_}};
  const VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                        .maxSets = pool_sets_,
                                        .poolSizeCount = sizes.size(),
                                        .pPoolSizes = sizes.data()};
  VkDescriptorPool pool = VK_NULL_HANDLE;
  const VkResult result = vkCreateDescriptorPool(device_->get(), &info, nullptr, &pool);
  if (result != VK_SUCCESS) return failed_call("vkCreateDescriptorPool", result);
  pool_ = DescriptorPool(device_->get(), pool);
  Result<HostBuffer> buffer = HostBuffer::create(*device_, pool_sets_ * uniform_stride(uniform_bytes_),
                                                 VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  if (!buffer) return tl::unexpected(buffer.error());
  uniforms_ = std::move(*buffer);
  return {};
}

Result<const ResourceBinder::SampledImage*> ResourceBinder::find_or_create(
    const std::shared_ptr<const Texture>& texture) {
  if (const auto found = images_.find(texture.get()); found != images_.end()) return &found->second;
  if (const auto good = check_texture(*device_, *texture); !good) return tl::unexpected(good.error());
  SampledImage sampled{.texture = texture};
  for (const auto step : {&ResourceBinder::create_image, &ResourceBinder::create_view_and_sampler}) {
    if (const auto done = (this->*step)(sampled); !done) return tl::unexpected(done.error());
  }
  if (const auto done = upload(sampled); !done) return tl::unexpected(done.error());
  return &images_.emplace(texture.get(), std::move(sampled)).first->second;
}

Result<void> ResourceBinder::create_image(SampledImage& sampled) const {
  const TextureLevel& first = sampled.texture->levels[0];
  const VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                               .imageType = VK_IMAGE_TYPE_2D,
                               .format = kTextureFormat,
                               .extent = {first.width, first.height, 1},
                               .mipLevels = static_cast<uint32_t>(sampled.texture->levels.size()),
                               .arrayLayers = 1,
                               .samples = VK_SAMPLE_COUNT_1_BIT,
                               .tiling = VK_IMAGE_TILING_OPTIMAL,
                               .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT};
  VkImage image = VK_NULL_HANDLE;
  VkResult result = vkCreateImage(device_->get(), &info, nullptr, &image);
  if (result != VK_SUCCESS) return failed_call("vkCreateImage", result);
  sampled.image = Image(device_->get(), image);
  VkMemoryRequirements requirements;
  vkGetImageMemoryRequirements(device_->get(), image, &requirements);
  Result<Memory> memory = device_->allocate(requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  if (!memory) return tl::unexpected(memory.error());
  sampled.memory = std::move(*memory);
  result = vkBindImageMemory(device_->get(), image, sampled.memory.get(), 0);
  if (result != VK_SUCCESS) return failed_call("vkBindImageMemory", result);
  return {};
}

Result<void> ResourceBinder::create_view_and_sampler(SampledImage& sampled) const {
  const auto levels = static_cast<uint32_t>(sampled.texture->levels.size());
  const VkImageViewCreateInfo view_info{
      .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
      .image = sampled.image.get(),
      .viewType = VK_IMAGE_VIEW_TYPE_2D,
      .format = kTextureFormat,
      .subresourceRange = {.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT, .levelCount = levels, .layerCount = 1}};
  VkImageView view = VK_NULL_HANDLE;
  VkResult result = vkCreateImageView(device_->get(), &view_info, nullptr, &view);
  if (result != VK_SUCCESS) return failed_call("vkCreateImageView", result);
  sampled.view = ImageView(device_->get(), view);

  const Sampling2D& sampling = sampled.texture->sampling;
  const VkSamplerCreateInfo sampler_info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                         .magFilter = sampling.filter,
                                         .minFilter = sampling.filter,
                                         .mipmapMode = sampling.mipmaps == Mipmaps::kLinear
                                                           ? VK_SAMPLER_MIPMAP_MODE_LINEAR
                                                           : VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                         .addressModeU = sampling.wrap_u,
                                         .addressModeV = sampling.wrap_v,
                                         .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                         .maxLod = static_cast<float>(levels - 1),
                                         .borderColor = sampling.border};
  VkSampler sampler = VK_NULL_HANDLE;
  result = vkCreateSampler(device_->get(), &sampler_info, nullptr, &sampler);
  if (result != VK_SUCCESS) return failed_call("vkCreateSampler", result);
  sampled.sampler = Sampler(device_->get(), sampler);
  return {};
}

Result<void> ResourceBinder::upload(const SampledImage& sampled) const {
  uint64_t bytes = 0;
  for (const TextureLevel& level : sampled.texture->levels) bytes += level.texels.size() * sizeof(Texel);
  const Result<HostBuffer> staging = HostBuffer::create(*device_, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  if (!staging) return tl::unexpected(staging.error());
  uint64_t offset = 0;
  for (const TextureLevel& level : sampled.texture->levels) {
    const auto texels = std::as_bytes(std::span(level.texels));
    std::memcpy(staging->bytes().subspan(offset, texels.size()).data(), texels.data(), texels.size());
    offset += texels.size();
  }
  VkResult result = vkResetCommandPool(device_->get(), command_pool_.get(), 0);
  if (result != VK_SUCCESS) return failed_call("vkResetCommandPool", result);
  const VkCommandBufferBeginInfo begin_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                            .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  result = vkBeginCommandBuffer(commands_, &begin_info);
  if (result != VK_SUCCESS) return failed_call("vkBeginCommandBuffer", result);
  record_upload(commands_, staging->get(), sampled.image.get(), *sampled.texture);
  result = vkEndCommandBuffer(commands_);
  if (result != VK_SUCCESS) return failed_call("vkEndCommandBuffer", result);
  const VkSubmitInfo submit_info{
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands_};
  result = vkQueueSubmit(device_->queue(), 1, &submit_info, VK_NULL_HANDLE);
  if (result != VK_SUCCESS) return failed_call("vkQueueSubmit", result);
  result = vkQueueWaitIdle(device_->queue());
  if (result != VK_SUCCESS) return failed_call("vkQueueWaitIdle", result);
  return {};
}

void ResourceBinder::write(VkDescriptorSet set, uint64_t uniform_offset, const SampledImage& image) const {
  const VkDescriptorBufferInfo buffer{.buffer = uniforms_.get(), .offset = uniform_offset, .range = uniform_bytes_};
  const VkDescriptorImageInfo sampled{.sampler = image.sampler.get(),
                                      .imageView = image.view.get(),
                                      .imageLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  const std::array writes{VkWriteDescriptorSet{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                               .dstSet = set,
                                               .dstBinding = 0,
                                               .descriptorCount = 1,
                                               .descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                                               .pBufferInfo = &buffer},
                          VkWriteDescriptorSet{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                               .dstSet = set,
                                               .dstBinding = 1,
                                               .descriptorCount = 1,
                                               .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                               .pImageInfo = &sampled}};
  vkUpdateDescriptorSets(device_->get(), writes.size(), writes.data(), 0, nullptr);
}

}  // namespace fillrule::vulkan
