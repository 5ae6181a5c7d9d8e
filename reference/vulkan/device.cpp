#include "reference/vulkan/device.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "reference/vulkan/features.h"
#include "reference/vulkan/packing.h"

namespace fillrule::vulkan {
namespace {

std::optional<uint32_t> graphics_queue_family(VkPhysicalDevice device) {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  // Every device with graphics has a family of both.
  const VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  for (uint32_t i = 0; i < count; ++i) {
    if ((families[i].queueFlags & needed) == needed) return i;
  }
  return std::nullopt;
}

// What the device lacks of that which every case needs; empty if nothing.
std::string missing_ability(const PhysicalDevice& physical) {
  if (physical.info.api_version < VK_API_VERSION_1_3) return "Vulkan 1.3";
  const DeviceFeatures features(physical.handle);
  if (features.vulkan13().dynamicRendering == VK_FALSE) return "the feature dynamicRendering";
  if (features.vulkan13().synchronization2 == VK_FALSE) return "the feature synchronization2";
  // SPIR-V 1.6 gives the size of a workgroup in a way that wants it.
  if (features.vulkan13().maintenance4 == VK_FALSE) return "the feature maintenance4";
  if (features.core().independentBlend == VK_FALSE) return "the feature independentBlend";
  if (features.core().fullDrawIndexUint32 == VK_FALSE) return "the feature fullDrawIndexUint32";
  VkFormatProperties format;
  vkGetPhysicalDeviceFormatProperties(physical.handle, kHitsFormat, &format);
  if ((format.optimalTilingFeatures & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT) == 0) {
    return "blending on R32_SFLOAT";
  }
  return {};
}

}  // namespace

Result<Device> Device::create(const PhysicalDevice& physical) {
  if (const std::string missing = missing_ability(physical); !missing.empty()) {
    return failure(fmt::format("the device {} does not have {}", physical.info.name, missing));
  }
  const std::optional<uint32_t> family = graphics_queue_family(physical.handle);
  if (!family) return failure(fmt::format("the device {} has no graphics queue", physical.info.name));

  Device device;
  device.physical_ = physical.handle;
  device.info_ = physical.info;
  device.queue_family_ = *family;
  device.has_memory_budget_ = has_extension(physical.handle, VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
  device.read_limits();

  const float priority = 1.0F;
  const VkDeviceQueueCreateInfo queue_info{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                           .queueFamilyIndex = *family,
                                           .queueCount = 1,
                                           .pQueuePriorities = &priority};
  const DeviceFeatures features(physical.handle);
  device.has_dynamic_state_ = features.has_dynamic_state();
  std::vector<const char*> extensions = features.extensions();
  if (device.has_memory_budget_) extensions.push_back(VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
  const VkDeviceCreateInfo device_info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                       .pNext = &features.chain(),
                                       .queueCreateInfoCount = 1,
                                       .pQueueCreateInfos = &queue_info,
                                       .enabledExtensionCount = static_cast<uint32_t>(extensions.size()),
                                       .ppEnabledExtensionNames = extensions.data()};
  VkDevice handle = VK_NULL_HANDLE;
  if (const VkResult result = vkCreateDevice(physical.handle, &device_info, nullptr, &handle); result != VK_SUCCESS) {
    return failed_call("vkCreateDevice", result);
  }
  device.handle_ = LogicalDevice(handle);
  vkGetDeviceQueue(handle, *family, 0, &device.queue_);
  return device;
}

void Device::read_limits() {
  VkPhysicalDeviceMaintenance4Properties maintenance4{.sType =
                                                          VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_PROPERTIES};
  VkPhysicalDeviceMaintenance3Properties maintenance3{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES, .pNext = &maintenance4};
  VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                         .pNext = &maintenance3};
  vkGetPhysicalDeviceProperties2(physical_, &properties);
  vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
  const VkPhysicalDeviceLimits& limits = properties.properties.limits;
  // Beside slots there are hits and owner at one end; position, point size and distances at the other.
  slots_per_pass_ = std::min({limits.maxColorAttachments - kFirstSlotAttachment,
                              limits.maxFragmentOutputAttachments - kFirstSlotAttachment,
                              limits.maxVertexInputAttributes - kVertexInputsBesideSlots});
  max_storage_buffer_bytes_ = limits.maxStorageBufferRange;
  max_buffer_bytes_ = maintenance4.maxBufferSize;
  max_allocation_bytes_ = maintenance3.maxMemoryAllocationSize;
}

uint64_t Device::available_bytes() const {
  uint64_t available = 0;
  VkPhysicalDeviceMemoryBudgetPropertiesEXT budget{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT};
  VkPhysicalDeviceMemoryProperties2 memory{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2};
  if (has_memory_budget_) memory.pNext = &budget;
  vkGetPhysicalDeviceMemoryProperties2(physical_, &memory);
  for (uint32_t i = 0; i < memory.memoryProperties.memoryHeapCount; ++i) {
    const uint64_t size = memory.memoryProperties.memoryHeaps[i].size;
    const uint64_t left = budget.heapBudget[i] - std::min(budget.heapBudget[i], budget.heapUsage[i]);
    available += has_memory_budget_ ? std::min(size, left) : size;
  }
  return available;
}

Result<Memory> Device::allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags needed,
                                VkMemoryPropertyFlags wanted) const {
  if (requirements.size > max_allocation_bytes_) {
    return failure(fmt::format("an allocation of {} MiB is beyond the device's limit of {} MiB",
                               requirements.size >> 20U, max_allocation_bytes_ >> 20U));
  }
  for (const VkMemoryPropertyFlags flags : {wanted, needed}) {
    for (uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
      if ((requirements.memoryTypeBits >> i & 1U) == 0) continue;
      if ((memory_.memoryTypes[i].propertyFlags & flags) != flags) continue;
      const VkMemoryAllocateInfo allocate_info{
          .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = requirements.size, .memoryTypeIndex = i};
      VkDeviceMemory memory = VK_NULL_HANDLE;
      const VkResult result = vkAllocateMemory(get(), &allocate_info, nullptr, &memory);
      if (result != VK_SUCCESS) return failed_call("vkAllocateMemory", result);
      return Memory(get(), memory);
    }
  }
  return failure("the device has no memory of the type needed");
}

