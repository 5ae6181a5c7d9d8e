#include "harness/cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "harness/cli/command.h"
#include "harness/report/printable.h"
#include "harness/scene/build.h"

namespace fillrule::cli {
namespace {

std::vector<std::string> profile_names() {
  std::vector<std::string> names;
  names.reserve(judge::kProfileParts.size());
  for (const judge::ProfilePart& part : judge::kProfileParts) names.emplace_back(part.name);
  return names;
}

judge::Profile profile_of(const std::vector<std::string>& names) {
  judge::Profile profile;
  for (const judge::ProfilePart& part : judge::kProfileParts) {
    profile.*part.member = std::find(names.begin(), names.end(), part.name) != names.end();
  }
  return profile;
}

bool is_below(const std::string& path, const std::string& folder) {
  std::error_code error;
  const auto relative = std::filesystem::relative(path, folder, error);
  return !error && !relative.empty() && *relative.begin() != "..";
}

// The options that name the same parties and profile.
std::string party_flags(const run::RunOptions& options) {
  const run::RunOptions defaults;
  std::string flags;
  if (options.candidate != defaults.candidate) flags += " --candidate " + shell_quoted(options.candidate);
  if (options.reference != defaults.reference) flags += " --reference " + shell_quoted(options.reference);
  if (options.candidate_options.subpixel_bits != defaults.candidate_options.subpixel_bits) {
    flags += fmt::format(" --subpixel-bits {}", options.candidate_options.subpixel_bits);
  }
  if (const std::string profile = to_string(options.profile); !profile.empty()) flags += " --profile " + profile;
  return flags;
}

// `selector` is what names the case, quoted.
void add_commands_for(const std::string& selector, const run::RunOptions& options, run::CaseResult& result) {
  const std::string flags = party_flags(options);
  result.show_command = fmt::format("fillrule show {}{}", selector, flags);
  const std::optional<judge::SampleRecord> worst = result.verdict.worst();
  if (!worst) return;
  result.explain_command = fmt::format("fillrule explain {} --pixel {},{}", selector, worst->x, worst->y);
  if (worst->sample != 0) result.explain_command += fmt::format(" --sample {}", worst->sample);
  result.explain_command += flags;
}

}  // namespace

CLI::Validator at_least(uint32_t least) {
  const auto check = [least](const std::string& text) {
    const bool whole = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    const bool zero = text.find_first_not_of('0') == std::string::npos;
    return whole && !(zero && least > 0) ? std::string() : fmt::format("not a whole number from {}: {}", least, text);
  };
  return {check, "", "at_least"};
}

std::string default_root() {
  const std::string here = "cases";
  return std::filesystem::is_directory(here) ? here : FILLRULE_SOURCE_DIR "/cases";
}

std::string shell_quoted(const std::string& text) {
  const bool plain = report::printable(text) == text;
  std::string result = plain ? "'" : "$'";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (plain) {
      result += c == '\'' ? "'\\''" : std::string(1, c);
    } else if (c == '\'' || c == '\\') {
      result.append("\\").push_back(c);
    } else {
      result += byte < 0x20 || byte > 0x7e ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
    }
  }
  return result + "'";
}

std::string case_selector(const std::string& file, const std::string& name, const std::string& root) {
  const bool in_suite = is_below(file, root);
  const std::string path = name.substr(0, name.rfind('[')) + ".toml";
  if (!in_suite && !(name.ends_with(']') && file.ends_with(path))) return shell_quoted(file);
  std::string folder = in_suite ? root : file.substr(0, file.size() - path.size());
  if (folder.empty()) folder = ".";
  return shell_quoted(name) + (folder == default_root() ? "" : " --suite " + shell_quoted(folder));
}

void print_error(const Error& error) {
  fmt::print(stderr, "{}\n", report::printable_lines(to_string(error)));
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

format::Suite load(const SuiteOptions& options, const format::Preview& preview) {
  format::Suite suite = scene::load_suite(options.root, options.selectors, preview);
  for (const Error& error : suite.errors) print_error(error);
  return suite;
}

void add_party_options(CLI::App& command, PartyOptions& options) {
  run::RunOptions& run = options.run;
  run.driver_files = driver_files();
  command
      .add_option(
          "--candidate", run.candidate,
          "who is judged: renderer, renderer:scanline (fills by scanlines), faults:NAME (the naive rasterizer "
          "with a fault, 'fillrule faults --list'; faults:none has none), cheats:NAME, or a driver")
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
  add_isa_option(command, run.candidate_options.isa);
  command.add_flag("--validation", run.validation, "load Vulkan's validation layers");
  command
      .add_option("--profile", options.profiles,
                  "more than the specification asks for: top_left (ties by the top-left rule), "
                  "diamond_exit (Bresenham lines by that rule), precise (imprecise values fail), same_bits "
                  "(unclipped coverage equal to the reference's)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(profile_names()));
}

void add_isa_option(CLI::App& command, renderer::Isa& isa) {
  std::vector<std::string> supported;
  for (const renderer::Isa one : renderer::kAllIsas) {
    if (renderer::is_supported(one)) supported.emplace_back(renderer::to_string(one));
  }
  command
      .add_option_function<std::string>(
          "--isa", [&isa](const std::string& name) { isa = *renderer::isa_named(name); },
          "the renderer's instruction set; by default the greatest that the processor has, and any gives the same "
          "bytes")
      ->check(CLI::IsMember(supported));
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

void add_commands(const SuiteOptions& suite, const run::RunOptions& options, run::CaseResult& result) {
  add_commands_for(case_selector(result.file, result.name, suite.root), options, result);
}

void add_commands(const run::RunOptions& options, run::CaseResult& result) {
  add_commands_for(shell_quoted(result.file), options, result);
}

Result<void> prepare_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return tl::unexpected(Error{.file = folder, .what = "cannot be made: " + error.message()});
  if (!check_writable((std::filesystem::path(folder) / ".fillrule").string())) {
    return tl::unexpected(Error{.file = folder, .what = "cannot be written to"});
  }
  return {};
}

Result<void> check_writable(const std::string& file) {
  std::error_code error;
  const bool was_there = std::filesystem::exists(file, error);
  const bool writable = std::ofstream(file, std::ios::binary | std::ios::app).is_open();
  if (!writable) return tl::unexpected(Error{.file = file, .what = "cannot be written"});
  if (!was_there) std::filesystem::remove(file, error);
  return {};
}

void add_deviation_options(CLI::App& command, std::string& expected_folder, bool& strict_reference) {
  command.add_flag(
      "--strict-reference", strict_reference,
      "fail on a fault of the reference that is not on its list of known deviations, and on a listed one "
      "that no longer occurs");
  expected_folder = FILLRULE_SOURCE_DIR "/ci/expected";
  command.add_option("--expected", expected_folder, "where the lists of known deviations are")->type_name("DIR");
}

bool has_failed(const run::RunResult& result, const run::DeviationReport& deviations, bool strict_reference) {
  const bool as_listed = deviations.unexpected.empty() && deviations.gone.empty();
  return result.summary.failed > 0 || (strict_reference && !as_listed);
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
