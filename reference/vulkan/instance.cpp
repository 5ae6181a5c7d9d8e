#include "reference/vulkan/instance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "reference/vulkan/features.h"

namespace fillrule::vulkan {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

struct DriverName {
  VkDriverId id;
  std::string_view name;
};

// The short names by which drivers are chosen.
constexpr std::array kDriverNames = {
    DriverName{VK_DRIVER_ID_MESA_LLVMPIPE, "lavapipe"},
    DriverName{VK_DRIVER_ID_GOOGLE_SWIFTSHADER, "swiftshader"},
    DriverName{VK_DRIVER_ID_MESA_RADV, "radv"},
    DriverName{VK_DRIVER_ID_AMD_OPEN_SOURCE, "amdvlk"},
    DriverName{VK_DRIVER_ID_AMD_PROPRIETARY, "amd"},
    DriverName{VK_DRIVER_ID_INTEL_OPEN_SOURCE_MESA, "anv"},
    DriverName{VK_DRIVER_ID_NVIDIA_PROPRIETARY, "nvidia"},
    DriverName{VK_DRIVER_ID_MESA_NVK, "nvk"},
    DriverName{VK_DRIVER_ID_MESA_TURNIP, "turnip"},
    DriverName{VK_DRIVER_ID_MESA_V3DV, "v3dv"},
    DriverName{VK_DRIVER_ID_MESA_PANVK, "panvk"},
    DriverName{VK_DRIVER_ID_MESA_VENUS, "venus"},
    DriverName{VK_DRIVER_ID_MESA_DOZEN, "dozen"},
    DriverName{VK_DRIVER_ID_MOLTENVK, "moltenvk"},
};

std::string driver_name(VkDriverId id) {
  const auto* const found = std::ranges::find(kDriverNames, id, &DriverName::id);
  return found == kDriverNames.end() ? fmt::format("driver-{}", static_cast<uint32_t>(id)) : std::string(found->name);
}

// Sets what the loader and the drivers read from the environment, keeping what the user has set.
void prepare_environment(std::span<const std::string> driver_files) {
  // Mesa would write a shader cache into the home folder.
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
  // Lavapipe (Mesa 22.3) damages the heap with rasterizer threads: a fence counts as signalled, and may be freed, as
  // soon as the last of them has counted itself, which then still writes to the fence's condition and mutex. With
  // none, the thread that submits rasterizes; for targets of our sizes that takes no longer.
  setenv("LP_NUM_THREADS", "0", 0);

  const char* const before = std::getenv("VK_ADD_DRIVER_FILES");
  std::string files = before == nullptr ? "" : before;
  for (const std::string& file : driver_files) {
    if (fmt::format(":{}:", files).find(fmt::format(":{}:", file)) != std::string::npos) continue;
    if (!files.empty()) files += ':';
    files += file;
  }
  // Nothing is written where nothing changes: other threads may run when a further device is opened.
  if (!files.empty() && (before == nullptr || files != before)) setenv("VK_ADD_DRIVER_FILES", files.c_str(), 1);
}

VKAPI_ATTR VkBool32 VKAPI_CALL keep_message(VkDebugUtilsMessageSeverityFlagBitsEXT /*severity*/,
                                            VkDebugUtilsMessageTypeFlagsEXT /*type*/,
                                            const VkDebugUtilsMessengerCallbackDataEXT* data, void* log) {
  static_cast<ValidationLog*>(log)->add(data->pMessage);
  return VK_FALSE;
}

bool layer_is_installed(std::string_view name) {
  uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  layers.resize(count);
  return std::ranges::any_of(layers, [&](const VkLayerProperties& layer) { return layer.layerName == name; });
}

// The driver's own text, or where it has none the version number, by Vulkan's packing.
std::string version_of(const VkPhysicalDeviceDriverProperties& driver, const VkPhysicalDeviceProperties& properties) {
  if (driver.driverInfo[0] != '\0') return driver.driverInfo;
  const uint32_t version = properties.driverVersion;
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

DeviceInfo describe(VkPhysicalDevice device) {
  VkPhysicalDeviceDriverProperties driver{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceProperties2 properties2{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  VkPhysicalDeviceProperties& properties = properties2.properties;
  vkGetPhysicalDeviceProperties(device, &properties);
  // The driver tells its name from Vulkan 1.2 on.
  if (properties.apiVersion >= VK_API_VERSION_1_2) {
    properties2.pNext = &driver;
    vkGetPhysicalDeviceProperties2(device, &properties2);
  }
  VkPhysicalDeviceFeatures features;
  vkGetPhysicalDeviceFeatures(device, &features);

  FeatureSet for_cases;
  if (properties.apiVersion >= VK_API_VERSION_1_3) for_cases = DeviceFeatures(device).for_cases();

  const VkPhysicalDeviceLimits& limits = properties.limits;
  const uint32_t max_target_size =
      std::min({limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight});
  return {.name = properties.deviceName,
          .driver = driver_name(driver.driverID),
          .driver_id = driver.driverID,
          .driver_version = version_of(driver, properties),
          .api_version = properties.apiVersion,
          .subpixel_bits = limits.subPixelPrecisionBits,
          .max_target_size = max_target_size,
          .max_viewport_size = {limits.maxViewportDimensions[0], limits.maxViewportDimensions[1]},
          .viewport_bounds = {limits.viewportBoundsRange[0], limits.viewportBoundsRange[1]},
          .line_widths = {.min = limits.lineWidthRange[0],
                          .max = limits.lineWidthRange[1],
                          .step = limits.lineWidthGranularity},
          .point_sizes = {.min = limits.pointSizeRange[0],
                          .max = limits.pointSizeRange[1],
                          .step = limits.pointSizeGranularity},
          .features = for_cases,
          .has_primitive_id = features.geometryShader == VK_TRUE};
}

}  // namespace

void ValidationLog::add(std::string message) {
  const std::lock_guard lock(mutex_);
  messages_.push_back(std::move(message));
}

std::vector<std::string> ValidationLog::messages() const {
  const std::lock_guard lock(mutex_);
  return messages_;
}

Result<Instance> Instance::create(std::span<const std::string> driver_files, bool validation) {
  prepare_environment(driver_files);
  if (validation && !layer_is_installed(kValidationLayer)) {
    return failure(fmt::format("the layer {} is not installed", kValidationLayer),
                   "install the package vulkan-validationlayers");
  }
  Instance instance;
  const VkDebugUtilsMessengerCreateInfoEXT messenger{
      .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
      .messageSeverity =
          VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
      .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT,
      .pfnUserCallback = keep_message,
      .pUserData = instance.log_.get()};
  const std::array enabled = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  const VkValidationFeaturesEXT features{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                         .pNext = &messenger,
                                         .enabledValidationFeatureCount = static_cast<uint32_t>(enabled.size()),
                                         .pEnabledValidationFeatures = enabled.data()};
  const std::array extensions = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
  const VkApplicationInfo application{
      .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .pApplicationName = "fillrule", .apiVersion = VK_API_VERSION_1_3};
  const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                  .pNext = validation ? &features : nullptr,
                                  .pApplicationInfo = &application,
                                  .enabledLayerCount = validation ? 1U : 0U,
                                  .ppEnabledLayerNames = &kValidationLayer,
                                  .enabledExtensionCount = validation ? static_cast<uint32_t>(extensions.size()) : 0U,
                                  .ppEnabledExtensionNames = extensions.data()};
  VkInstance handle = VK_NULL_HANDLE;
  const VkResult result = vkCreateInstance(&info, nullptr, &handle);
  // How the loader says that it found no driver.
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER) return instance;
  if (result != VK_SUCCESS) return failed_call("vkCreateInstance", result);
  instance.handle_ = InstanceHandle(handle);
  if (validation) {
    if (auto created = instance.create_messenger(messenger); !created) return tl::unexpected(created.error());
  }
  return instance;
}

Instance::~Instance() {
  if (handle_.get() == VK_NULL_HANDLE || messenger_ == VK_NULL_HANDLE) return;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): how Vulkan hands out functions of extensions
  const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(handle_.get(), "vkDestroyDebugUtilsMessengerEXT"));
  if (destroy != nullptr) destroy(handle_.get(), messenger_, nullptr);
}

