#include "reference/vulkan/color_target.h"

#include <fmt/format.h>

#include <utility>

#include "reference/vulkan/color_pipeline.h"

namespace fillrule::vulkan {
namespace {

struct ImageKind {
  VkFormat format;
  uint32_t samples;
  VkImageUsageFlags usage;
};

VkImageSubresourceRange whole_image(VkFormat format) {
  const VkImageAspectFlags aspect = format == kColorFormat ? VK_IMAGE_ASPECT_COLOR_BIT : VK_IMAGE_ASPECT_DEPTH_BIT;
  return {.aspectMask = aspect, .levelCount = 1, .layerCount = 1};
}

Result<BoundImage> create_image(const Device& device, uint32_t size, const ImageKind& kind) {
  BoundImage bound;
  const VkImageCreateInfo image_info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                     .imageType = VK_IMAGE_TYPE_2D,
                                     .format = kind.format,
                                     .extent = {size, size, 1},
                                     .mipLevels = 1,
                                     .arrayLayers = 1,
                                     .samples = static_cast<VkSampleCountFlagBits>(kind.samples),
                                     .tiling = VK_IMAGE_TILING_OPTIMAL,
                                     .usage = kind.usage};
  VkImage image = VK_NULL_HANDLE;
  VkResult result = vkCreateImage(device.get(), &image_info, nullptr, &image);
  if (result != VK_SUCCESS) return failed_call("vkCreateImage", result);
  bound.image = Image(device.get(), image);

  VkMemoryRequirements requirements;
  vkGetImageMemoryRequirements(device.get(), image, &requirements);
  Result<Memory> memory = device.allocate(requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  if (!memory) return tl::unexpected(memory.error());
  bound.memory = std::move(*memory);
  result = vkBindImageMemory(device.get(), image, bound.memory.get(), 0);
  if (result != VK_SUCCESS) return failed_call("vkBindImageMemory", result);

  constexpr VkImageUsageFlags kAttachment =
      VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  if ((kind.usage & kAttachment) == 0) return bound;
  const VkImageViewCreateInfo view_info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                        .image = image,
                                        .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                        .format = kind.format,
                                        .subresourceRange = whole_image(kind.format)};
  VkImageView view = VK_NULL_HANDLE;
  result = vkCreateImageView(device.get(), &view_info, nullptr, &view);
  if (result != VK_SUCCESS) return failed_call("vkCreateImageView", result);
  bound.view = ImageView(device.get(), view);
  return bound;
}

// One step of an image's life: what has to be over before, what comes after.
struct Step {
  VkImage image;
  VkFormat format;
  VkImageLayout from;
  VkImageLayout to;
  VkPipelineStageFlags2 after;
  VkAccessFlags2 written;
  VkPipelineStageFlags2 before;
  VkAccessFlags2 accessed;
};

void record_step(VkCommandBuffer commands, const Step& step) {
  const VkImageMemoryBarrier2 barrier{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                      .srcStageMask = step.after,
                                      .srcAccessMask = step.written,
                                      .dstStageMask = step.before,
                                      .dstAccessMask = step.accessed,
                                      .oldLayout = step.from,
                                      .newLayout = step.to,
                                      .image = step.image,
                                      .subresourceRange = whole_image(step.format)};
  const VkDependencyInfo info{
      .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier};
  vkCmdPipelineBarrier2(commands, &info);
}

// Hazard: the host reads after the copy has written.
void record_host_barrier(VkCommandBuffer commands) {
  const VkMemoryBarrier2 barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                                 .srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT,
                                 .srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                 .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT,
                                 .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT};
  const VkDependencyInfo info{
      .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &barrier};
  vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace

Result<ColorTarget> ColorTarget::create(const Device& device, uint32_t size, uint32_t samples) {
  if (size == 0 || size > device.info().max_target_size) {
    return failure(
        fmt::format("a target of {} x {} pixels is beyond the limits of {}", size, size, device.info().name),
        fmt::format("at most {}", device.info().max_target_size));
  }
  ColorTarget target;
  target.size_ = size;
  target.samples_ = samples;
  const auto create = [&](BoundImage& image, const ImageKind& kind) -> Result<void> {
    Result<BoundImage> made = create_image(device, size, kind);
    if (!made) return tl::unexpected(made.error());
    image = std::move(*made);
    return {};
  };
  constexpr VkImageUsageFlags kCopied = VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  const Result<void> made =
      create(target.color_, {kColorFormat, samples, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | kCopied})
          .and_then([&] {
            return create(target.depth_, {kColorDepthFormat, samples, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT});
          })
          .and_then([&]() -> Result<void> {
            if (samples == 1) return {};
            return create(target.resolved_, {kColorFormat, 1, VK_IMAGE_USAGE_TRANSFER_DST_BIT | kCopied});
          });
  if (!made) return tl::unexpected(made.error());
  return target;
}

void ColorTarget::record_begin(VkCommandBuffer commands) const {
  // Hazards: the clears write after the layouts' transitions have; the draw before this one was waited for.
  record_step(commands, {color_.image.get(), kColorFormat, VK_IMAGE_LAYOUT_UNDEFINED,
                         VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL, VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE,
                         VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT});
  record_step(commands,
              {depth_.image.get(), kColorDepthFormat, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL,
               VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE,
               VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
               VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT});
  const VkRenderingAttachmentInfo color{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                        .imageView = color_.view.get(),
                                        .imageLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL,
                                        .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                        .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
  const VkRenderingAttachmentInfo depth{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                        .imageView = depth_.view.get(),
                                        .imageLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL,
                                        .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                        .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                                        .clearValue = {.depthStencil = {.depth = 1.0F}}};
  const VkRenderingInfo rendering{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                                  .renderArea = {.extent = {size_, size_}},
                                  .layerCount = 1,
                                  .colorAttachmentCount = 1,
                                  .pColorAttachments = &color,
                                  .pDepthAttachment = &depth};
  vkCmdBeginRendering(commands, &rendering);
}

void ColorTarget::record_copy(VkCommandBuffer commands, VkBuffer readback) const {
  const VkImageSubresourceLayers layers{.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT, .layerCount = 1};
  // Hazard: the resolve or copy reads after the draw, of a submission before, has stored.
  record_step(commands, {color_.image.get(), kColorFormat, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL,
                         VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                         VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                         VK_ACCESS_2_TRANSFER_READ_BIT});
  VkImage source = color_.image.get();
  if (samples_ > 1) {
    // Hazards: the resolve writes after the transition has, and the copy reads after the resolve.
    record_step(commands, {resolved_.image.get(), kColorFormat, VK_IMAGE_LAYOUT_UNDEFINED,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE,
                           VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT});
    const VkImageResolve region{.srcSubresource = layers, .dstSubresource = layers, .extent = {size_, size_, 1}};
    vkCmdResolveImage(commands, color_.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, resolved_.image.get(),
                      VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    record_step(commands,
                {resolved_.image.get(), kColorFormat, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                 VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                 VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT});
    source = resolved_.image.get();
  }
  const VkBufferImageCopy region{.imageSubresource = layers, .imageExtent = {size_, size_, 1}};
  vkCmdCopyImageToBuffer(commands, source, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readback, 1, &region);
  record_host_barrier(commands);
}

}  // namespace fillrule::vulkan
