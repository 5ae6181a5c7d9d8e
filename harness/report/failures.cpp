#include "harness/report/failures.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

#include "harness/report/html_report.h"
#include "harness/report/json.h"
#include "harness/report/pictures.h"

namespace fillrule::report {
namespace {

bool has_fault(const run::CaseResult& result) {
  const bool check_failed = std::ranges::any_of(result.checks, [](const judge::CheckResult& check) {
    return check.outcome == judge::CheckResult::Outcome::kFailed;
  });
  return check_failed || result.verdict.candidate_faults() > 0 || result.verdict.reference_faults() > 0;
}

// Those that failed first: where room is short, they have it.
std::vector<size_t> cases_at_fault(const run::RunResult& result) {
  std::vector<size_t> chosen;
  for (size_t i = 0; i < result.cases.size(); ++i) {
    if (has_fault(result.cases[i])) chosen.push_back(i);
  }
  std::ranges::stable_partition(chosen,
                                [&](size_t index) { return result.cases[index].status == run::Status::kFailed; });
  return chosen;
}

std::optional<std::string> read_if_there(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

FailureFiles write_failures(const std::string& folder, const std::string& faults_file, run::SuiteRunner& runner,
                            const judge::Profile& profile, const std::vector<Case>& cases,
                            const run::RunResult& result, const run::DeviationReport& deviations) {
  const Parties parties{.candidate = result.candidate,
                        .candidate_subpixel_bits = result.candidate_subpixel_bits,
                        .reference = result.reference.driver,
                        .reference_subpixel_bits = result.reference.subpixel_bits,
                        .profile = profile};
  FailureFiles files;
  HtmlReport html;
  for (const size_t index : cases_at_fault(result)) {
    const Case& one = cases[index];
    const Result<run::Drawing> drawing = runner.draw(one);
    if (!drawing) {
      files.errors.push_back(drawing.error());
      continue;
    }
    const auto paths = write_pictures(folder, one, *drawing);
    if (!paths) files.errors.push_back(paths.error());
    files.cases += paths ? 1 : 0;
    if (html.has_room()) {
      html.add(index, html_case(one, result.cases[index], *drawing, parties));
    } else {
      html.add_statistics(index);
    }
  }
  const Result<void> written =
      write_text(folder + "/report.html", html.page(result, deviations, read_if_there(faults_file)));
  if (!written) files.errors.push_back(written.error());
  return files;
}

}  // namespace fillrule::report
