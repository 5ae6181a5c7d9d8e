// The command line of `fillrule`, parsed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/run/suite_runner.h"

namespace fillrule::cli {

// The exit codes, of every command.
enum ExitCode : int {
  kConforms = 0,
  kMismatch = 1,
  kBadInput = 2,     // a case file, a selector or the command line
  kNoReference = 3,  // no such reference device
};

enum class Command : uint8_t { kRun, kList, kShow, kDevices };

struct Arguments {
  Command command = Command::kRun;
  std::vector<std::string> selectors;  // cases, files, folders, globs
  std::string suite;                   // the folder that case names are relative to
  std::string report_folder;           // empty: none is written
  std::string json_file;               // empty: none is written
  run::RunOptions run;
  bool timing = false;
  bool verbose = false;
  bool quiet = false;
};

// Parses, or prints help or an error and returns the exit code in `exit_code`.
bool parse_arguments(int argc, const char* const* argv, Arguments& arguments, int& exit_code);

}  // namespace fillrule::cli
