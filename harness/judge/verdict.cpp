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

}  // namespace fillrule::judge
