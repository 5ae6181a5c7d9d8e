// A Vulkan device with the program that cases are drawn with.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "cases/model/result.h"
#include "harness/run/run.h"
#include "reference/vulkan/check.h"
#include "reference/vulkan/reference.h"

namespace fillrule::run {

// `driver` as vulkan::DeviceInfo::driver names it; the error lists the devices there are.
Result<vulkan::Reference> open_device(const std::string& driver, const std::vector<std::string>& driver_files,
                                      bool validation);

// Draws the cases of these numbers. One that the device cannot draw is marked as skipped, with the reason; one that
// it breaks down at as failed.
std::vector<std::optional<Planes>> draw_batch(vulkan::Reference& device, std::span<const Case> cases,
                                              std::span<const size_t> batch, std::span<CaseResult> results);

}  // namespace fillrule::run
