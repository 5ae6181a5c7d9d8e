#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "harness/report/json.h"
#include "harness/report/pictures.h"
#include "harness/report/terminal.h"

namespace fillrule::cli {
namespace {

struct RunCommandOptions {
  SuiteOptions suite;
  PartyOptions parties;
  std::string report_folder;  // empty: none is written
  std::string json_file;      // empty: none is written
  bool verbose = false;
  bool quiet = false;
};

void print_results(const RunCommandOptions& options, const run::RunResult& result) {
  for (const run::CaseResult& one : result.cases) {
    const bool worth_telling = one.status != run::Status::kPassed || one.verdict.reference_faults() > 0;
    if (!options.quiet && (options.verbose || worth_telling)) fmt::print("{}", report::case_text(one));
  }
  fmt::print("{}", report::summary_text(result));
  if (options.parties.run.measure_alone) fmt::print("{}", report::timing_text(result));
}

bool print_if_failed(const Result<void>& result) {
  if (!result) print_error(result.error());
  return result.has_value();
}

// Pictures of every case at fault, drawn once more: whoever draws the same case twice gets the same bytes.
bool write_pictures(const std::string& folder, run::SuiteRunner& runner, const std::vector<Case>& cases,
                    const run::RunResult& result) {
  bool written = true;
  size_t count = 0;
  for (size_t i = 0; i < cases.size(); ++i) {
    const judge::CaseVerdict& verdict = result.cases[i].verdict;
    if (verdict.candidate_faults() == 0 && verdict.reference_faults() == 0) continue;
    const Result<run::Drawing> drawing = runner.draw(cases[i]);
    const auto paths = drawing ? report::write_pictures(folder, cases[i], *drawing)
                               : Result<std::vector<std::string>>(tl::unexpected(drawing.error()));
    if (!paths) print_error(paths.error());
    written = written && paths.has_value();
    count += paths ? 1 : 0;
  }
  if (count > 0) fmt::print("pictures of {} cases in {}\n", count, folder);
  return written;
}

Result<void> make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return tl::unexpected(Error{.file = folder, .what = "cannot be made: " + error.message()});
  return {};
}

// results.json and the pictures, wherever they were asked for.
bool write_report(const RunCommandOptions& options, run::SuiteRunner& runner, const std::vector<Case>& cases,
                  const run::RunResult& result) {
  const std::string json = report::to_json(result);
  bool written = options.json_file.empty() || print_if_failed(report::write_text(options.json_file, json));
  if (options.report_folder.empty()) return written;
  if (!print_if_failed(make_folder(options.report_folder))) return false;
  written = print_if_failed(report::write_text(options.report_folder + "/results.json", json)) && written;
  return write_pictures(options.report_folder, runner, cases, result) && written;
}

int run_cases(const RunCommandOptions& options) {
  const format::Suite suite = load(options.suite);
  int exit_code = kConforms;
  Result<run::SuiteRunner> runner = create_runner(options.parties, exit_code);
  if (!runner) return exit_code;
  const run::RunResult result = runner->run(suite.cases);
  print_results(options, result);
  const bool written = write_report(options, *runner, suite.cases, result);
  for (const std::string& message : runner->validation_messages()) fmt::print(stderr, "validation: {}\n", message);
  if (!suite.errors.empty()) fmt::print(stderr, "{} errors in case files or selectors\n", suite.errors.size());
  if (!written || !suite.errors.empty()) return kBadInput;
  return result.summary.failed > 0 ? kMismatch : kConforms;
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("run", "draw cases, judge them, and report");
  const auto options = std::make_shared<RunCommandOptions>();
  add_suite_options(*command, options->suite);
  add_party_options(*command, options->parties);
  run::RunOptions& run = options->parties.run;
  run.jobs = std::max(std::thread::hardware_concurrency(), 1U);
  command->add_option("--report", options->report_folder, "where results.json and the pictures of cases at fault go")
      ->type_name("DIR");
  command->add_option("--json", options->json_file, "write the results to this file too")->type_name("FILE");
  command->add_option("--jobs", run.jobs, "cases judged at the same time")->check(CLI::Range(1, 1024));
  command->add_flag("--checks,!--no-checks", run.checks, "run the metamorphic checks too (they are run unless forbidden)");
  command->add_flag("--timing", run.measure_alone, "tell where the time went, and what the reference alone takes");
  command->add_flag("--verbose,-v", options->verbose, "tell of every case, not only of failures");
  command->add_flag("--quiet,-q", options->quiet, "the summary alone");
  command->callback([options, &exit_code] { exit_code = run_cases(*options); });
}

}  // namespace fillrule::cli
