// What the judge says of a case: per plane how many samples are identical, permitted, imprecise or at fault, whose
// fault it is, and where the first and the worst are.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fillrule::judge {

// One sample of one plane. Ordered by severity.
enum class Verdict : uint8_t {
  kIdentical,       // equal bits
  kPermitted,       // within what the specification leaves open
  kImprecise,       // a value beyond its bound, within exact::kImpreciseFactor of it
  kReferenceFault,  // only the reference is outside
  kCandidateFault,  // only the candidate is outside
  kBothFault,
};
inline constexpr size_t kVerdictCount = 6;

// So many of the worst samples are kept.
inline constexpr size_t kWorstSamples = 64;

enum class PlaneKind : uint8_t { kCoverage, kHits, kOwner, kFrontFacing, kDepth, kVarying };

// Where two parties differ, or one is at fault. Integer planes hold their numbers as doubles.
struct SampleRecord {
  uint32_t x = 0;
  uint32_t y = 0;
  uint32_t sample = 0;
  uint32_t component = 0;  // of a varying
  Verdict verdict = Verdict::kIdentical;
  double candidate = 0;
  std::optional<double> reference;  // none where the candidate is alone with the oracle
  double expected = 0;              // the exact value, NaN where there is more than one answer
  double tolerance = 0;             // of the expected value
  double severity = 0;              // the error in units of the tolerance; infinite for NaN and for wrong integers
};

// What the oracle says to the candidate at one sample.
struct OracleAnswer {
  enum class Coverage : uint8_t {
    kMustNot,
    kMay,
    kMust,
    kUndefined
  };  // kUndefined: kMay, as a primitive is undefined
  Coverage coverage = Coverage::kMustNot;
  std::optional<uint32_t> owner;  // none where several are right
};

struct Bounds {  // inclusive, pixels
  uint32_t min_x = 0;
  uint32_t min_y = 0;
  uint32_t max_x = 0;
  uint32_t max_y = 0;
  bool operator==(const Bounds&) const = default;
};

struct PlaneVerdict {
  std::string name;  // coverage, hits, owner, front_facing, depth, or the varying's name
  PlaneKind kind = PlaneKind::kCoverage;
  // Of a varying: where its components stand in Planes::varyings. A sample has one verdict, its worst component's.
  uint32_t first_component = 0;
  uint32_t components = 1;
  std::array<uint64_t, kVerdictCount> counts{};
  // Of the samples of the gravest verdict beyond kPermitted.
  std::optional<Bounds> bounds;
  std::optional<SampleRecord> first;
  std::optional<SampleRecord> worst;
  // Where the judge was asked for them: a verdict for each sample, and the gravest samples beyond kPermitted, the
  // worst one first.
  std::vector<Verdict> map;
  std::vector<SampleRecord> worst_samples;

  [[nodiscard]] uint64_t count(Verdict verdict) const { return counts[static_cast<size_t>(verdict)]; }
  [[nodiscard]] uint64_t candidate_faults() const {
    return count(Verdict::kCandidateFault) + count(Verdict::kBothFault);
  }
  [[nodiscard]] uint64_t reference_faults() const {
    return count(Verdict::kReferenceFault) + count(Verdict::kBothFault);
  }
};

struct CaseVerdict {
  std::vector<PlaneVerdict> planes;
  uint64_t samples = 0;
  uint64_t covered_samples = 0;      // samples that some primitive must or may cover
  uint64_t may_samples = 0;          // samples whose coverage the specification leaves open
  uint64_t undefined_samples = 0;    // those among them that are open because a primitive is undefined
  std::vector<OracleAnswer> oracle;  // one for each sample, where the judge was asked for maps

  [[nodiscard]] uint64_t count(Verdict verdict) const;
  [[nodiscard]] uint64_t candidate_faults() const;
  [[nodiscard]] uint64_t reference_faults() const;
  // The gravest of all planes: the first plane's among equals. None if all is identical or permitted.
  [[nodiscard]] std::optional<SampleRecord> worst() const;
};

// By verdict, then by severity.
bool graver(const SampleRecord& a, const SampleRecord& b);

// Takes a sample beyond kPermitted into the plane's box, its first and its worst sample.
void record(PlaneVerdict& plane, const SampleRecord& sample);

// Takes a sample into a list of the gravest kWorstSamples, the worst first, equal ones in the order they come.
void keep_worst(std::vector<SampleRecord>& worst, const SampleRecord& sample);

// How far a value is from the exact one, in units of the last place of the float32 next to that; 0 where the exact
// one is NaN, as there is more than one answer.
double ulps_between(double value, double exact);

}  // namespace fillrule::judge
