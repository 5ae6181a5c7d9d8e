// The commands of `fillrule`, one file each. Every function adds its command to the application; when the command has
// been parsed, it runs and leaves the exit code.
#pragma once

#include <CLI/App.hpp>

namespace fillrule::cli {

// The exit codes, of every command.
enum ExitCode : int {
  kConforms = 0,
  kMismatch = 1,
  kBadInput = 2,     // a case file, a selector or the command line
  kNoReference = 3,  // no such reference device, or no display
};

void add_run(CLI::App& app, int& exit_code);
void add_merge(CLI::App& app, int& exit_code);
void add_list(CLI::App& app, int& exit_code);
void add_show(CLI::App& app, int& exit_code);
void add_devices(CLI::App& app, int& exit_code);
void add_features(CLI::App& app, int& exit_code);
void add_stress(CLI::App& app, int& exit_code);
void add_explain(CLI::App& app, int& exit_code);
void add_new(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_render(CLI::App& app, int& exit_code);
void add_view(CLI::App& app, int& exit_code);
void add_exhaust(CLI::App& app, int& exit_code);
void add_faults(CLI::App& app, int& exit_code);
void add_bench(CLI::App& app, int& exit_code);

}  // namespace fillrule::cli
