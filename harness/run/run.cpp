#include "harness/run/run.h"

#include <algorithm>

namespace fillrule::run {

Summary summarise(const std::vector<CaseResult>& cases, double wall_seconds) {
  Summary summary{.cases = cases.size(), .wall_seconds = wall_seconds};
  for (const CaseResult& result : cases) {
    summary.passed += result.status == Status::kPassed ? 1 : 0;
    summary.failed += result.status == Status::kFailed ? 1 : 0;
    summary.skipped += result.status == Status::kSkipped ? 1 : 0;
    summary.identical += result.verdict.count(judge::Verdict::kIdentical);
    summary.permitted += result.verdict.count(judge::Verdict::kPermitted);
    summary.imprecise += result.verdict.count(judge::Verdict::kImprecise);
    summary.candidate_faults += result.verdict.candidate_faults();
    summary.reference_faults += result.verdict.reference_faults();
    summary.failed_checks += static_cast<uint64_t>(std::count_if(
        result.checks.begin(), result.checks.end(),
        [](const judge::CheckResult& check) { return check.outcome == judge::CheckResult::Outcome::kFailed; }));
  }
  return summary;
}

}  // namespace fillrule::run
