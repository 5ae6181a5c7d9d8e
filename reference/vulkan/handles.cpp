#include "reference/vulkan/handles.h"

#include <fmt/format.h>

#include <vulkan/vulkan.hpp>

namespace fillrule::vulkan {

tl::unexpected<Error> failed_call(std::string_view call, VkResult result) {
  return failure(fmt::format("{}: {}", call, vk::to_string(static_cast<vk::Result>(result))));
}

}  // namespace fillrule::vulkan
