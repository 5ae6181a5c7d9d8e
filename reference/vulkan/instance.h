// The Vulkan instance, the validation layers' messages, and the devices that the loader finds.
// Vulkan specification, "Instances", "Physical Devices", "Debugging".
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "reference/vulkan/handles.h"
#include "reference/vulkan/reference.h"

namespace fillrule::vulkan {

// What the validation layers said. They may call from any thread.
class ValidationLog {
 public:
  void add(std::string message);
  std::vector<std::string> messages() const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> messages_;
};

struct PhysicalDevice {
  VkPhysicalDevice handle = VK_NULL_HANDLE;
  DeviceInfo info;
};

class Instance {
 public:
  // Result without a handle (get() is null) where no driver is installed at all.
  static Result<Instance> create(std::span<const std::string> driver_files, bool validation);

  Instance(Instance&&) = default;
  Instance& operator=(Instance&&) = delete;
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;
  ~Instance();

  [[nodiscard]] VkInstance get() const { return handle_.get(); }
  [[nodiscard]] const ValidationLog& log() const { return *log_; }
  [[nodiscard]] Result<std::vector<PhysicalDevice>> physical_devices() const;
  // The first device of the driver (DeviceInfo::driver). The error names the devices that are there.
  [[nodiscard]] Result<PhysicalDevice> choose_device(const std::string& driver) const;

 private:
  Instance() = default;
  Result<void> create_messenger(const VkDebugUtilsMessengerCreateInfoEXT& info);

  std::unique_ptr<ValidationLog> log_ = std::make_unique<ValidationLog>();
  InstanceHandle handle_;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

}  // namespace fillrule::vulkan
