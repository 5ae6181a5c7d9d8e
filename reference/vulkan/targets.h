// The attachments of a pass, and a pool of them: allocating and first touching memory costs more than drawing.
// Vulkan specification, "Images", "Dynamic Rendering".
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "reference/vulkan/device.h"

namespace fillrule::vulkan {

// What attachments are alike in.
struct TargetKey {
  uint32_t width = 0;                            // pixels
  uint32_t height = 0;                           // pixels
  VkFormat depth_format = VK_FORMAT_D32_SFLOAT;  // VK_FORMAT_UNDEFINED: no depth attachment
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
  uint32_t slots = 0;  // or a colour, which is like one
  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm at the comparison with zero
  auto operator<=>(const TargetKey&) const = default;
};

struct Attachment {
  Image image;
  ImageView view;
  VkFormat format = VK_FORMAT_UNDEFINED;
  uint32_t bytes_per_sample = 0;
};

// The images of one pass in one allocation.
class TargetSet {
 public:
  // Fails, naming the key, where the device cannot have such images.
  static Result<TargetSet> create(const Device& device, const TargetKey& key);

  [[nodiscard]] const TargetKey& key() const { return key_; }
  // Hits, owner, then the slots; the depth attachment last, if there is one.
  [[nodiscard]] const std::vector<Attachment>& attachments() const { return attachments_; }
  [[nodiscard]] bool has_depth() const { return key_.depth_format != VK_FORMAT_UNDEFINED; }
  [[nodiscard]] bool is_multisampled() const { return key_.samples != VK_SAMPLE_COUNT_1_BIT; }
  [[nodiscard]] uint64_t bytes() const { return bytes_; }

 private:
  TargetSet() = default;
  Result<void> add_image(const Device& device, VkFormat format, uint32_t bytes_per_sample);
  Result<void> bind_memory(const Device& device);

  TargetKey key_;
  Memory memory_;  // before the images, so that it goes after them
  std::vector<Attachment> attachments_;
  uint64_t bytes_ = 0;
};

// What an attachment is for: to be drawn to, and to be copied or, with several samples, read by a shader.
VkImageUsageFlags attachment_usage(VkFormat format, VkSampleCountFlagBits samples);

// What the images of `key` take, alignment aside.
uint64_t estimated_bytes(const TargetKey& key);

// Keeps sets that are not in use, up to `capacity_bytes`, the least recently used going first.
class TargetPool {
 public:
  TargetPool(const Device& device, uint64_t capacity_bytes) : device_(&device), capacity_bytes_(capacity_bytes) {}

  Result<TargetSet> acquire(const TargetKey& key);
  void release(TargetSet set);

 private:
  // Frees idle sets until `bytes` more would fit.
  void make_room(uint64_t bytes);

  const Device* device_;
  uint64_t capacity_bytes_;
  uint64_t bytes_ = 0;  // in use and idle
  std::vector<TargetSet> idle_;
};

}  // namespace fillrule::vulkan
