#include "harness/report/names.h"

namespace fillrule::report {

std::string_view name_of(judge::Verdict verdict) {
  switch (verdict) {
    case judge::Verdict::kIdentical:
      return "identical";
    case judge::Verdict::kPermitted:
      return "permitted";
    case judge::Verdict::kImprecise:
      return "imprecise";
    case judge::Verdict::kReferenceFault:
      return "reference fault";
    case judge::Verdict::kCandidateFault:
      return "candidate fault";
    case judge::Verdict::kBothFault:
      return "both at fault";
  }
  return "";
}

std::string_view name_of(run::Status status) {
  switch (status) {
    case run::Status::kPassed:
      return "passed";
    case run::Status::kFailed:
      return "failed";
    case run::Status::kSkipped:
      return "skipped";
  }
  return "";
}

std::string_view name_of(judge::CheckResult::Outcome outcome) {
  switch (outcome) {
    case judge::CheckResult::Outcome::kPassed:
      return "passed";
    case judge::CheckResult::Outcome::kFailed:
      return "failed";
    case judge::CheckResult::Outcome::kOptedOut:
      return "opted out";
    case judge::CheckResult::Outcome::kDoesNotFit:
      return "does not fit";
  }
  return "";
}

}  // namespace fillrule::report
