// Whether a device can draw a case at all: what Vulkan forbids and what is beyond the device's limits, found before
// the driver sees it. Errors name the key of the case file.
#pragma once

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "reference/vulkan/reference.h"

namespace fillrule::vulkan {

Result<void> check_case(const DeviceInfo& device, const Case& drawn);

}  // namespace fillrule::vulkan
