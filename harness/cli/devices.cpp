#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "reference/vulkan/reference.h"

namespace fillrule::cli {
namespace {

int list_devices() {
  const auto devices = vulkan::list_devices(driver_files());
  if (!devices || devices->empty()) {
    if (!devices) print_error(devices.error());
    fmt::print(stderr,
               "no Vulkan device was found\n  hint: install a driver, such as the package mesa-vulkan-drivers\n");
    return kNoReference;
  }
  for (const vulkan::DeviceInfo& device : *devices) {
    fmt::print("{:<12} {}, {}, {} subpixel bits, targets up to {} px\n", device.driver, device.name,
               device.driver_version, device.subpixel_bits, device.max_target_size);
  }
  return kConforms;
}

}  // namespace

void add_devices(CLI::App& app, int& exit_code) {
  app.add_subcommand("devices", "list the reference devices there are")->callback([&exit_code] {
    exit_code = list_devices();
  });
}

}  // namespace fillrule::cli
