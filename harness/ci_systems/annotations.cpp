#include "harness/ci_systems/annotations.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "harness/report/printable.h"
#include "harness/run/counted.h"
#include "harness/terminal/text.h"

namespace fillrule::ci_systems {
namespace {

using run::CaseResult;
using run::Status;

constexpr size_t kMostErrors = 10;
constexpr size_t kMostRows = 100;
constexpr size_t kLongestCell = 400;  // columns; a summary may take 1 MiB

std::string why(const CaseResult& result) {
  std::string faults = terminal::fault_text(result);
  if (result.reason.empty()) return faults;
  return report::printable(result.reason) + (faults.empty() ? "" : " " + faults);
}

// What the runner would take for the end of a property, a command or a line.
std::string escaped(std::string_view text, std::string_view special) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) == std::string_view::npos) {
      result += c;
    } else {
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return result;
}

std::string escaped_data(std::string_view text) {
  return escaped(text, "%\r\n");
}

std::string escaped_property(std::string_view text) {
  return escaped(text, "%\r\n:,");
}

std::string failures_text(const run::Summary& summary) {
  return fmt::format("{} of {} failed", summary.failed, run::counted(summary.cases, "case"));
}

// Markdown knows many marks; written as character references none of them is one.
std::string markdown(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain =
        byte >= 0x80 || std::isalnum(byte) != 0 || std::string_view(" .,-=/+").find(c) != std::string_view::npos;
    if (plain) {
      result += c;
    } else {
      result += fmt::format("&#{};", byte);
    }
  }
  return result;
}

std::string cell(std::string_view text) {
  return markdown(report::shortened(text, kLongestCell));
}

// FNV-1a. Names of cases are distinct.
uint64_t fingerprint(std::string_view name) {
  uint64_t hash = 14695981039346656037U;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return hash;
}

}  // namespace

Place place_of(const CaseResult& result, const std::string& project_folder) {
  std::error_code error;
  const auto relative = std::filesystem::proximate(result.file, project_folder, error);
  const bool below = !error && !relative.empty() && *relative.begin() != "..";
  Place place{.path = below ? relative.string() : result.file};
  const std::string_view wanted = result.name.ends_with(']') ? "[sweep" : "[[draw]]";
  std::ifstream file(result.file);
  std::string text;
  for (uint32_t line = 1; std::getline(file, text); ++line) {
    if (!text.starts_with(wanted)) continue;
    place.line = line;
    break;
  }
  return place;
}

std::string github_commands(const run::RunResult& result, const std::string& project_folder) {
  std::string text;
  size_t errors = 0;
  for (const CaseResult& one : result.cases) {
    if (one.status != Status::kFailed) continue;
    if (++errors == kMostErrors) break;
    const Place place = place_of(one, project_folder);
    std::string message = why(one);
    if (!one.explain_command.empty()) message += "\n" + one.explain_command;
    text += fmt::format("::error file={},line={},title={}::{}\n", escaped_property(report::printable(place.path)),
                        place.line, escaped_property(report::printable(one.name)), escaped_data(message));
  }
  if (errors > 0) text += fmt::format("::error title=Fillrule::{}\n", escaped_data(failures_text(result.summary)));
  return text;
}

std::string github_summary(const run::RunResult& result, const std::string& report) {
  const run::Summary& summary = result.summary;
  std::string text = fmt::format(
      "## Fillrule: {}\n\n{}\n\n| passed | failed | skipped | candidate faults | reference faults |\n"
      "|---:|---:|---:|---:|---:|\n| {} | {} | {} | {} | {} |\n",
      failures_text(summary), markdown(terminal::parties_text(result)), summary.passed, summary.failed,
      summary.skipped, summary.candidate_faults, summary.reference_faults);
  if (!report.empty()) text += fmt::format("\nThe report: {}\n", markdown(report));
  if (summary.failed == 0) return text;
  text += "\n| case | why |\n|---|---|\n";
  size_t rows = 0;
  for (const CaseResult& one : result.cases) {
    if (one.status != Status::kFailed) continue;
    if (++rows > kMostRows) break;
    text += fmt::format("| {} | {} |\n", cell(report::printable(one.name)), cell(why(one)));
  }
  if (rows > kMostRows) text += fmt::format("\nThe first {} of {}.\n", kMostRows, summary.failed);
  return text;
}

std::string gitlab_code_quality(const run::RunResult& result, const std::string& project_folder) {
  using Json = nlohmann::ordered_json;
  Json issues = Json::array();
  for (const CaseResult& one : result.cases) {
    if (one.status != Status::kFailed) continue;
    const Place place = place_of(one, project_folder);
    issues.push_back({{"description", report::printable(one.name) + ": " + why(one)},
                      {"check_name", "fillrule"},
                      {"fingerprint", fmt::format("{:016x}", fingerprint(one.name))},
                      {"severity", "major"},
                      {"location", {{"path", place.path}, {"lines", {{"begin", place.line}}}}}});
  }
  return issues.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fillrule::ci_systems
