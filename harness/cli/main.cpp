#include <fmt/core.h>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>

#include "cases/format/suggestion.h"
#include "harness/cli/command.h"
#include "harness/cli/crash_report.h"
#include "harness/cli/options.h"

namespace {

// CLI11 says of a misspelt command only that one is missing. Options may stand before it.
fillrule::Result<void> check_command(const CLI::App& app, const std::string& given) {
  std::vector<std::string> names;
  for (const CLI::App* const command : app.get_subcommands({})) names.push_back(command->get_name());
  if (given.starts_with('-') || std::ranges::find(names, given) != names.end()) return {};
  return fillrule::failure(fmt::format("there is no command \"{}\"", given),
                           fillrule::format::suggestion(given, names, "the commands are"));
}

// Planes of pictures come and go by the thousand. To give them back to the system and ask again, page by page, was
// some twentieth of a run's samples in a profile.
void keep_freed_memory() {
#if defined(__GLIBC__)
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
  mallopt(M_TOP_PAD, 16 << 20);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  using namespace fillrule::cli;
  int exit_code = kConforms;
  report_crashes();
  keep_freed_memory();
  try {
    CLI::App app("Fillrule: is this rasterizer right, pixel by pixel, and if not, who is wrong and why?", "fillrule");
    app.require_subcommand(1);
    app.fallthrough();
    app.footer("Exit codes: 0 conforms, 1 mismatch, 2 bad case or usage, 3 no such reference device, or no display.");
    add_run(app, exit_code);
    add_merge(app, exit_code);
    add_list(app, exit_code);
    add_show(app, exit_code);
    add_devices(app, exit_code);
    add_features(app, exit_code);
    add_stress(app, exit_code);
    add_explain(app, exit_code);
    add_new(app, exit_code);
    add_check(app, exit_code);
    add_exhaust(app, exit_code);
    add_faults(app, exit_code);
    add_bench(app, exit_code);
    add_render(app, exit_code);
    add_view(app, exit_code);
    const std::string given = argc > 1 ? argv[1] : "-";
    if (const auto known = check_command(app, given); !known) {
      print_error(known.error());
      return kBadInput;
    }
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      // CLI11's own codes are many; everything but a request for help is bad usage.
      return app.exit(error, std::cout, std::cerr) == 0 ? kConforms : kBadInput;
    }
  } catch (const std::exception& error) {
    // Out of memory, mostly: nothing of ours throws.
    fmt::print(stderr, "fillrule: {}\n", error.what());
    return kBadInput;
  }
  return exit_code;
}
