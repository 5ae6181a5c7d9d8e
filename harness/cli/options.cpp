#include "harness/cli/options.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "harness/cli/command.h"

namespace fillrule::cli {
namespace {

// `cases` below the current folder, or else that of the sources the command was built from.
std::string default_root() {
  const std::string here = "cases";
  return std::filesystem::is_directory(here) ? here : FILLRULE_SOURCE_DIR "/cases";
}

judge::Profile profile_of(const std::vector<std::string>& names) {
  const auto named = [&names](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return {.top_left = named("top_left"), .precise = named("precise"), .same_bits = named("same_bits")};
}

}  // namespace

void print_error(const Error& error) {
  fmt::print(stderr, "{}\n", to_string(error));
}

void add_suite_options(CLI::App& command, SuiteOptions& options) {
  options.root = default_root();
  command
      .add_option(
          "cases", options.selectors,
          "names (coverage/shared_diagonal, 'clipping/near_plane[angle=30]', with * and ? as wildcards), files "
          "or folders; the whole suite if none")
      ->type_name("CASE");
  command.add_option("--suite", options.root, "the folder that case names are relative to")->type_name("DIR");
}

format::Suite load(const SuiteOptions& options) {
  format::Suite suite = format::load_suite(options.root, options.selectors);
  for (const Error& error : suite.errors) print_error(error);
  return suite;
}

void add_party_options(CLI::App& command, PartyOptions& options) {
  run::RunOptions& run = options.run;
  run.driver_files = driver_files();
  command.add_option("--candidate", run.candidate, "who is judged: renderer")->capture_default_str();
  command.add_option("--reference", run.reference, "a driver as 'fillrule devices' names it, or none")
      ->capture_default_str();
  command.add_option("--subpixel-bits", run.candidate_options.subpixel_bits, "of the candidate")
      ->check(CLI::Range(4, 8))
      ->capture_default_str();
  command.add_option("--threads", run.candidate_options.threads, "that the candidate draws one case with")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command.add_flag("--validation", run.validation, "load Vulkan's validation layers");
  command
      .add_option("--profile", options.profiles,
                  "more than the specification asks for: top_left (ties by the top-left rule), precise (imprecise "
                  "values fail), same_bits (unclipped coverage equal to the reference's)")
      ->delimiter(',')
      ->check(CLI::IsMember({"top_left", "precise", "same_bits"}));
}

std::vector<std::string> driver_files() {
  const std::string file = FILLRULE_SOURCE_DIR "/build/swiftshader/vk_swiftshader_icd.json";
  return std::filesystem::exists(file) ? std::vector{file} : std::vector<std::string>{};
}

Result<run::SuiteRunner> create_runner(const PartyOptions& options, int& exit_code) {
  run::RunOptions run = options.run;
  run.profile = profile_of(options.profiles);
  exit_code = run::make_candidate(run.candidate, run.candidate_options) ? kNoReference : kBadInput;
  Result<run::SuiteRunner> runner = run::SuiteRunner::create(run);
  if (!runner) print_error(runner.error());
  return runner;
}

}  // namespace fillrule::cli
