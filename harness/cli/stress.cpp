#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "harness/cli/terminal.h"
#include "harness/run/deviations.h"
#include "harness/stress/stress.h"
#include "harness/terminal/text.h"

namespace fillrule::cli {
namespace {

struct StressCommandOptions {
  stress::StressOptions stress;
  std::vector<std::string> families;
  PartyOptions parties;
  std::string expected_folder = FILLRULE_SOURCE_DIR "/ci/expected";
  bool strict_reference = false;
};

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const stress::Family family : stress::all_families()) names.emplace_back(stress::name_of(family));
  return names;
}

void print_finding(const stress::Finding& finding, const run::RunOptions& run_options) {
  run::CaseResult result = finding.result;
  if (finding.message.empty()) add_commands(run_options, result);
  fmt::print("{}", terminal::case_text(result, {}));
  if (!finding.message.empty()) fmt::print(stderr, "{}\n", finding.message);
}

int stress_against(const StressCommandOptions& options, const run::RunOptions& run_options,
                   stress::StressOptions stress) {
  if (const Result<void> prepared = prepare_folder(stress.folder); !prepared) {
    print_error(prepared.error());
    return kBadInput;
  }
  int exit_code = kConforms;
  Result<run::SuiteRunner> runner = create_runner(run_options, exit_code);
  if (!runner) return exit_code;
  auto known = run::known_deviations(options.expected_folder, runner->run({}).reference);
  if (!known) {
    print_error(known.error());
    return kBadInput;
  }
  stress.known = std::move(*known);
  const stress::StressResult result =
      stress::run_stress(stress, *runner, progress_count(stress.triangles, "triangles"));
  for (const stress::Finding& finding : result.findings) print_finding(finding, run_options);
  fmt::print("{}{}", terminal::parties_text(result.run), stress::summary_text(result));
  const stress::FamilyCounts total = result.total();
  const bool written = std::ranges::all_of(result.findings, &std::string::empty, &stress::Finding::message);
  if (!written) return kBadInput;
  const bool reference_failed = options.strict_reference && total.unexpected_deviation_cases > 0;
  return total.failed_cases > 0 || reference_failed ? kMismatch : kConforms;
}

int run_stress(const StressCommandOptions& options) {
  stress::StressOptions stress = options.stress;
  for (const std::string& name : options.families) stress.families.push_back(stress::family_named(name).value());
  int exit_code = kConforms;
  const std::vector<std::string>& references = options.parties.references;
  for (const std::string& reference : references) {
    if (references.size() > 1) stress.folder = options.stress.folder + "/" + reference;
    // The higher code is the graver one.
    exit_code = std::max(exit_code, stress_against(options, against(options.parties, reference), stress));
  }
  return exit_code;
}

}  // namespace

void add_stress(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("stress", "judge random triangles by the million");
  const auto options = std::make_shared<StressCommandOptions>();
  add_party_options(*command, options->parties);
  run::RunOptions& run = options->parties.run;
  run.checks = false;  // they would take several times as long as the verdict
  run.jobs = std::max(std::thread::hardware_concurrency(), 1U);
  stress::StressOptions& stress = options->stress;
  command->add_option("--seed", stress.seed, "another one, other triangles")
      ->check(at_least(0))
      ->capture_default_str();
  command->add_option("--triangles", stress.triangles, "at least so many")->check(at_least(1))->capture_default_str();
  command->add_option("--families", options->families, "kinds of triangles; all if none")
      ->delimiter(',')
      ->check(CLI::IsMember(family_names()));
  command->add_option("--out", stress.folder, "where a case file for each fault goes, twenty a family at most")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--jobs", run.jobs, "cases judged at the same time")->check(CLI::Range(1, 1024));
  command->add_option("--expected", options->expected_folder, "where the lists of known deviations are")
      ->type_name("DIR");
  command->add_flag("--strict-reference", options->strict_reference,
                    "fail on a fault of the reference that is not on its list of known deviations");
  command->callback([options, &exit_code] { exit_code = run_stress(*options); });
}

}  // namespace fillrule::cli
