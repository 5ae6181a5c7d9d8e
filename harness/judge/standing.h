// One party at one sample, held against what the oracle allows there.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/judge/components.h"
#include "harness/judge/possibilities.h"

namespace fillrule::judge {

// How a party's value stands to the oracle's.
struct Standing {
  enum class Class : uint8_t { kExact, kWithin, kImprecise, kOutside };
  Class level = Class::kExact;
  double expected = 0;   // NaN where several answers are right
  double tolerance = 0;  // infinite where the value is not judged
  double spread = 0;     // the part of the tolerance within which every value is exact (exact::Expected)
  double severity = 0;   // error / tolerance

  [[nodiscard]] bool outside() const { return level == Class::kOutside; }
};

// Judges one party's planes; `index` is that of Planes.
class PartyJudge {
 public:
  PartyJudge(const Case& test_case, const Planes& planes, const exact::Expectation& expectation, ValueCache& values);

  // Whether the planes break a rule for lines as a whole there.
  [[nodiscard]] bool breaks_line_rule(size_t index) const;
  [[nodiscard]] Standing coverage(const Possibilities& possible, size_t index) const;
  [[nodiscard]] Standing hits(const Possibilities& possible, size_t index) const;
  [[nodiscard]] Standing owner(const Possibilities& possible, size_t index) const;
  [[nodiscard]] Standing front_facing(const Possibilities& possible, size_t index) const;
  [[nodiscard]] Standing depth(const Possibilities& possible, size_t index) const;
  [[nodiscard]] Standing varying(const Possibilities& possible, size_t index, uint32_t component) const;

 private:
  [[nodiscard]] Standing depth_of(const Outcome& outcome, size_t index) const;
  [[nodiscard]] Standing varying_of(const Outcome& outcome, size_t index, uint32_t component) const;
  [[nodiscard]] Standing frag_coord(const exact::Piece& piece, const exact::PieceValues& values,
                                    const ComponentSource& source, float value,
                                    const exact::SamplePlace& place) const;
  [[nodiscard]] Standing point_coord(const exact::Piece& piece, const exact::PieceValues& values,
                                     const ComponentSource& source, float value,
                                     const exact::SamplePlace& place) const;
  // The best standing over the places where a value may be evaluated that is neither at a sample nor a centroid: the
  // pixel's centre, or, where samples are shaded, the sample too.
  template <typename StandingAt>
  [[nodiscard]] Standing best_place(const exact::SamplePlace& place, const StandingAt& standing_at) const;

  const Case& case_;
  const Planes& planes_;
  const exact::Expectation& expectation_;
  ValueCache& values_;
  std::vector<ComponentSource> sources_;  // of each component
  bool shades_samples_;
  std::vector<size_t> broken_;  // where a rule for lines as a whole is broken (line_rules.h)
};

}  // namespace fillrule::judge
