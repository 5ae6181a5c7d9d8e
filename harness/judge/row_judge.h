// One party along a run of samples in a row about which the oracle is certain: either nothing lands there, or one
// primitive alone. Whole planes are compared at once with the exact values, which is many times faster than asking
// sample by sample; whatever is not well within its tolerance is left to that.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "harness/judge/components.h"
#include "harness/judge/possibilities.h"
#include "harness/judge/verdict.h"

namespace fillrule::judge {

class RowJudge {
 public:
  RowJudge(const Case& test_case, const Planes& planes, const exact::Expectation& expectation, ValueCache& values)
      : case_(test_case),
        planes_(planes),
        expectation_(expectation),
        values_(values),
        sources_(component_sources(test_case.varyings)) {}

  // Prepares for samples [begin, end) of one row; `sole` as Expectation::sole() has it, not kSeveral. False if the
  // outcome is not certain after all: a depth test that may fail, or a primitive whose values are undefined ground.
  bool start(uint32_t sole, size_t begin, size_t end);

  // Hits, owner and facing are what they have to be, at every sample.
  [[nodiscard]] bool integers_right() const;

  // The values of depth or of one component are all within their tolerance. Remembers the exact values.
  bool within(PlaneKind kind, uint32_t component);

  // Clears the mark of each sample whose value has other bits than `other`, or, where that is null, is not the exact
  // value rounded to float32. Follows within() for the same plane.
  void mark_equal(PlaneKind kind, uint32_t component, const float* other, std::span<uint8_t> equal) const;

  // The party's values, from the run's first sample on.
  [[nodiscard]] const float* values(PlaneKind kind, uint32_t component) const;

 private:
  enum class Landing : uint8_t { kUnknown, kCertain, kUncertain };
  Landing landing_of(uint32_t number);
  bool depth_within(const float* row);

  const Case& case_;
  const Planes& planes_;
  const exact::Expectation& expectation_;
  ValueCache& values_;
  std::vector<ComponentSource> sources_;
  std::vector<Landing> landing_;  // for each primitive, once asked
  uint32_t sole_ = 0;
  size_t begin_ = 0;
  size_t size_ = 0;
  double x_ = 0;
  double y_ = 0;
  bool has_w_ = false;
  std::vector<double> w_;
  std::vector<double> expected_;
  std::vector<double> least_;
};

}  // namespace fillrule::judge
