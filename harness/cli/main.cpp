#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>

#include "harness/cli/command.h"

int main(int argc, char** argv) {
  using namespace fillrule::cli;
  int exit_code = kConforms;
  try {
    CLI::App app("Fillrule: is this rasterizer right, pixel by pixel, and if not, who is wrong and why?", "fillrule");
    app.require_subcommand(1);
    app.fallthrough();
    app.footer("Exit codes: 0 conforms, 1 mismatch, 2 bad case or usage, 3 no such reference device.");
    add_run(app, exit_code);
    add_list(app, exit_code);
    add_show(app, exit_code);
    add_devices(app, exit_code);
    add_features(app, exit_code);
    add_stress(app, exit_code);
    add_explain(app, exit_code);
    add_exhaust(app, exit_code);
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
