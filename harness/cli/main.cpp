#include <cstdio>
#include <exception>

#include "harness/cli/arguments.h"
#include "harness/cli/commands.h"

int main(int argc, char** argv) {
  try {
    fillrule::cli::Arguments arguments;
    int exit_code = 0;
    if (!fillrule::cli::parse_arguments(argc, argv, arguments, exit_code)) return exit_code;
    return fillrule::cli::execute(arguments);
  } catch (const std::exception& error) {
    // Out of memory, mostly: nothing else throws.
    std::fprintf(stderr, "fillrule: %s\n", error.what());
    return fillrule::cli::kBadInput;
  }
}
