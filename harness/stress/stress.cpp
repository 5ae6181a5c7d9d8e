#include "harness/stress/stress.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "cases/format/writer.h"
#include "harness/run/counted.h"
#include "harness/stress/generate.h"
#include "harness/stress/reduce.h"

namespace fillrule::stress {
namespace {

using Clock = std::chrono::steady_clock;

// So many cases are made and run at once: enough to keep every thread busy, few enough for the memory.
constexpr size_t kCasesAtOnce = 2048;

struct Source {
  FamilyCounts counts;
  uint32_t candidate_files = 0;
  uint32_t reference_files = 0;
};

Result<void> write_case(const Case& one, const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << format::write(one);
  file.close();
  if (!file) return tl::unexpected(Error{.file = path, .what = "cannot be written"});
  return {};
}

class StressRun {
 public:
  StressRun(const StressOptions& options, run::SuiteRunner& runner) : options_(options), runner_(runner) {
    const auto every = all_families();
    const std::vector<Family> families =
        options.families.empty() ? std::vector<Family>(every.begin(), every.end()) : options.families;
    for (const Family family : families) sources_.push_back({.counts = {.family = family}});
  }

  StressResult run(const Progress& progress) {
    const auto start = Clock::now();
    while (made_ < options_.triangles) {
      make_cases();
      run::RunResult result = runner_.run(cases_);
      for (size_t i = 0; i < cases_.size(); ++i) count(sources_[source_of_[i]], cases_[i], result.cases[i]);
      add_timing(result);
      if (progress) progress(made_);
    }
    result_.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
    for (const Source& source : sources_) result_.families.push_back(source.counts);
    return std::move(result_);
  }

 private:
  // The next cases, always of the family that has had the fewest triangles.
  void make_cases() {
    cases_.clear();
    source_of_.clear();
    while (made_ < options_.triangles && cases_.size() < kCasesAtOnce) {
      const auto fewest =
          std::ranges::min_element(sources_, {}, [](const Source& source) { return source.counts.triangles; });
      FamilyCounts& counts = fewest->counts;
      cases_.push_back(random_case(options_.seed, counts.family, counts.cases));
      source_of_.push_back(static_cast<size_t>(fewest - sources_.begin()));
      ++counts.cases;
      counts.triangles += triangles_per_case(counts.family);
      made_ += triangles_per_case(counts.family);
    }
  }

  void count(Source& source, const Case& drawn, const run::CaseResult& result) {
    FamilyCounts& counts = source.counts;
    counts.identical += result.verdict.count(judge::Verdict::kIdentical);
    counts.permitted += result.verdict.count(judge::Verdict::kPermitted);
    counts.imprecise += result.verdict.count(judge::Verdict::kImprecise);
    counts.candidate_faults += result.verdict.candidate_faults();
    counts.reference_faults += result.verdict.reference_faults();
    const bool failed = result.status == run::Status::kFailed;
    const bool reference_fault = !failed && result.verdict.reference_faults() > 0;
    counts.failed_cases += failed ? 1 : 0;
    if (!failed && !reference_fault) return;
    const bool known = !failed && !has_new_fault(result.name, result.verdict);
    counts.known_deviation_cases += known ? 1 : 0;
    counts.unexpected_deviation_cases += !failed && !known ? 1 : 0;
    if (known) return;
    uint32_t& files = failed ? source.candidate_files : source.reference_files;
    if (files++ < options_.files_per_family) add_finding(drawn, result);
  }

  void add_finding(const Case& drawn, const run::CaseResult& result) {
    Finding finding{.result = result};
    Case reduced = drawn;
    if (result.message.empty()) {
      const bool candidate = result.verdict.candidate_faults() > 0;
      reduced = reduce(drawn, [&](const Case& smaller) {
        const Result<run::Drawing> drawing = runner_.draw(smaller);
        if (!drawing) return false;
        const judge::CaseVerdict& verdict = drawing->verdict;
        const bool fails = candidate ? verdict.candidate_faults() > 0 : has_new_fault(drawn.name, verdict);
        if (fails) finding.result.verdict = verdict;
        return fails;
      });
    }
    finding.result.file = fmt::format("{}/{}.toml", options_.folder, reduced.name);
    finding.result.name = finding.result.file;
    if (const Result<void> written = write_case(reduced, finding.result.file); !written) {
      finding.message = to_string(written.error());
    }
    result_.findings.push_back(std::move(finding));
  }

  // A fault of the reference that no list has.
  [[nodiscard]] bool has_new_fault(const std::string& case_name, const judge::CaseVerdict& verdict) const {
    return !run::compare_with_known({{.name = case_name, .verdict = verdict}}, options_.known).unexpected.empty();
  }

  void add_timing(run::RunResult& result) {
    const run::RunTiming before = result_.run.timing.run;
    result.cases.clear();
    result_.run = std::move(result);
    result_.run.timing.run += before;
  }

  const StressOptions& options_;
  run::SuiteRunner& runner_;
  std::vector<Source> sources_;
  uint64_t made_ = 0;
  std::vector<Case> cases_;
  std::vector<size_t> source_of_;
  StressResult result_;
};

std::string row(std::string_view name, const FamilyCounts& counts) {
  return fmt::format("{:<13}{:>10}{:>14}{:>13}{:>11}{:>18}{:>18}\n", name, counts.triangles, counts.identical,
                     counts.permitted, counts.imprecise, counts.candidate_faults, counts.reference_faults);
}

}  // namespace

FamilyCounts StressResult::total() const {
  FamilyCounts total;
  for (const FamilyCounts& counts : families) {
    total.cases += counts.cases;
    total.triangles += counts.triangles;
    total.identical += counts.identical;
    total.permitted += counts.permitted;
    total.imprecise += counts.imprecise;
    total.candidate_faults += counts.candidate_faults;
    total.reference_faults += counts.reference_faults;
    total.failed_cases += counts.failed_cases;
    total.known_deviation_cases += counts.known_deviation_cases;
    total.unexpected_deviation_cases += counts.unexpected_deviation_cases;
  }
  return total;
}

StressResult run_stress(const StressOptions& options, run::SuiteRunner& runner, const Progress& progress) {
  return StressRun(options, runner).run(progress);
}

std::string summary_text(const StressResult& result) {
  std::string text = fmt::format("{:<13}{:>10}{:>14}{:>13}{:>11}{:>18}{:>18}\n", "family", "triangles", "identical",
                                 "permitted", "imprecise", "candidate faults", "reference faults");
  for (const FamilyCounts& counts : result.families) text += row(name_of(counts.family), counts);
  const FamilyCounts total = result.total();
  text += row("all", total);
  text += fmt::format(
      "{} in {}: {} failed; the reference alone at fault in {}, with known deviations in {} more\n"
      "{:.2f} s, {:.0f} triangles a second\n",
      run::counted(total.triangles, "triangle"), run::counted(total.cases, "case"), total.failed_cases,
      total.unexpected_deviation_cases, total.known_deviation_cases, result.wall_seconds,
      static_cast<double>(total.triangles) / result.wall_seconds);
  return text;
}

}  // namespace fillrule::stress
