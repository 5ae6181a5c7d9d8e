// Opens a Vulkan device with the program that cases are drawn with.
#pragma once

#include <string>
#include <vector>

#include "cases/model/result.h"
#include "reference/vulkan/check.h"
#include "reference/vulkan/reference.h"

namespace fillrule::run {

// `driver` as vulkan::DeviceInfo::driver names it; the error lists the devices there are.
Result<vulkan::Reference> open_device(const std::string& driver, const std::vector<std::string>& driver_files,
                                      bool validation);

}  // namespace fillrule::run
