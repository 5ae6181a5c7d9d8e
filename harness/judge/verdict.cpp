#include "harness/judge/verdict.h"

namespace fillrule::judge {

uint64_t CaseVerdict::count(Verdict verdict) const {
  uint64_t sum = 0;
  for (const PlaneVerdict& plane : planes) sum += plane.count(verdict);
  return sum;
}

uint64_t CaseVerdict::candidate_faults() const {
  return count(Verdict::kCandidateFault) + count(Verdict::kBothFault);
}

uint64_t CaseVerdict::reference_faults() const {
  return count(Verdict::kReferenceFault) + count(Verdict::kBothFault);
}

std::optional<SampleRecord> CaseVerdict::worst() const {
  std::optional<SampleRecord> worst;
  for (const PlaneVerdict& plane : planes) {
    if (plane.worst && (!worst || graver(*plane.worst, *worst))) worst = plane.worst;
  }
  return worst;
}

bool graver(const SampleRecord& a, const SampleRecord& b) {
  return a.verdict > b.verdict || (a.verdict == b.verdict && a.severity > b.severity);
}

}  // namespace fillrule::judge
