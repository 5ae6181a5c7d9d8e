#include "harness/cli/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      result += c;
    }
  }
  return result + "'";
}

bool is_below(const std::string& path, const std::string& folder) {
  std::error_code error;
  const auto relative = std::filesystem::relative(path, folder, error);
  return !error && !relative.empty() && *relative.begin() != "..";
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
  command
      .add_option("--candidate", run.candidate,
                  "who is judged: renderer, renderer:scanline (fills by scanlines), or a driver")
      ->capture_default_str();
  command
      .add_option("--reference", options.references,
                  "drivers as 'fillrule devices' names them, one or more; oracle or none: the oracle judges alone")
      ->delimiter(',')
      ->allow_extra_args(false)
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
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"top_left", "precise", "same_bits"}));
}

std::vector<std::string> driver_files() {
  const std::string file = FILLRULE_SOURCE_DIR "/build/swiftshader/vk_swiftshader_icd.json";
  return std::filesystem::exists(file) ? std::vector{file} : std::vector<std::string>{};
}

Result<run::SuiteRunner> create_runner(const run::RunOptions& options, int& exit_code) {
  exit_code = kNoReference;
  Result<run::SuiteRunner> runner = run::SuiteRunner::create(options);
  if (runner) return runner;
  print_error(runner.error());
  run::CandidateOptions candidate_options = options.candidate_options;
  candidate_options.driver_files = options.driver_files;
  if (!run::make_candidate(options.candidate, candidate_options)) exit_code = kBadInput;
  return runner;
}

std::string show_command(const SuiteOptions& suite, const run::RunOptions& options, const Case& one) {
  const run::RunOptions defaults;
  // A case of another folder than the suite's is found by its file.
  const bool by_name = is_below(one.file, suite.root);
  std::string command = "fillrule show " + quoted(by_name ? one.name : one.file);
  if (by_name && suite.root != default_root()) command += " --suite " + quoted(suite.root);
  if (options.candidate != defaults.candidate) command += " --candidate " + quoted(options.candidate);
  if (options.reference != defaults.reference) command += " --reference " + quoted(options.reference);
  if (options.candidate_options.subpixel_bits != defaults.candidate_options.subpixel_bits) {
    command += fmt::format(" --subpixel-bits {}", options.candidate_options.subpixel_bits);
  }
  std::vector<std::string> profiles;
  if (options.profile.top_left) profiles.emplace_back("top_left");
  if (options.profile.precise) profiles.emplace_back("precise");
  if (options.profile.same_bits) profiles.emplace_back("same_bits");
  if (!profiles.empty()) command += fmt::format(" --profile {}", fmt::join(profiles, ","));
  return command;
}

bool is_driver(const std::string& reference) {
  return reference != run::kNoReference && reference != "oracle";
}

run::RunOptions against(const PartyOptions& options, const std::string& reference) {
  run::RunOptions run = options.run;
  run.profile = profile_of(options.profiles);
  run.reference = is_driver(reference) ? reference : run::kNoReference;
  return run;
}

}  // namespace fillrule::cli
