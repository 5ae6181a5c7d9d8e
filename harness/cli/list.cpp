#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "harness/report/printable.h"

namespace fillrule::cli {

void add_list(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("list", "list the names of cases");
  const auto options = std::make_shared<SuiteOptions>();
  add_suite_options(*command, *options);
  command->callback([options, &exit_code] {
    const format::Suite suite = load(*options);
    for (const Case& one : suite.cases) fmt::print("{}\n", report::printable(one.name));
    exit_code = suite.errors.empty() ? kConforms : kBadInput;
  });
}

}  // namespace fillrule::cli
