#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "harness/report/failures.h"
#include "harness/report/json.h"
#include "harness/report/terminal.h"
#include "harness/report/timing_text.h"
#include "harness/run/counted.h"
#include "harness/run/deviations.h"
#include "harness/run/stopwatch.h"

namespace fillrule::cli {
namespace {

struct RunCommandOptions {
  SuiteOptions suite;
  PartyOptions parties;
  std::string report_folder;    // empty: none is written
  std::string json_file;        // empty: none is written
  std::string faults_file;      // shown in the report; empty: the report's own faults.json, if it is there
  std::string expected_folder;  // lists of known deviations
  bool strict_reference = false;
  bool verbose = false;
  bool quiet = false;
};

bool told_by_default(const run::CaseResult& result, const run::DeviationReport& deviations) {
  const auto& unexpected = deviations.unexpected;
  return result.status != run::Status::kPassed ||
         std::any_of(unexpected.begin(), unexpected.end(),
                     [&result](const run::DeviationReport::Fault& fault) { return fault.case_name == result.name; });
}

void print_results(const RunCommandOptions& options, const run::RunResult& result,
                   const run::DeviationReport& deviations) {
  for (const run::CaseResult& one : result.cases) {
    if (options.quiet || !(options.verbose || told_by_default(one, deviations))) continue;
    fmt::print("{}", report::case_text(one));
  }
  fmt::print("{}", report::summary_text(result));
  fmt::print("{}", report::deviations_text(result, deviations));
}

bool print_if_failed(const Result<void>& result) {
  if (!result) print_error(result.error());
  return result.has_value();
}

// Before the run, which may be long.
bool can_write_report(const RunCommandOptions& options) {
  return (options.json_file.empty() || print_if_failed(check_writable(options.json_file))) &&
         (options.report_folder.empty() || print_if_failed(prepare_folder(options.report_folder)));
}

// results.json, report.html and the pictures, wherever they were asked for.
bool write_report(const RunCommandOptions& options, run::SuiteRunner& runner, const std::vector<Case>& cases,
                  const run::RunResult& result, const run::DeviationReport& deviations) {
  const std::string json = report::to_json(result, deviations);
  bool written = options.json_file.empty() || print_if_failed(report::write_text(options.json_file, json));
  if (options.report_folder.empty()) return written;
  written = print_if_failed(report::write_text(options.report_folder + "/results.json", json)) && written;
  const std::string faults =
      options.faults_file.empty() ? options.report_folder + "/faults.json" : options.faults_file;
  const report::FailureFiles files = report::write_failures(options.report_folder, faults, runner,
                                                            options.parties.run.profile, cases, result, deviations);
  for (const Error& error : files.errors) print_error(error);
  if (files.cases > 0) fmt::print("pictures of {} in {}\n", run::counted(files.cases, "case"), options.report_folder);
  return files.errors.empty() && written;
}

// Where two references draw differently, and which of them is wrong if one is.
Result<std::string> compare_references(const RunCommandOptions& options, const std::string& first,
                                       const std::string& second, const std::vector<Case>& cases) {
  run::RunOptions pair = against(options.parties, second);
  pair.candidate = first;
  pair.profile = {};
  pair.checks = false;
  pair.measure_alone = false;
  Result<run::SuiteRunner> runner = run::SuiteRunner::create(pair);
  if (!runner) return tl::unexpected(runner.error());
  return report::disagreements_text(runner->run(cases));
}

// Where the results of the second and further references go: DIR becomes DIR/<driver>, FILE.json FILE-<driver>.json.
RunCommandOptions with_suffix(RunCommandOptions options, const std::string& suffix) {
  if (!options.report_folder.empty()) options.report_folder += "/" + suffix;
  if (!options.json_file.empty()) {
    const std::filesystem::path path(options.json_file);
    options.json_file =
        (path.parent_path() / (path.stem().string() + "-" + suffix + path.extension().string())).string();
  }
  return options;
}

int run_against(const RunCommandOptions& options, const run::RunOptions& run_options,
                const std::vector<Case>& cases) {
  if (!can_write_report(options)) return kBadInput;
  int exit_code = kConforms;
  Result<run::SuiteRunner> runner = create_runner(run_options, exit_code);
  if (!runner) return exit_code;
  run::RunResult result = runner->run(cases);
  for (run::CaseResult& one : result.cases) add_commands(options.suite, run_options, one);
  const auto known = run::known_deviations(options.expected_folder, result.reference);
  if (!known) print_error(known.error());
  const run::DeviationReport deviations =
      run::compare_with_known(result.cases, known.value_or(std::vector<run::Deviation>{}));
  print_results(options, result, deviations);
  const run::Stopwatch writing;
  const bool written = write_report(options, *runner, cases, result, deviations);
  if (run_options.measure_alone) {
    fmt::print("{}", report::timing_text(result.timing, result.summary.cases, writing.seconds()));
  }
  for (const std::string& message : runner->validation_messages()) fmt::print(stderr, "validation: {}\n", message);
  if (!written || !known) return kBadInput;
  const bool reference_failed = !deviations.unexpected.empty() || !deviations.gone.empty();
  return result.summary.failed > 0 || (options.strict_reference && reference_failed) ? kMismatch : kConforms;
}

int run_cases(const RunCommandOptions& options) {
  const format::Suite suite = load(options.suite);
  const std::vector<std::string>& references = options.parties.references;
  int exit_code = suite.errors.empty() ? kConforms : kBadInput;
  for (size_t i = 0; i < references.size(); ++i) {
    const RunCommandOptions named = i == 0 ? options : with_suffix(options, references[i]);
    // The higher code is the graver one.
    exit_code = std::max(exit_code, run_against(named, against(options.parties, references[i]), suite.cases));
  }
  // The drivers against each other. Their faults are known from above, so this decides nothing.
  std::vector<std::string> drivers;
  std::copy_if(references.begin(), references.end(), std::back_inserter(drivers), is_driver);
  for (size_t i = 0; i < drivers.size(); ++i) {
    for (size_t j = i + 1; j < drivers.size(); ++j) {
      const Result<std::string> text = compare_references(options, drivers[i], drivers[j], suite.cases);
      if (text) fmt::print("{}", *text);
    }
  }
  if (!suite.errors.empty()) {
    fmt::print(stderr, "{} in case files or selectors\n", run::counted(suite.errors.size(), "error"));
  }
  return exit_code;
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("run", "draw cases, judge them, and report");
  const auto options = std::make_shared<RunCommandOptions>();
  add_suite_options(*command, options->suite);
  add_party_options(*command, options->parties);
  run::RunOptions& run = options->parties.run;
  run.jobs = std::max(std::thread::hardware_concurrency(), 1U);
  command
      ->add_option("--report", options->report_folder,
                   "where report.html, results.json and the pictures of cases at fault go")
      ->type_name("DIR");
  command
      ->add_option(
          "--faults", options->faults_file,
          "a table that 'fillrule faults --json' wrote, to show in report.html (DIR/faults.json if it is there)")
      ->type_name("FILE");
  command->add_option("--json", options->json_file, "write the results to this file too")->type_name("FILE");
  command->add_option("--jobs", run.jobs, "cases judged at the same time")->check(CLI::Range(1, 1024));
  command->add_flag("--checks,!--no-checks", run.checks,
                    "run the metamorphic checks too (they are run unless forbidden)");
  command->add_flag("--timing", run.measure_alone, "tell where the time went, and what the reference alone takes");
  command->add_flag(
      "--strict-reference", options->strict_reference,
      "fail on a fault of the reference that is not on its list of known deviations, and on a listed one "
      "that no longer occurs");
  options->expected_folder = FILLRULE_SOURCE_DIR "/ci/expected";
  command->add_option("--expected", options->expected_folder, "where the lists of known deviations are")
      ->type_name("DIR");
  command->add_flag("--verbose,-v", options->verbose, "tell of every case, not only of failures");
  command->add_flag("--quiet,-q", options->quiet, "the summary alone");
  command->callback([options, &exit_code] { exit_code = run_cases(*options); });
}

}  // namespace fillrule::cli
