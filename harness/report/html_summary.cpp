#include "harness/report/html_summary.h"

#include <fmt/format.h>

#include "harness/report/names.h"
#include "harness/run/counted.h"

namespace fillrule::report {
namespace {

// More would make the page slow to open, and are in results.json and in the list.
constexpr size_t kMostFailures = 200;

std::string counts_html(const run::Summary& summary, const run::DeviationReport& deviations) {
  const auto row = [](std::string_view name, uint64_t value) {
    return fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", name, value);
  };
  return "<table class=\"counts\">\n" + row("cases", summary.cases) + row("passed", summary.passed) +
         row("failed", summary.failed) + row("skipped", summary.skipped) +
         row("identical samples", summary.identical) + row("permitted", summary.permitted) +
         row("imprecise", summary.imprecise) + row("candidate faults", summary.candidate_faults) +
         row("reference faults", summary.reference_faults) + row("failed checks", summary.failed_checks) +
         row("new reference faults", deviations.unexpected.size()) + "</table>\n";
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string html_summary(const run::RunResult& result, const run::DeviationReport& deviations,
                         const std::function<std::string(size_t index)>& sentence_of) {
  std::string html = fmt::format("<p>Candidate {}, {}; reference {} {}.</p>\n", html_text(result.candidate),
                                 run::counted(result.candidate_subpixel_bits, "subpixel bit"),
                                 html_text(result.reference.name), html_text(result.reference.version));
  html += counts_html(result.summary, deviations);
  if (result.summary.failed == 0) return html + "<p>No case failed.</p>\n";
  html += "<table class=\"failures\">\n<tr><th>failed case</th><th>why</th></tr>\n";
  size_t count = 0;
  for (size_t i = 0; i < result.cases.size(); ++i) {
    const run::CaseResult& one = result.cases[i];
    if (one.status != run::Status::kFailed || ++count > kMostFailures) continue;
    std::string why = sentence_of(i);
    if (why.empty()) why = one.message;
    for (const judge::CheckResult& check : one.checks) {
      if (!why.empty() || check.outcome != judge::CheckResult::Outcome::kFailed) continue;
      why = fmt::format("The check {} failed: {}", check.name, check.message);
    }
    html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", html_text(one.name), html_text(why));
  }
  html += "</table>\n";
  if (count > kMostFailures) html += fmt::format("<p>And {} more.</p>\n", count - kMostFailures);
  return html;
}

}  // namespace fillrule::report
