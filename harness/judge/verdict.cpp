#include "harness/judge/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

void record(PlaneVerdict& plane, const SampleRecord& sample) {
  // The box and the first sample belong to the gravest class met.
  if (!plane.first || sample.verdict > plane.first->verdict) {
    plane.first = sample;
    plane.bounds = Bounds{.min_x = sample.x, .min_y = sample.y, .max_x = sample.x, .max_y = sample.y};
  } else if (sample.verdict == plane.first->verdict) {
    Bounds& box = *plane.bounds;
    box = {.min_x = std::min(box.min_x, sample.x),
           .min_y = std::min(box.min_y, sample.y),
           .max_x = std::max(box.max_x, sample.x),
           .max_y = std::max(box.max_y, sample.y)};
  }
  if (!plane.worst || graver(sample, *plane.worst)) plane.worst = sample;
}

void keep_worst(std::vector<SampleRecord>& worst, const SampleRecord& sample) {
  if (worst.size() == kWorstSamples && !graver(sample, worst.back())) return;
  worst.insert(std::upper_bound(worst.begin(), worst.end(), sample, graver), sample);
  if (worst.size() > kWorstSamples) worst.pop_back();
}

double ulps_between(double value, double exact) {
  if (std::isnan(exact)) return 0;
  const float rounded = std::abs(static_cast<float>(exact));
  const double ulp = double{std::nextafter(rounded, std::numeric_limits<float>::infinity())} - double{rounded};
  return std::abs(value - exact) / ulp;
}

}  // namespace fillrule::judge
