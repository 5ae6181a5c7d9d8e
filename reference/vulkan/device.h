// The logical device with its one queue, its limits and its memory. Vulkan specification, "Devices and Queues",
// "Memory Allocation".
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reference/vulkan/instance.h"

namespace fillrule::vulkan {

// Formats of the attachments. The depth format is the case's.
inline constexpr VkFormat kHitsFormat = VK_FORMAT_R32_SFLOAT;
inline constexpr VkFormat kOwnerFormat = VK_FORMAT_R32_UINT;
inline constexpr VkFormat kSlotFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
// Colour attachments before the slots: hits and owner.
inline constexpr uint32_t kFirstSlotAttachment = 2;
// Vertex inputs beside the slots: position, point size, distances.
inline constexpr uint32_t kVertexInputsBesideSlots = 2 + kMaxClipAndCullDistances;

class Device {
 public:
  static Result<Device> create(const PhysicalDevice& physical);

  [[nodiscard]] VkDevice get() const { return handle_.get(); }
  [[nodiscard]] VkPhysicalDevice physical() const { return physical_; }
  [[nodiscard]] const DeviceInfo& info() const { return info_; }
  [[nodiscard]] VkQueue queue() const { return queue_; }
  [[nodiscard]] uint32_t queue_family() const { return queue_family_; }

  // Whether draws can set by themselves what DynamicState has.
  [[nodiscard]] bool has_dynamic_state() const { return has_dynamic_state_; }
  // How many vec4 slots one pass can write.
  [[nodiscard]] uint32_t slots_per_pass() const { return slots_per_pass_; }
  [[nodiscard]] uint64_t max_buffer_bytes() const { return max_buffer_bytes_; }
  [[nodiscard]] uint64_t max_storage_buffer_bytes() const { return max_storage_buffer_bytes_; }
  [[nodiscard]] uint64_t max_allocation_bytes() const { return max_allocation_bytes_; }
  // The memory that can still be allocated, as far as the device tells.
  [[nodiscard]] uint64_t available_bytes() const;

  // Memory of the first type that `requirements` allow and that has all of `wanted`, or else all of `needed`.
  [[nodiscard]] Result<Memory> allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags needed,
                                        VkMemoryPropertyFlags wanted) const;

 private:
  Device() = default;
  void read_limits();

  LogicalDevice handle_;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  DeviceInfo info_;
  VkQueue queue_ = VK_NULL_HANDLE;
  uint32_t queue_family_ = 0;
  uint32_t slots_per_pass_ = 0;
  uint64_t max_buffer_bytes_ = 0;
  uint64_t max_storage_buffer_bytes_ = 0;  // that one descriptor takes
  uint64_t max_allocation_bytes_ = 0;
  bool has_dynamic_state_ = false;
  bool has_memory_budget_ = false;
  VkPhysicalDeviceMemoryProperties memory_{};
};

// A buffer in host-visible, coherent memory that stays mapped.
class HostBuffer {
 public:
  HostBuffer() = default;
  static Result<HostBuffer> create(const Device& device, uint64_t bytes, VkBufferUsageFlags usage);

  [[nodiscard]] VkBuffer get() const { return buffer_.get(); }
  [[nodiscard]] uint64_t size() const { return bytes_.size(); }
  [[nodiscard]] std::span<std::byte> bytes() const { return bytes_; }

 private:
  Memory memory_;
  Buffer buffer_;
  std::span<std::byte> bytes_;
};

}  // namespace fillrule::vulkan
