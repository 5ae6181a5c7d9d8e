#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include "harness/cli/command.h"
#include "harness/cli/inspect.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/shard.h"
#include "harness/cli/terminal.h"
#include "harness/images/images.h"
#include "harness/report/failures.h"
#include "harness/run/counted.h"
#include "harness/run/deviations.h"
#include "harness/run/merge.h"
#include "harness/run/stopwatch.h"
#include "harness/terminal/text.h"
#include "harness/terminal/timing_text.h"

namespace fillrule::cli {
namespace {

// So many cases are shown with their map and their worst samples, unless all are asked for.
constexpr size_t kShownInFull = 10;

struct RunCommandOptions {
  SuiteOptions suite;
  PartyOptions parties;
  OutputOptions output;
  std::string faults_file;  // shown in the report; empty: the report's own faults.json, if it is there
  terminal::Wishes wishes;
  std::string shard;
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

bool has_fault(const run::CaseResult& result) {
  return result.verdict.candidate_faults() > 0 || result.verdict.reference_faults() > 0;
}

// Tells of each case that is to be told of, and finds out why the ones at fault are.
void tell_cases(const RunCommandOptions& options, const judge::Profile& profile, run::SuiteRunner& runner,
                const std::vector<Case>& cases, run::RunResult& result, const run::DeviationReport& deviations) {
  const terminal::Style style = stdout_style(options.wishes);
  size_t inspected = 0;
  for (size_t i = 0; i < cases.size(); ++i) {
    run::CaseResult& one = result.cases[i];
    const bool told = told_by_default(one, deviations);
    std::string inspection;
    if ((told || options.verbose) && has_fault(one)) {
      // A case that cannot be drawn again is told of without.
      if (const Result<run::Drawing> drawing = runner.draw(cases[i])) {
        one.reason = reason_of(result, profile, cases[i], *drawing);
        const bool in_full = !options.quiet && (options.verbose || inspected < kShownInFull);
        if (in_full) inspection = inspection_text(cases[i], *drawing, style);
      }
      ++inspected;
    }
    if (!options.quiet && (told || options.verbose)) fmt::print("{}", terminal::case_text(one, style, inspection));
  }
  if (!options.quiet && !options.verbose && inspected > kShownInFull) {
    fmt::print("the first {} of {} are shown with map and worst samples; --verbose shows all\n", kShownInFull,
               run::counted(inspected, "case"));
  }
}

void print_summary(const RunCommandOptions& options, const run::RunResult& result,
                   const run::DeviationReport& deviations) {
  fmt::print("{}", terminal::summary_text(result, stdout_style(options.wishes)));
  fmt::print("{}", terminal::deviations_text(result, deviations));
}

// The pictures and report.html, if there is a folder for them, and then the files that name them.
bool write_report(const RunCommandOptions& options, run::SuiteRunner& runner, const std::vector<Case>& cases,
                  const run::RunResult& result, const run::DeviationReport& deviations) {
  const std::string& folder = options.output.report_folder;
  if (folder.empty()) return write_output(options.output, result, deviations);
  const std::string faults = options.faults_file.empty() ? folder + "/faults.json" : options.faults_file;
  const report::FailureFiles files = report::write_failures(folder, faults, runner, options.parties.run.profile,
                                                            cases, result, deviations, options.parties.run.jobs);
  for (const Error& error : files.errors) print_error(error);
  if (files.cases > 0) fmt::print("pictures of {} in {}\n", run::counted(files.cases, "case"), folder);
  const bool written = write_output(options.output, result, deviations) && files.errors.empty();
  if (written) fmt::print("report: {}/report.html\n", folder);
  return written;
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
  return terminal::disagreements_text(runner->run(cases));
}

run::RunResult draw_and_judge(const RunCommandOptions& options, const run::RunOptions& run_options,
                              run::SuiteRunner& runner, const std::vector<Case>& cases, const run::Shard& shard) {
  ProgressLine progress(cases.size(), !options.quiet);
  run::RunResult result = runner.run(cases, [&progress] { progress.advance(); });
  result.shard = shard;
  for (run::CaseResult& one : result.cases) add_commands(options.suite, run_options, one);
  return result;
}

// What was found wrong with the files of cases as they were drawn, each thing once; whether there is any.
bool tell_bad_input(const std::vector<run::CaseResult>& cases) {
  std::set<std::string> told;
  for (const run::CaseResult& one : cases) {
    if (one.bad_input && told.insert(to_string(*one.bad_input)).second) print_error(*one.bad_input);
  }
  return !told.empty();
}

int run_against(const RunCommandOptions& options, const run::RunOptions& run_options, const std::vector<Case>& cases,
                const run::Shard& shard) {
  if (!can_write_output(options.output)) return kBadInput;
  int exit_code = kConforms;
  Result<run::SuiteRunner> runner = create_runner(run_options, exit_code);
  if (!runner) return exit_code;
  run::RunResult result = draw_and_judge(options, run_options, *runner, cases, shard);
  const auto known = run::known_deviations(options.expected_folder, result.reference);
  if (!known) print_error(known.error());
  run::DeviationReport deviations =
      run::compare_with_known(result.cases, known.value_or(std::vector<run::Deviation>{}));
  // Whether a fault is gone is seen only in all shards together.
  if (shard.total > 1) deviations.gone.clear();
  tell_cases(options, run_options.profile, *runner, cases, result, deviations);
  print_summary(options, result, deviations);
  const run::Stopwatch writing;
  const bool written = write_report(options, *runner, cases, result, deviations);
  if (run_options.measure_alone && !cases.empty()) {
    fmt::print("{}", terminal::timing_text(result.timing, result.summary.cases, writing.seconds()));
  }
  for (const std::string& message : runner->validation_messages()) fmt::print(stderr, "validation: {}\n", message);
  if (tell_bad_input(result.cases) || !written || !known) return kBadInput;
  return has_failed(result, deviations, options.strict_reference) ? kMismatch : kConforms;
}

void tell_count(const std::vector<Error>& errors) {
  if (errors.empty()) return;
  fmt::print(stderr, "{} in case files or selectors\n", run::counted(errors.size(), "error"));
}

// What reads images takes half a second to load, in which no driver can compile a shader. Beside the reading of case
// files it disturbs nobody. It is there when this returns: opening a device changes the environment.
format::Suite load_with_image_files(const SuiteOptions& options) {
  std::jthread loader;
  return load(options, [&](std::string_view case_file) {
    if (loader.joinable() || case_file.find("texture") == std::string_view::npos) return;
    loader = images::load_ahead();
  });
}

int run_cases(const RunCommandOptions& options) {
  Result<run::Shard> shard = choose_shard(options.shard);
  if (!shard) {
    print_error(shard.error());
    return kBadInput;
  }
  format::Suite suite = load_with_image_files(options.suite);
  shard->suite_cases = suite.cases.size();
  suite.cases = run::cases_of(*shard, std::move(suite.cases));
  const std::vector<std::string>& references = options.parties.references;
  int exit_code = suite.errors.empty() ? kConforms : kBadInput;
  // A shard without cases is in order; a suite without any is not, and the errors have said why.
  if (shard->suite_cases == 0) {
    tell_count(suite.errors);
    return kBadInput;
  }
  for (size_t i = 0; i < references.size(); ++i) {
    RunCommandOptions named = options;
    if (i > 0) named.output = with_suffix(options.output, references[i]);
    // The higher code is the graver one.
    exit_code = std::max(exit_code, run_against(named, against(options.parties, references[i]), suite.cases, *shard));
    // What the next driver may do to the process must not take this along.
    static_cast<void>(std::fflush(stdout));
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
  tell_count(suite.errors);
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
      ->add_option("--report", options->output.report_folder,
                   "where report.html, results.json and the pictures of cases at fault go")
      ->type_name("DIR");
  add_output_options(*command, options->output);
  command
      ->add_option(
          "--faults", options->faults_file,
          "a table that 'fillrule faults --json' wrote, to show in report.html (DIR/faults.json if it is there)")
      ->type_name("FILE");
  add_terminal_options(*command, options->wishes);
  command
      ->add_option("--shard", options->shard,
                   "run this part of the suite, 1/4 to 4/4 of four (GTEST_TOTAL_SHARDS and GTEST_SHARD_INDEX do as "
                   "well); 'fillrule merge' joins the reports")
      ->type_name("I/N");
  command->add_option("--jobs", run.jobs, "cases judged at the same time")->check(CLI::Range(1, 1024));
  command->add_flag("--checks,!--no-checks", run.checks,
                    "run the metamorphic checks too (they are run unless forbidden)");
  command->add_flag("--timing", run.measure_alone, "tell where the time went, and what the reference alone takes");
  add_deviation_options(*command, options->expected_folder, options->strict_reference);
  command->add_flag("--verbose,-v", options->verbose, "tell of every case, not only of failures");
  command->add_flag("--quiet,-q", options->quiet, "the summary alone");
  command->callback([options, &exit_code] { exit_code = run_cases(*options); });
}

}  // namespace fillrule::cli
