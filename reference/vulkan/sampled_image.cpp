#include "reference/vulkan/sampled_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

namespace fillrule::vulkan {
namespace {

constexpr VkFormat kTextureFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

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
          .subresourceRange = {.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT, .levelCount = levels, .layerCount = 1}};
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

Result<void> create_image(const Device& device, SampledImage& sampled) {
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
  VkResult result = vkCreateImage(device.get(), &info, nullptr, &image);
  if (result != VK_SUCCESS) return failed_call("vkCreateImage", result);
  sampled.image = Image(device.get(), image);
  VkMemoryRequirements requirements;
  vkGetImageMemoryRequirements(device.get(), image, &requirements);
  Result<Memory> memory = device.allocate(requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  if (!memory) return tl::unexpected(memory.error());
  sampled.memory = std::move(*memory);
  result = vkBindImageMemory(device.get(), image, sampled.memory.get(), 0);
  if (result != VK_SUCCESS) return failed_call("vkBindImageMemory", result);
  return {};
}

Result<void> create_view_and_sampler(const Device& device, SampledImage& sampled) {
  const auto levels = static_cast<uint32_t>(sampled.texture->levels.size());
  const VkImageViewCreateInfo view_info{
      .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
      .image = sampled.image.get(),
      .viewType = VK_IMAGE_VIEW_TYPE_2D,
      .format = kTextureFormat,
      .subresourceRange = {.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT, .levelCount = levels, .layerCount = 1}};
  VkImageView view = VK_NULL_HANDLE;
  VkResult result = vkCreateImageView(device.get(), &view_info, nullptr, &view);
  if (result != VK_SUCCESS) return failed_call("vkCreateImageView", result);
  sampled.view = ImageView(device.get(), view);

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
  result = vkCreateSampler(device.get(), &sampler_info, nullptr, &sampler);
  if (result != VK_SUCCESS) return failed_call("vkCreateSampler", result);
  sampled.sampler = Sampler(device.get(), sampler);
  return {};
}

}  // namespace

Result<SampledImage> create_sampled_image(const Device& device, const std::shared_ptr<const Texture>& texture) {
  SampledImage sampled{.texture = texture};
  if (const auto good = check_texture(device, *texture); !good) return tl::unexpected(good.error());
  if (const auto done = create_image(device, sampled); !done) return tl::unexpected(done.error());
  if (const auto done = create_view_and_sampler(device, sampled); !done) return tl::unexpected(done.error());
  return sampled;
}

Result<void> upload(const Device& device, VkCommandBuffer commands, const SampledImage& sampled) {
  uint64_t bytes = 0;
  for (const TextureLevel& level : sampled.texture->levels) bytes += level.texels.size() * sizeof(Texel);
  const Result<HostBuffer> staging = HostBuffer::create(device, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  if (!staging) return tl::unexpected(staging.error());
  uint64_t offset = 0;
  for (const TextureLevel& level : sampled.texture->levels) {
    const auto texels = std::as_bytes(std::span(level.texels));
    std::memcpy(staging->bytes().subspan(offset, texels.size()).data(), texels.data(), texels.size());
    offset += texels.size();
  }
  const VkCommandBufferBeginInfo begin_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                            .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  VkResult result = vkBeginCommandBuffer(commands, &begin_info);
  if (result != VK_SUCCESS) return failed_call("vkBeginCommandBuffer", result);
  record_upload(commands, staging->get(), sampled.image.get(), *sampled.texture);
  result = vkEndCommandBuffer(commands);
  if (result != VK_SUCCESS) return failed_call("vkEndCommandBuffer", result);
  const VkSubmitInfo submit_info{
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
  result = vkQueueSubmit(device.queue(), 1, &submit_info, VK_NULL_HANDLE);
  if (result != VK_SUCCESS) return failed_call("vkQueueSubmit", result);
  result = vkQueueWaitIdle(device.queue());
  if (result != VK_SUCCESS) return failed_call("vkQueueWaitIdle", result);
  return {};
}

}  // namespace fillrule::vulkan
