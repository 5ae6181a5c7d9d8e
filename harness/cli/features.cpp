#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "cases/model/features.h"
#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "harness/programs/varyings.h"
#include "reference/exact/features.h"
#include "reference/vulkan/reference.h"

namespace fillrule::cli {
namespace {

struct Column {
  std::string party;
  FeatureSet features;
};

// One row for each feature that a case may need beyond filled triangles, one column for each party.
int print_features() {
  const auto devices = vulkan::list_devices(driver_files());
  if (!devices) print_error(devices.error());
  std::vector<Column> columns{{"renderer", programs::renderer_features()}, {"oracle", exact::oracle_features()}};
  if (devices) {
    for (const vulkan::DeviceInfo& device : *devices) columns.push_back({device.driver, device.features});
  }
  size_t name_width = 0;
  size_t key_width = 0;
  for (const FeatureName& row : kFeatures) {
    name_width = std::max(name_width, row.name.size());
    key_width = std::max(key_width, row.key.size());
  }
  fmt::print("{:<{}}  {:<{}}", "feature", name_width, "key of a case", key_width);
  for (const Column& column : columns) fmt::print("  {}", column.party);
  fmt::print("\n");
  for (const FeatureName& row : kFeatures) {
    fmt::print("{:<{}}  {:<{}}", row.name, name_width, row.key, key_width);
    for (const Column& column : columns) {
      fmt::print("  {:<{}}", column.features.has(row.feature) ? "yes" : "-", column.party.size());
    }
    fmt::print("\n");
  }
  return devices ? kConforms : kNoReference;
}

}  // namespace

void add_features(CLI::App& app, int& exit_code) {
  app.add_subcommand("features", "what the renderer, the oracle and each reference device can draw")
      ->callback([&exit_code] { exit_code = print_features(); });
}

}  // namespace fillrule::cli
