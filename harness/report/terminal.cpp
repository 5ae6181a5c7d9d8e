#include "harness/report/terminal.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <numeric>

#include "harness/report/names.h"
#include "harness/run/counted.h"

namespace fillrule::report {
namespace {

using judge::PlaneKind;
using judge::PlaneVerdict;
using judge::SampleRecord;
using judge::Verdict;
using run::counted;

constexpr std::array kVerdictsBySeverity{Verdict::kBothFault, Verdict::kCandidateFault, Verdict::kReferenceFault,
                                         Verdict::kImprecise, Verdict::kPermitted,      Verdict::kIdentical};

// kNoOwner, as the number that the owner plane's records hold.
constexpr double kNoOwnerNumber = std::numeric_limits<uint32_t>::max();

std::string value_text(PlaneKind kind, double value) {
  if (kind == PlaneKind::kOwner && value == kNoOwnerNumber) return "none";
  if (std::isnan(value)) return "nan";  // of either sign
  if (kind == PlaneKind::kDepth || kind == PlaneKind::kVarying) return fmt::format("{:.9g}", value);
  return fmt::format("{}", value);
}

std::string sample_text(const PlaneVerdict& plane, const SampleRecord& sample, std::string_view label) {
  std::string text = fmt::format("      {} ({}, {})", label, sample.x, sample.y);
  if (plane.components > 1) text += fmt::format(" .{}", "xyzw"[sample.component]);
  text += fmt::format(": {}, candidate {}", name_of(sample.verdict), value_text(plane.kind, sample.candidate));
  if (sample.reference) text += fmt::format(", reference {}", value_text(plane.kind, *sample.reference));
  if (!std::isnan(sample.expected)) text += fmt::format(", exact {}", value_text(plane.kind, sample.expected));
  if (sample.tolerance > 0 && std::isfinite(sample.tolerance)) text += fmt::format(" +- {:.3g}", sample.tolerance);
  return text + "\n";
}

std::string plane_text(const PlaneVerdict& plane) {
  std::string text = fmt::format("    {}:", plane.name);
  std::string_view separator = " ";
  for (const Verdict verdict : kVerdictsBySeverity) {
    if (plane.count(verdict) == 0) continue;
    text += fmt::format("{}{} {}", separator, plane.count(verdict), name_of(verdict));
    separator = ", ";
  }
  if (plane.bounds) {
    text += fmt::format("; within ({}, {}) to ({}, {})", plane.bounds->min_x, plane.bounds->min_y,
                        plane.bounds->max_x, plane.bounds->max_y);
  }
  text += "\n";
  if (plane.first) text += sample_text(plane, *plane.first, "first");
  const bool another = plane.worst && (plane.worst->x != plane.first->x || plane.worst->y != plane.first->y ||
                                       plane.worst->sample != plane.first->sample);
  if (another) text += sample_text(plane, *plane.worst, "worst");
  return text;
}

bool is_identical(const PlaneVerdict& plane) {
  const auto all = std::accumulate(plane.counts.begin(), plane.counts.end(), uint64_t{0});
  return plane.count(Verdict::kIdentical) == all;
}

}  // namespace

std::string case_text(const run::CaseResult& result) {
  std::string status(name_of(result.status));
  std::transform(status.begin(), status.end(), status.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string text = fmt::format("  {:<7} {}\n", status, result.name);
  if (!result.message.empty()) text += fmt::format("    {}\n", result.message);
  for (const PlaneVerdict& plane : result.verdict.planes) {
    if (is_identical(plane)) continue;
    text += plane_text(plane);
  }
  for (const judge::CheckResult& check : result.checks) {
    if (check.outcome == judge::CheckResult::Outcome::kFailed) {
      text += fmt::format("    check {}: {}\n", check.name, check.message);
    }
  }
  const bool at_fault = result.verdict.candidate_faults() > 0 || result.verdict.reference_faults() > 0;
  if (result.status == run::Status::kFailed || at_fault) {
    if (!result.show_command.empty()) text += fmt::format("    see it: {}\n", result.show_command);
    if (!result.explain_command.empty()) text += fmt::format("    explain it: {}\n", result.explain_command);
  }
  return text;
}

std::string parties_text(const run::RunResult& result) {
  std::string text =
      fmt::format("candidate {} ({} subpixel bits) against ", result.candidate, result.candidate_subpixel_bits);
  if (result.reference.name.empty()) {
    text += "the oracle alone\n";
  } else {
    text += fmt::format("{} ({}, {}, {} subpixel bits) and the oracle\n", result.reference.driver,
                        result.reference.name, result.reference.version, result.reference.subpixel_bits);
  }
  return text;
}

std::string summary_text(const run::RunResult& result) {
  const run::Summary& summary = result.summary;
  std::string text = parties_text(result);
  text += fmt::format("{}: {} passed, {} failed, {} skipped, in {:.2f} s\n", counted(summary.cases, "case"),
                      summary.passed, summary.failed, summary.skipped, summary.wall_seconds);
  if (summary.failed_checks > 0) {
    text += fmt::format("{} failed\n", counted(summary.failed_checks, "metamorphic check"));
  }
  text +=
      fmt::format("samples over all planes: {} identical, {} permitted, {} imprecise, {}, {}\n", summary.identical,
                  summary.permitted, summary.imprecise, counted(summary.candidate_faults, "candidate fault"),
                  counted(summary.reference_faults, "reference fault"));
  return text;
}

std::string deviations_text(const run::RunResult& result, const run::DeviationReport& deviations) {
  std::string text;
  const std::string& driver = result.reference.driver;
  if (!deviations.known.empty()) {
    text += fmt::format("{} of its known deviations {} met, listed in {}\n", deviations.known.size(),
                        deviations.known.size() == 1 ? "was" : "were", run::deviations_file_name(result.reference));
  }
  for (const auto& fault : deviations.unexpected) {
    text += fmt::format("NEW fault of {}: {}, {}, {}\n", driver, fault.case_name, fault.plane,
                        counted(fault.samples, "sample"));
  }
  for (const run::Deviation& gone : deviations.gone) {
    text += fmt::format("GONE from {}: {} ({}) no longer occurs\n", driver, fmt::join(gone.cases, ", "),
                        fmt::join(gone.planes, ", "));
  }
  return text;
}

std::string disagreements_text(const run::RunResult& result) {
  std::string text;
  uint64_t permitted_cases = 0;
  uint64_t permitted_samples = 0;
  for (const run::CaseResult& one : result.cases) {
    uint64_t permitted = 0;
    for (const PlaneVerdict& plane : one.verdict.planes) {
      const bool value = plane.kind == PlaneKind::kDepth || plane.kind == PlaneKind::kVarying;
      if (!value) permitted += plane.count(Verdict::kPermitted);
      const uint64_t first = plane.count(Verdict::kCandidateFault);
      const uint64_t second = plane.count(Verdict::kReferenceFault);
      const uint64_t both = plane.count(Verdict::kBothFault);
      if (first + second + both == 0) continue;
      text += fmt::format("  {}, {}: wrong at {} {}, at {} {}, at {} both\n", one.name, plane.name,
                          counted(first, "sample"), result.candidate, second, result.reference.driver, both);
    }
    permitted_cases += permitted > 0 ? 1 : 0;
    permitted_samples += permitted;
  }
  return fmt::format("{} and {} draw differently, as permitted, {} of coverage, hits, owner or facing in {}{}\n{}",
                     result.candidate, result.reference.driver, counted(permitted_samples, "sample"),
                     counted(permitted_cases, "case"), text.empty() ? "" : ", and where one is wrong:", text);
}

}  // namespace fillrule::report