Result<HostBuffer> HostBuffer::create(const Device& device, uint64_t bytes, VkBufferUsageFlags usage) {
  if (bytes > device.max_buffer_bytes()) {
    return failure(fmt::format("a buffer of {} MiB is beyond the device's limit of {} MiB", bytes >> 20U,
                               device.max_buffer_bytes() >> 20U));
  }
  const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = bytes, .usage = usage};
  VkBuffer handle = VK_NULL_HANDLE;
  VkResult result = vkCreateBuffer(device.get(), &info, nullptr, &handle);
  if (result != VK_SUCCESS) return failed_call("vkCreateBuffer", result);
  HostBuffer buffer;
  buffer.buffer_ = Buffer(device.get(), handle);

  VkMemoryRequirements requirements;
  vkGetBufferMemoryRequirements(device.get(), handle, &requirements);
  const VkMemoryPropertyFlags needed = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  Result<Memory> memory = device.allocate(requirements, needed, needed | VK_MEMORY_PROPERTY_HOST_CACHED_BIT);
  if (!memory) return tl::unexpected(memory.error());
  buffer.memory_ = std::move(*memory);
  result = vkBindBufferMemory(device.get(), handle, buffer.memory_.get(), 0);
  if (result != VK_SUCCESS) return failed_call("vkBindBufferMemory", result);

  void* mapped = nullptr;
  result = vkMapMemory(device.get(), buffer.memory_.get(), 0, VK_WHOLE_SIZE, 0, &mapped);
  if (result != VK_SUCCESS) return failed_call("vkMapMemory", result);
  buffer.bytes_ = {static_cast<std::byte*>(mapped), bytes};
  return buffer;
}

}  // namespace fillrule::vulkan
