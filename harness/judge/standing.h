// One party at one sample, held against what the oracle allows there.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/judge/possibilities.h"

namespace fillrule::judge {

// How a party's value stands to the oracle's.
struct Standing {
  enum class Class : uint8_t { kExact, kWithin, kImprecise, kOutside };
  Class level = Class::kExact;
  double expected = 0;   // NaN where several answers are right
  double tolerance = 0;  // infinite where the value is not judged
  double severity = 0;   // error / tolerance

  [[nodiscard]] bool outside() const { return level == Class::kOutside; }
};

// Judges one party's planes; `index` is that of Planes.
class PartyJudge {
 public:
  PartyJudge(const Case& test_case, const Planes& planes, const exact::Expectation& expectation, ValueCache& values);

  [[nodiscard]] Standing coverage(const Possibilities& possible, size_t index) const;
  [[nodiscard]] Standing hits(const Possibilities& possible, size_t index) const;
  [[nodiscard]] Standing owner(const Possibilities& possible, size_t index) const;
  [[nodiscard]] Standing front_facing(const Possibilities& possible, size_t index) const;
  [[nodiscard]] Standing depth(const Possibilities& possible, size_t index) const;
  [[nodiscard]] Standing varying(const Possibilities& possible, size_t index, uint32_t component) const;

 private:
  [[nodiscard]] double x_of(size_t index) const { return static_cast<double>(index % planes_.width) + 0.5; }
  [[nodiscard]] double y_of(size_t index) const {
    const size_t row = index / planes_.width;
    return static_cast<double>(row) + 0.5;
  }
  [[nodiscard]] bool breaks_line_rule(size_t index) const;
  [[nodiscard]] Standing depth_of(const Outcome& outcome, size_t index) const;
  [[nodiscard]] Standing varying_of(const Outcome& outcome, size_t index, uint32_t component) const;

  const Case& case_;
  const Planes& planes_;
  const exact::Expectation& expectation_;
  ValueCache& values_;
  std::vector<Interpolation> interpolation_;  // of each component
  std::vector<size_t> broken_;                // where a rule for lines as a whole is broken (line_rules.h)
};

}  // namespace fillrule::judge