Result<void> Instance::create_messenger(const VkDebugUtilsMessengerCreateInfoEXT& info) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): how Vulkan hands out functions of extensions
  const auto create_function = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(handle_.get(), "vkCreateDebugUtilsMessengerEXT"));
  if (create_function == nullptr)
    return failed_call("vkCreateDebugUtilsMessengerEXT", VK_ERROR_EXTENSION_NOT_PRESENT);
  const VkResult result = create_function(handle_.get(), &info, nullptr, &messenger_);
  if (result != VK_SUCCESS) return failed_call("vkCreateDebugUtilsMessengerEXT", result);
  return {};
}

Result<std::vector<PhysicalDevice>> Instance::physical_devices() const {
  if (get() == VK_NULL_HANDLE) return std::vector<PhysicalDevice>{};
  uint32_t count = 0;
  VkResult result = vkEnumeratePhysicalDevices(get(), &count, nullptr);
  std::vector<VkPhysicalDevice> handles(count);
  if (result == VK_SUCCESS && count > 0) result = vkEnumeratePhysicalDevices(get(), &count, handles.data());
  // Drivers without hardware: the loader found manifests, but none of them answers.
  if (result == VK_ERROR_INITIALIZATION_FAILED) return std::vector<PhysicalDevice>{};
  if (result < VK_SUCCESS) return failed_call("vkEnumeratePhysicalDevices", result);
  handles.resize(count);
  std::vector<PhysicalDevice> devices;
  devices.reserve(count);
  for (VkPhysicalDevice handle : handles) devices.push_back({.handle = handle, .info = describe(handle)});
  return devices;
}

Result<PhysicalDevice> Instance::choose_device(const std::string& driver) const {
  const auto devices = physical_devices();
  if (!devices) return tl::unexpected(devices.error());
  const auto found =
      std::ranges::find_if(*devices, [&](const PhysicalDevice& device) { return device.info.driver == driver; });
  if (found != devices->end()) return *found;
  if (devices->empty()) {
    return failure(fmt::format("no Vulkan device of the driver '{}': no device at all was found", driver),
                   "install a driver, such as the package mesa-vulkan-drivers");
  }
  std::vector<std::string> names;
  names.reserve(devices->size());
  for (const PhysicalDevice& device : *devices) {
    names.push_back(fmt::format("'{}' ({})", device.info.driver, device.info.name));
  }
  return failure(fmt::format("no Vulkan device of the driver '{}'", driver),
                 fmt::format("the devices found are {}", fmt::join(names, ", ")));
}

Result<std::vector<DeviceInfo>> list_devices(std::span<const std::string> driver_files) {
  const Result<Instance> instance = Instance::create(driver_files, false);
  if (!instance) return tl::unexpected(instance.error());
  const Result<std::vector<PhysicalDevice>> devices = instance->physical_devices();
  if (!devices) return tl::unexpected(devices.error());
  std::vector<DeviceInfo> infos;
  infos.reserve(devices->size());
  for (const PhysicalDevice& device : *devices) infos.push_back(device.info);
  return infos;
}

}  // namespace fillrule::vulkan
