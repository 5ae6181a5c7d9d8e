#include "reference/vulkan/targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace fillrule::vulkan {
namespace {

constexpr uint32_t kScalarBytes = 4;
constexpr uint32_t kSlotBytes = 16;

Result<void> check_image(const Device& device, const TargetKey& key, VkFormat format, uint32_t bytes_per_sample) {
  VkImageFormatProperties properties{};
  const VkResult result =
      vkGetPhysicalDeviceImageFormatProperties(device.physical(), format, VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL,
                                               attachment_usage(format, key.samples), 0, &properties);
  const bool has_samples = result == VK_SUCCESS && (properties.sampleCounts & key.samples) != 0;
  if (result == VK_ERROR_FORMAT_NOT_SUPPORTED || (result == VK_SUCCESS && !has_samples)) {
    return failure(fmt::format("target.samples: {} has no depth format {} with {} samples", device.info().driver,
                               static_cast<int>(format), static_cast<int>(key.samples)));
  }
  if (result != VK_SUCCESS) return failed_call("vkGetPhysicalDeviceImageFormatProperties", result);
  const uint64_t bytes = uint64_t{key.width} * key.height * key.samples * bytes_per_sample;
  const bool is_multisampled = key.samples != VK_SAMPLE_COUNT_1_BIT;
  const uint64_t max_bytes = is_multisampled
                                 ? std::min<uint64_t>(properties.maxResourceSize, device.max_storage_buffer_bytes())
                                 : properties.maxResourceSize;
  if (key.width > properties.maxExtent.width || key.height > properties.maxExtent.height || bytes > max_bytes) {
    return failure(fmt::format("target.size: an image of {} x {} pixels of {} bytes is beyond the limits of {}",
                               key.width, key.height, bytes_per_sample * key.samples, device.info().name),
                   fmt::format("the device's limits are {} x {} pixels and {} MiB", properties.maxExtent.width,
                               properties.maxExtent.height, max_bytes >> 20U));
  }
  return {};
}

}  // namespace

VkImageUsageFlags attachment_usage(VkFormat format, VkSampleCountFlagBits samples) {
  const bool is_color = format == kHitsFormat || format == kOwnerFormat || format == kSlotFormat;
  return (is_color ? VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT : VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT) |
         (samples == VK_SAMPLE_COUNT_1_BIT ? VK_IMAGE_USAGE_TRANSFER_SRC_BIT : VK_IMAGE_USAGE_SAMPLED_BIT);
}

uint64_t estimated_bytes(const TargetKey& key) {
  const uint64_t scalars = key.depth_format == VK_FORMAT_UNDEFINED ? 2 : 3;
  return uint64_t{key.width} * key.height * key.samples * (scalars * kScalarBytes + uint64_t{key.slots} * kSlotBytes);
}

Result<TargetSet> TargetSet::create(const Device& device, const TargetKey& key) {
  TargetSet set;
  set.key_ = key;
  Result<void> added = set.add_image(device, kHitsFormat, kScalarBytes);
  if (added) added = set.add_image(device, kOwnerFormat, kScalarBytes);
  for (uint32_t i = 0; added && i < key.slots; ++i) added = set.add_image(device, kSlotFormat, kSlotBytes);
  if (added && set.has_depth()) added = set.add_image(device, key.depth_format, kScalarBytes);
  if (added) added = set.bind_memory(device);
  if (!added) return tl::unexpected(added.error());
  return set;
}

Result<void> TargetSet::add_image(const Device& device, VkFormat format, uint32_t bytes_per_sample) {
  if (auto checked = check_image(device, key_, format, bytes_per_sample); !checked) return checked;
  const VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                               .imageType = VK_IMAGE_TYPE_2D,
                               .format = format,
                               .extent = {key_.width, key_.height, 1},
                               .mipLevels = 1,
                               .arrayLayers = 1,
                               .samples = key_.samples,
                               .tiling = VK_IMAGE_TILING_OPTIMAL,
                               .usage = attachment_usage(format, key_.samples)};
  VkImage image = VK_NULL_HANDLE;
  const VkResult result = vkCreateImage(device.get(), &info, nullptr, &image);
  if (result != VK_SUCCESS) return failed_call("vkCreateImage", result);
  attachments_.push_back(
      {.image = Image(device.get(), image), .format = format, .bytes_per_sample = bytes_per_sample});
  return {};
}

Result<void> TargetSet::bind_memory(const Device& device) {
  VkMemoryRequirements all{.size = 0, .alignment = 1, .memoryTypeBits = ~0U};
  std::vector<VkDeviceSize> offsets;
  for (const Attachment& attachment : attachments_) {
    VkMemoryRequirements one;
    vkGetImageMemoryRequirements(device.get(), attachment.image.get(), &one);
    offsets.push_back((all.size + one.alignment - 1) / one.alignment * one.alignment);
    all.size = offsets.back() + one.size;
    all.alignment = std::max(all.alignment, one.alignment);
    all.memoryTypeBits &= one.memoryTypeBits;
  }
  bytes_ = all.size;
  Result<Memory> memory = device.allocate(all, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  if (!memory) return tl::unexpected(memory.error());
  memory_ = std::move(*memory);
  for (size_t i = 0; i < attachments_.size(); ++i) {
    Attachment& attachment = attachments_[i];
    VkResult result = vkBindImageMemory(device.get(), attachment.image.get(), memory_.get(), offsets[i]);
    if (result != VK_SUCCESS) return failed_call("vkBindImageMemory", result);
    const bool is_depth = has_depth() && i + 1 == attachments_.size();
    const VkImageAspectFlags aspect = is_depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
    const VkImageViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                     .image = attachment.image.get(),
                                     .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                     .format = attachment.format,
                                     .subresourceRange = {.aspectMask = aspect, .levelCount = 1, .layerCount = 1}};
    VkImageView view = VK_NULL_HANDLE;
    result = vkCreateImageView(device.get(), &info, nullptr, &view);
    if (result != VK_SUCCESS) return failed_call("vkCreateImageView", result);
    attachment.view = ImageView(device.get(), view);
  }
  return {};
}

Result<TargetSet> TargetPool::acquire(const TargetKey& key) {
  // From the back: what was used last is the likeliest to be in the processor's cache.
  for (size_t i = idle_.size(); i-- > 0;) {
    if (idle_[i].key() != key) continue;
    TargetSet set = std::move(idle_[i]);
    idle_.erase(idle_.begin() + static_cast<ptrdiff_t>(i));
    return set;
  }
  make_room(estimated_bytes(key));
  Result<TargetSet> set = TargetSet::create(*device_, key);
  if (set) bytes_ += set->bytes();
  return set;
}

void TargetPool::release(TargetSet set) {
  idle_.push_back(std::move(set));
  make_room(0);
}

void TargetPool::make_room(uint64_t bytes) {
  size_t freed = 0;
  while (freed < idle_.size() && bytes_ + bytes > capacity_bytes_) {
    bytes_ -= idle_[freed].bytes();
    ++freed;
  }
  idle_.erase(idle_.begin(), idle_.begin() + static_cast<ptrdiff_t>(freed));
}

}  // namespace fillrule::vulkan
