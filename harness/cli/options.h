// What several commands have in common: options, the suite, errors on the terminal.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "cases/format/suite.h"
#include "cases/model/result.h"
#include "harness/run/deviations.h"
#include "harness/run/suite_runner.h"

namespace fillrule::cli {

void print_error(const Error& error);

// Whole numbers from `least`, 0 or 1. (Those of CLI11 name a limit of 308 digits.)
CLI::Validator at_least(uint32_t least);

// `cases` below the current folder, or else that of the sources the command was built from.
std::string default_root();

// In single quotes for a POSIX shell, or for bash where the text has characters that must not reach a terminal.
std::string shell_quoted(const std::string& text);

// What names a case on a command line, quoted: by its name where its file is below `root`; else by the file, or, as
// one of a sweep has to be named, by the name from the folder that it is told from.
std::string case_selector(const std::string& file, const std::string& name, const std::string& root);

// Which cases.
struct SuiteOptions {
  std::vector<std::string> selectors;  // cases, files, folders, globs
  std::string root;                    // the folder that case names are relative to
};
void add_suite_options(CLI::App& command, SuiteOptions& options);

// The cases that were asked for. Errors are printed, and the other cases stay.
format::Suite load(const SuiteOptions& options, const format::Preview& preview = {});

// Who is judged against whom, and how strictly.
struct PartyOptions {
  run::RunOptions run;
  std::vector<std::string> references{"lavapipe"};  // drivers; none, or oracle, for the oracle alone
  std::vector<std::string> profiles;
};
void add_party_options(CLI::App& command, PartyOptions& options);

// --isa, the renderer's instruction set; refuses what this processor does not have.
void add_isa_option(CLI::App& command, renderer::Isa& isa);

// Vulkan drivers that are not installed in the system: what ci/swiftshader has fetched, if it has.
std::vector<std::string> driver_files();

// The runner, or else the error is printed and `exit_code` set. A candidate that is not there is a mistake on the
// command line; a device that is not there is not.
Result<run::SuiteRunner> create_runner(const run::RunOptions& options, int& exit_code);

bool is_driver(const std::string& reference);

// The commands that draw a case once more with the same parties, and that explain its worst sample if there is one
// beyond what is permitted; quoted for a shell.
void add_commands(const SuiteOptions& suite, const run::RunOptions& options, run::CaseResult& result);
// The same, of a case that is found by its file.
void add_commands(const run::RunOptions& options, run::CaseResult& result);

// Makes the folder if need be, and finds out whether files can be written there: before anything is drawn.
Result<void> prepare_folder(const std::string& folder);
// Likewise for a file; its folder must be there. Leaves nothing behind.
Result<void> check_writable(const std::string& file);

// The lists of known deviations, and whether what is not on them counts.
void add_deviation_options(CLI::App& command, std::string& expected_folder, bool& strict_reference);

// Whether the candidate does not conform, or with `strict_reference` the reference is not as it is listed.
bool has_failed(const run::RunResult& result, const run::DeviationReport& deviations, bool strict_reference);

// The options of a run against one of the references.
run::RunOptions against(const PartyOptions& options, const std::string& reference);

}  // namespace fillrule::cli
