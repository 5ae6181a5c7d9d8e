// Vulkan handles that destroy themselves, and VkResult as an Error. Vulkan specification, "Object Lifetime".
#pragma once

#include <vulkan/vulkan_core.h>

#include <string_view>
#include <utility>

#include "cases/model/result.h"

namespace fillrule::vulkan {

// A failed call as an Error: "vkCreateImage: ErrorOutOfDeviceMemory".
tl::unexpected<Error> failed_call(std::string_view call, VkResult result);

// A handle without a parent: an instance or a device.
template <typename Handle, void (*Destroy)(Handle, const VkAllocationCallbacks*)>
class RootHandle {
 public:
  RootHandle() = default;
  explicit RootHandle(Handle handle) : handle_(handle) {}
  RootHandle(RootHandle&& other) noexcept : handle_(std::exchange(other.handle_, VK_NULL_HANDLE)) {}
  RootHandle& operator=(RootHandle&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  RootHandle(const RootHandle&) = delete;
  RootHandle& operator=(const RootHandle&) = delete;
  ~RootHandle() {
    if (handle_ != VK_NULL_HANDLE) Destroy(handle_, nullptr);
  }

  [[nodiscard]] Handle get() const { return handle_; }

 private:
  Handle handle_ = VK_NULL_HANDLE;
};

// A handle that belongs to a device, which must outlive it.
template <typename Handle, void (*Destroy)(VkDevice, Handle, const VkAllocationCallbacks*)>
class DeviceHandle {
 public:
  DeviceHandle() = default;
  DeviceHandle(VkDevice device, Handle handle) : device_(device), handle_(handle) {}
  DeviceHandle(DeviceHandle&& other) noexcept
      : device_(other.device_), handle_(std::exchange(other.handle_, VK_NULL_HANDLE)) {}
  DeviceHandle& operator=(DeviceHandle&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    return *this;
  }
  DeviceHandle(const DeviceHandle&) = delete;
  DeviceHandle& operator=(const DeviceHandle&) = delete;
  ~DeviceHandle() {
    if (handle_ != VK_NULL_HANDLE) Destroy(device_, handle_, nullptr);
  }

  [[nodiscard]] Handle get() const { return handle_; }

 private:
  VkDevice device_ = VK_NULL_HANDLE;
  Handle handle_ = VK_NULL_HANDLE;
};

using InstanceHandle = RootHandle<VkInstance, vkDestroyInstance>;
using LogicalDevice = RootHandle<VkDevice, vkDestroyDevice>;
using Buffer = DeviceHandle<VkBuffer, vkDestroyBuffer>;
using CommandPool = DeviceHandle<VkCommandPool, vkDestroyCommandPool>;
using DescriptorPool = DeviceHandle<VkDescriptorPool, vkDestroyDescriptorPool>;
using DescriptorSetLayout = DeviceHandle<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using Fence = DeviceHandle<VkFence, vkDestroyFence>;
using Image = DeviceHandle<VkImage, vkDestroyImage>;
using ImageView = DeviceHandle<VkImageView, vkDestroyImageView>;
using Memory = DeviceHandle<VkDeviceMemory, vkFreeMemory>;
using Pipeline = DeviceHandle<VkPipeline, vkDestroyPipeline>;
using PipelineLayout = DeviceHandle<VkPipelineLayout, vkDestroyPipelineLayout>;
using Sampler = DeviceHandle<VkSampler, vkDestroySampler>;
using ShaderModule = DeviceHandle<VkShaderModule, vkDestroyShaderModule>;

}  // namespace fillrule::vulkan
