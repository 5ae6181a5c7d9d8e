#include "harness/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <thread>

namespace fillrule::cli {
namespace {

constexpr const char* kFooter =
    "CASE names a case by its path and sweep (coverage/shared_diagonal, 'clipping/near_plane[angle=30]'), with * and "
    "?\n"
    "as wildcards; FILE and FOLDER may be anywhere.\n"
    "Exit codes: 0 conforms, 1 mismatch, 2 bad case or usage, 3 no such reference device.";

// `cases` below the current folder, or else that of the sources the command was built from.
std::string default_suite() {
  const std::string here = "cases";
  return std::filesystem::is_directory(here) ? here : FILLRULE_SOURCE_DIR "/cases";
}

// Where ci/swiftshader puts the second reference driver.
std::vector<std::string> default_driver_files() {
  const std::string file = FILLRULE_SOURCE_DIR "/build/swiftshader/vk_swiftshader_icd.json";
  return std::filesystem::exists(file) ? std::vector{file} : std::vector<std::string>{};
}

void add_selectors(CLI::App& command, Arguments& arguments) {
  command.add_option("cases", arguments.selectors, "CASE, FILE or FOLDER; the whole suite if none")->type_name("");
  command.add_option("--suite", arguments.suite, "the folder that case names are relative to")->type_name("DIR");
}

void add_parties(CLI::App& command, Arguments& arguments) {
  run::RunOptions& run = arguments.run;
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
}

void add_profiles(CLI::App& command, std::vector<std::string>& profiles) {
  command
      .add_option(
          "--profile", profiles,
          "more than the specification asks for: top_left (ties by the top-left rule), precise (imprecise values "
          "fail), same_bits (unclipped coverage equal to the reference's)")
      ->delimiter(',')
      ->check(CLI::IsMember({"top_left", "precise", "same_bits"}));
}

judge::Profile profile_of(const std::vector<std::string>& names) {
  const auto named = [&names](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return {.top_left = named("top_left"), .precise = named("precise"), .same_bits = named("same_bits")};
}

}  // namespace

bool parse_arguments(int argc, const char* const* argv, Arguments& arguments, int& exit_code) {
  arguments.suite = default_suite();
  arguments.run.driver_files = default_driver_files();
  arguments.run.jobs = std::max(std::thread::hardware_concurrency(), 1U);
  std::vector<std::string> profiles;

  CLI::App app("Fillrule: is this rasterizer right, pixel by pixel, and if not, who is wrong and why?", "fillrule");
  app.require_subcommand(1);
  app.footer(kFooter);
  CLI::App* run = app.add_subcommand("run", "draw cases, judge them, and report");
  CLI::App* list = app.add_subcommand("list", "list the names of cases");
  CLI::App* show = app.add_subcommand("show", "write the pictures of cases, differing or not");
  CLI::App* devices = app.add_subcommand("devices", "list the reference devices there are");
  for (CLI::App* command : {run, list, show}) {
    add_selectors(*command, arguments);
    command->footer(kFooter);
  }
  for (CLI::App* command : {run, show}) {
    add_parties(*command, arguments);
    add_profiles(*command, profiles);
    command->add_option("--report", arguments.report_folder, "where pictures and results.json go")->type_name("DIR");
  }
  show->get_option("cases")->required();
  run->add_option("--json", arguments.json_file, "write the results to this file too")->type_name("FILE");
  run->add_option("--jobs", arguments.run.jobs, "cases judged at the same time")->check(CLI::Range(1, 1024));
  run->add_flag("--timing", arguments.timing, "tell where the time went, and what the reference alone takes");
  run->add_flag("--verbose,-v", arguments.verbose, "tell of every case, not only of failures");
  run->add_flag("--quiet,-q", arguments.quiet, "the summary alone");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // CLI11's own codes are many; everything but a request for help is bad usage.
    exit_code = app.exit(error, std::cout, std::cerr) == 0 ? kConforms : kBadInput;
    return false;
  }
  if (*list) arguments.command = Command::kList;
  if (*show) arguments.command = Command::kShow;
  if (*devices) arguments.command = Command::kDevices;
  arguments.run.profile = profile_of(profiles);
  arguments.run.measure_reference_alone = arguments.timing;
  return true;
}

}  // namespace fillrule::cli
