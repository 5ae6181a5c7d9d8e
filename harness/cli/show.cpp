#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "harness/cli/command.h"
#include "harness/cli/inspect.h"
#include "harness/cli/options.h"
#include "harness/cli/terminal.h"
#include "harness/report/pictures.h"
#include "harness/terminal/text.h"

namespace fillrule::cli {
namespace {

struct ShowOptions {
  SuiteOptions suite;
  PartyOptions parties;
  terminal::Wishes wishes;
  std::string folder = "build/show";
};

// Draws, judges, writes and tells of one case.
int show_case(const Case& one, run::SuiteRunner& runner, const run::RunResult& parties,
              const run::RunOptions& run_options, const ShowOptions& options) {
  const Result<run::Drawing> drawing = runner.draw(one);
  if (!drawing) {
    print_error(drawing.error());
    return kBadInput;
  }
  const auto paths = report::write_pictures(options.folder, one, *drawing);
  if (!paths) {
    print_error(paths.error());
    return kBadInput;
  }
  const bool failed = drawing->verdict.candidate_faults() > 0;
  run::CaseResult result{.name = one.name,
                         .file = one.file,
                         .status = failed ? run::Status::kFailed : run::Status::kPassed,
                         .verdict = drawing->verdict};
  add_commands(options.suite, run_options, result);
  result.show_command.clear();
  result.reason = reason_of(parties, run_options.profile, one, *drawing);
  const terminal::Style style = stdout_style(options.wishes);
  fmt::print("{}", terminal::case_text(result, style, inspection_text(one, *drawing, style)));
  for (const std::string& path : *paths) fmt::print("    {}\n", path);
  return failed ? kMismatch : kConforms;
}

int show_cases(const ShowOptions& options) {
  const format::Suite suite = load(options.suite);
  if (const Result<void> prepared = prepare_folder(options.folder); !prepared) {
    print_error(prepared.error());
    return kBadInput;
  }
  int exit_code = kConforms;
  const run::RunOptions run_options = against(options.parties, options.parties.references.front());
  Result<run::SuiteRunner> runner = create_runner(run_options, exit_code);
  if (!runner) return exit_code;
  exit_code = suite.errors.empty() ? kConforms : kBadInput;
  const run::RunResult parties = runner->run({});
  for (const Case& one : suite.cases) {
    exit_code = std::max(exit_code, show_case(one, *runner, parties, run_options, options));
  }
  return exit_code;
}

}  // namespace

void add_show(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("show", "write the pictures of cases, differing or not");
  const auto options = std::make_shared<ShowOptions>();
  add_suite_options(*command, options->suite);
  command->get_option("cases")->required();
  add_party_options(*command, options->parties);
  add_terminal_options(*command, options->wishes);
  command->add_option("--report", options->folder, "where the pictures go")->type_name("DIR")->capture_default_str();
  command->callback([options, &exit_code] { exit_code = show_cases(*options); });
}

}  // namespace fillrule::cli
