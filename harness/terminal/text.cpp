#include "harness/terminal/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>

#include "harness/report/names.h"
#include "harness/report/printable.h"
#include "harness/run/counted.h"
#include "harness/terminal/worst.h"

namespace fillrule::terminal {
namespace {

using judge::PlaneKind;
using judge::PlaneVerdict;
using judge::SampleRecord;
using judge::Verdict;
using run::counted;

constexpr std::array kVerdictsBySeverity{Verdict::kBothFault, Verdict::kCandidateFault, Verdict::kReferenceFault,
                                         Verdict::kImprecise, Verdict::kPermitted,      Verdict::kIdentical};

std::string sample_text(const PlaneVerdict& plane, const SampleRecord& sample, std::string_view label,
                        const Style& style) {
  std::string text = fmt::format("      {} ({}, {})", label, sample.x, sample.y);
  if (sample.sample > 0) text += fmt::format(" sample {}", sample.sample);
  if (plane.components > 1) text += fmt::format(" .{}", "xyzw"[sample.component]);
  text += fmt::format(": {}, {}", report::name_of(sample.verdict), values_text(plane, sample));
  return report::wrapped(text, style.columns, 8) + "\n";
}

std::string plane_text(const PlaneVerdict& plane, const Style& style) {
  Verdict gravest = Verdict::kIdentical;
  for (const Verdict verdict : kVerdictsBySeverity) {
    if (plane.count(verdict) > 0) gravest = std::max(gravest, verdict);
  }
  std::string text = "    " + counts_text(plane);
  if (plane.bounds) {
    text += fmt::format("; within ({}, {}) to ({}, {})", plane.bounds->min_x, plane.bounds->min_y,
                        plane.bounds->max_x, plane.bounds->max_y);
  }
  text = style.paint(role_of(gravest), report::wrapped(text, style.columns, 6)) + "\n";
  if (plane.first) text += sample_text(plane, *plane.first, "first", style);
  const bool another = plane.worst && (plane.worst->x != plane.first->x || plane.worst->y != plane.first->y ||
                                       plane.worst->sample != plane.first->sample);
  if (another) text += sample_text(plane, *plane.worst, "worst", style);
  return text;
}

bool is_identical(const PlaneVerdict& plane) {
  const auto all = std::accumulate(plane.counts.begin(), plane.counts.end(), uint64_t{0});
  return plane.count(Verdict::kIdentical) == all;
}

Role role_of_status(run::Status status) {
  switch (status) {
    case run::Status::kPassed:
      return Role::kGood;
    case run::Status::kFailed:
      return Role::kBad;
    case run::Status::kSkipped:
      return Role::kCaution;
  }
  return Role::kPlain;
}

}  // namespace

std::string counts_text(const PlaneVerdict& plane) {
  std::string text = report::printable(plane.name) + ":";
  std::string_view separator = " ";
  for (const Verdict verdict : kVerdictsBySeverity) {
    if (plane.count(verdict) == 0) continue;
    text += fmt::format("{}{} {}", separator, plane.count(verdict), report::name_of(verdict));
    separator = ", ";
  }
  return text;
}

std::string fault_text(const run::CaseResult& result) {
  std::string text = report::printable(result.message);
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  for (const PlaneVerdict& plane : result.verdict.planes) {
    if (plane.candidate_faults() > 0 || plane.reference_faults() > 0) add(counts_text(plane));
  }
  for (const judge::CheckResult& check : result.checks) {
    if (check.outcome != judge::CheckResult::Outcome::kFailed) continue;
    add(fmt::format("check {}: {}", check.name, report::printable(check.message)));
  }
  return text;
}

std::string case_text(const run::CaseResult& result, const Style& style, std::string_view inspection) {
  std::string status(report::name_of(result.status));
  std::transform(status.begin(), status.end(), status.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  constexpr size_t kBeforeName = 10;
  const size_t room = style.columns == 0 ? 0 : style.columns - std::min(style.columns - 1, kBeforeName);
  std::string text =
      fmt::format("  {} {}\n", style.paint(role_of_status(result.status), fmt::format("{:<7}", status)),
                  report::shortened(report::printable(result.name), room));
  const auto line = [&](Role role, const std::string& words) {
    text += style.paint(role, report::wrapped("    " + report::printable(words), style.columns, 6)) + "\n";
  };
  if (!result.message.empty()) line(Role::kPlain, result.message);
  if (!result.reason.empty()) line(Role::kHeading, result.reason);
  for (const PlaneVerdict& plane : result.verdict.planes) {
    if (!is_identical(plane)) text += plane_text(plane, style);
  }
  for (const judge::CheckResult& check : result.checks) {
    if (check.outcome != judge::CheckResult::Outcome::kFailed) continue;
    line(Role::kBad, fmt::format("check {}: {}", check.name, check.message));
  }
  text += inspection;
  const bool at_fault = result.verdict.candidate_faults() > 0 || result.verdict.reference_faults() > 0;
  if (result.status == run::Status::kFailed || at_fault) {
    // Never cut nor broken into lines: they are there to be pasted.
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

std::string summary_text(const run::RunResult& result, const Style& style) {
  const run::Summary& summary = result.summary;
  std::string text = report::wrapped(parties_text(result), style.columns, 2);
  if (result.shard.total > 1) {
    text += fmt::format("shard {} of {}, of {}\n", result.shard.index + 1, result.shard.total,
                        counted(result.shard.suite_cases, "case"));
  }
  const std::string outcome =
      fmt::format("{}: {} passed, {} failed, {} skipped, in {:.2f} s", counted(summary.cases, "case"), summary.passed,
                  summary.failed, summary.skipped, summary.wall_seconds);
  text +=
      style.paint(summary.failed > 0 ? Role::kBad : Role::kGood, report::wrapped(outcome, style.columns, 2)) + "\n";
  if (summary.failed_checks > 0) {
    text += fmt::format("{} failed\n", counted(summary.failed_checks, "metamorphic check"));
  }
  const std::string counts =
      fmt::format("samples over all planes: {} identical, {} permitted, {} imprecise, {}, {}", summary.identical,
                  summary.permitted, summary.imprecise, counted(summary.candidate_faults, "candidate fault"),
                  counted(summary.reference_faults, "reference fault"));
  return text + report::wrapped(counts, style.columns, 2) + "\n";
}

std::string deviations_text(const run::RunResult& result, const run::DeviationReport& deviations) {
  std::string text;
  const std::string& driver = result.reference.driver;
  if (!deviations.known.empty()) {
    text += fmt::format("{} of its known deviations {} met, listed in {}\n", deviations.known.size(),
                        deviations.known.size() == 1 ? "was" : "were", run::deviations_file_name(result.reference));
  }
  for (const auto& fault : deviations.unexpected) {
    text += fmt::format("NEW fault of {}: {}, {}, {}\n", driver, report::printable(fault.case_name),
                        report::printable(fault.plane), counted(fault.samples, "sample"));
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
      text += fmt::format("  {}, {}: wrong at {} {}, at {} {}, at {} both\n", report::printable(one.name),
                          report::printable(plane.name), counted(first, "sample"), result.candidate, second,
                          result.reference.driver, both);
    }
    permitted_cases += permitted > 0 ? 1 : 0;
    permitted_samples += permitted;
  }
  return fmt::format("{} and {} draw differently, as permitted, {} of coverage, hits, owner or facing in {}{}\n{}",
                     result.candidate, result.reference.driver, counted(permitted_samples, "sample"),
                     counted(permitted_cases, "case"), text.empty() ? "" : ", and where one is wrong:", text);
}

}  // namespace fillrule::terminal
