#include "harness/cli/output.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "harness/ci_systems/annotations.h"
#include "harness/ci_systems/junit.h"
#include "harness/cli/options.h"
#include "harness/report/json.h"
#include "harness/report/pictures.h"

namespace fillrule::cli {
namespace {

constexpr const char* kCodeQualityFile = "gl-code-quality-report.json";

// What CI systems tell paths from: the checkout, or else the current folder.
std::string project_folder() {
  for (const char* const name : {"GITHUB_WORKSPACE", "CI_PROJECT_DIR"}) {
    if (const char* const folder = std::getenv(name); folder != nullptr && *folder != '\0') return folder;
  }
  return ".";
}

std::string below_project(const std::string& path) {
  std::error_code error;
  const auto relative = std::filesystem::proximate(path, project_folder(), error);
  return error || relative.empty() || *relative.begin() == ".." ? path : relative.string();
}

std::string with_suffix(const std::string& file, const std::string& suffix) {
  if (file.empty()) return file;
  const std::filesystem::path path(file);
  return (path.parent_path() / (path.stem().string() + "-" + suffix + path.extension().string())).string();
}

// The pictures of the cases at fault, as they lie in the report's folder.
std::vector<std::string> pictures_of(const OutputOptions& options, const run::CaseResult& result) {
  if (options.report_folder.empty()) return {};
  const std::string path = options.report_folder + "/" + report::file_stem(result.name) + ".png";
  return std::filesystem::exists(path) ? std::vector{below_project(path)} : std::vector<std::string>{};
}

// GitHub shows what is appended to this file.
bool append_github_summary(const OutputOptions& options, const run::RunResult& result) {
  const char* const file = std::getenv("GITHUB_STEP_SUMMARY");
  if (file == nullptr || *file == '\0') return true;
  std::ofstream stream(file, std::ios::binary | std::ios::app);
  stream << ci_systems::github_summary(result, options.report_folder) << '\n';
  stream.close();
  if (!stream) print_error({.file = file, .what = "cannot be written"});
  return static_cast<bool>(stream);
}

}  // namespace

void add_output_options(CLI::App& command, OutputOptions& options) {
  command.add_option("--json", options.json_file, "write the results to this file too")->type_name("FILE");
  command.add_option("--junit", options.junit_file, "write the results as JUnit to this file")->type_name("FILE");
  command
      .add_option(
          "--annotations", options.annotations,
          "tell a CI system which case files failed: github (workflow commands on stdout, and a summary where "
          "GITHUB_STEP_SUMMARY is set), gitlab (gl-code-quality-report.json in the report's folder)")
      ->check(CLI::IsMember({"github", "gitlab"}));
}

OutputOptions with_suffix(OutputOptions options, const std::string& suffix) {
  if (!options.report_folder.empty()) options.report_folder += "/" + suffix;
  options.json_file = with_suffix(options.json_file, suffix);
  options.junit_file = with_suffix(options.junit_file, suffix);
  return options;
}

bool can_write_output(const OutputOptions& options) {
  if (options.annotations == "gitlab" && options.report_folder.empty()) {
    print_error({.what = "--annotations gitlab needs a report's folder to write to"});
    return false;
  }
  if (!options.report_folder.empty() && !print_if_failed(prepare_folder(options.report_folder))) return false;
  for (const std::string& file : {options.json_file, options.junit_file}) {
    if (!file.empty() && !print_if_failed(check_writable(file))) return false;
  }
  return true;
}

bool write_output(const OutputOptions& options, const run::RunResult& result,
                  const run::DeviationReport& deviations) {
  bool written = true;
  const auto write = [&written](const std::string& path, const std::string& text) {
    written = print_if_failed(report::write_text(path, text)) && written;
  };
  const std::string json = report::to_json(result, deviations);
  if (!options.json_file.empty()) write(options.json_file, json);
  if (!options.report_folder.empty()) write(options.report_folder + "/results.json", json);
  if (!options.junit_file.empty()) {
    write(options.junit_file,
          ci_systems::to_junit(result, [&options](const run::CaseResult& one) { return pictures_of(options, one); }));
  }
  if (options.annotations == "gitlab") {
    write(options.report_folder + "/" + kCodeQualityFile, ci_systems::gitlab_code_quality(result, project_folder()));
  }
  if (options.annotations == "github") {
    fmt::print("{}", ci_systems::github_commands(result, project_folder()));
    written = append_github_summary(options, result) && written;
  }
  return written;
}

bool print_if_failed(const Result<void>& result) {
  if (!result) print_error(result.error());
  return result.has_value();
}

}  // namespace fillrule::cli
