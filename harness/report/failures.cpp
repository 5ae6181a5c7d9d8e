#include "harness/report/failures.h"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>

#include "harness/report/html_report.h"
#include "harness/report/json.h"
#include "harness/report/pictures.h"
#include "harness/run/job_queue.h"

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
  std::stable_partition(chosen.begin(), chosen.end(),
                        [&](size_t index) { return result.cases[index].status == run::Status::kFailed; });
  return chosen;
}

std::optional<std::string> read_if_there(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

// A case at fault on its way into the report.
struct Failure {
  size_t index = 0;
  Result<run::Drawing> drawing;
  Result<void> pictures;
  std::optional<HtmlCase> page;  // if there is room
};

// Drawn by one thread, as a device is for one, and then encoded by several.
std::vector<Failure> encoded(std::span<const size_t> chosen, const std::string& folder, run::SuiteRunner& runner,
                             const Parties& parties, const std::vector<Case>& cases, const run::RunResult& result,
                             uint32_t jobs, bool has_room) {
  std::vector<Failure> failures;
  for (const size_t index : chosen) failures.push_back({.index = index, .drawing = runner.draw(cases[index])});
  std::atomic<size_t> next = 0;
  const auto encode = [&](uint32_t /*worker*/) {
    for (size_t i = next++; i < failures.size(); i = next++) {
      Failure& one = failures[i];
      if (!one.drawing) continue;
      one.pictures = write_pictures(folder, cases[one.index], *one.drawing).map([](const auto&) {});
      if (has_room) one.page = html_case(cases[one.index], result.cases[one.index], *one.drawing, parties);
    }
  };
  { const run::Workers workers(std::min(jobs, static_cast<uint32_t>(failures.size())), encode); }
  return failures;
}

// Few enough that what has no room at last costs little.
constexpr size_t kAtOnceOfEachJob = 8;

}  // namespace

FailureFiles write_failures(const std::string& folder, const std::string& faults_file, run::SuiteRunner& runner,
                            const judge::Profile& profile, const std::vector<Case>& cases,
                            const run::RunResult& result, const run::DeviationReport& deviations, uint32_t jobs) {
  const Parties parties{.candidate = result.candidate,
                        .candidate_subpixel_bits = result.candidate_subpixel_bits,
                        .reference = result.reference.driver,
                        .reference_subpixel_bits = result.reference.subpixel_bits,
                        .profile = profile};
  FailureFiles files;
  HtmlReport html;
  const std::vector<size_t> chosen = cases_at_fault(result);
  const size_t at_once = kAtOnceOfEachJob * std::max(jobs, 1U);
  for (size_t begin = 0; begin < chosen.size(); begin += at_once) {
    const auto some = std::span(chosen).subspan(begin, std::min(at_once, chosen.size() - begin));
    for (Failure& one : encoded(some, folder, runner, parties, cases, result, std::max(jobs, 1U), html.has_room())) {
      if (!one.drawing) {
        files.errors.push_back(one.drawing.error());
        continue;
      }
      if (!one.pictures) files.errors.push_back(one.pictures.error());
      files.cases += one.pictures ? 1 : 0;
      if (one.page && html.has_room()) {
        html.add(one.index, std::move(*one.page));
      } else {
        html.add_statistics(one.index);
      }
    }
  }
  const Result<void> written =
      write_text(folder + "/report.html", html.page(result, deviations, read_if_there(faults_file)));
  if (!written) files.errors.push_back(written.error());
  return files;
}

}  // namespace fillrule::report
