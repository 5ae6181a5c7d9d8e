// A run of samples in a row about which the oracle is certain: either nothing lands there, or one primitive on top.
// Whole planes are compared at once with the exact values, which is many times faster than asking sample by sample;
// whatever is not well within its tolerance is left to that. What is exact is the same for all parties of equal
// subpixel bits, and worked out once for them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "harness/judge/components.h"
#include "harness/judge/possibilities.h"
#include "harness/judge/verdict.h"

namespace fillrule::judge {

class RowJudge {
 public:
  RowJudge(const Case& test_case, const exact::Expectation& expectation, ValueCache& values)
      : case_(test_case),
        expectation_(expectation),
        values_(values),
        sources_(component_sources(test_case.varyings)) {}

  // Prepares for samples [begin, end) of one class (Expectation::classes()), and of one row, unless nothing lands
  // there. False if it is not certain what does: several pieces may, or the only one may fail a depth test, or its
  // values are undefined ground.
  bool start(size_t begin, size_t end);
  // Prepares for samples [begin, end) of one row where it is certain what is on top, whatever is below. False if that
  // is no piece whose values can be told in rows.
  bool start_top(const Landed& landed, size_t begin, size_t end);

  // The piece on top; kNoOwner if nothing lands.
  [[nodiscard]] uint32_t top() const { return top_; }

  // Whether a party's hits, owner and facing are what they have to be, at every sample.
  [[nodiscard]] bool integers_right(const Planes& planes) const;

  // Works out the exact values of depth or of one component, for the functions below. False if only the slow path
  // can.
  bool expect(PlaneKind kind, uint32_t component);
  // A party's values are all within their tolerance.
  [[nodiscard]] bool within(const Planes& planes) const;
  // Whether two parties' values differ in their bits.
  [[nodiscard]] bool differ(const Planes& a, const Planes& b) const;
  // Sets a bit in each sample's mark whose value has other bits than the other party's, or, where there is none, is
  // not the exact value rounded to float32. The first party's values must be within their tolerance.
  void mark_different(const Planes& planes, const Planes* other, std::span<uint32_t> marks) const;

 private:
  enum class Landing : uint8_t { kUnknown, kCertain, kUncertain };
  Landing landing_of(uint32_t number);
  void begin_run(uint32_t top, uint32_t hits, size_t begin, size_t end);
  bool expect_depth();
  bool expect_varying(uint32_t component);
  bool expect_constant(float value);
  std::span<double> first_of(std::vector<double>& values) const;
  // Those of a pixel have values of their own, which are asked for one by one.
  [[nodiscard]] bool has_several_samples() const { return case_.target.samples != VK_SAMPLE_COUNT_1_BIT; }
  // A party's values, from the run's first sample on.
  [[nodiscard]] const float* values(const Planes& planes) const;

  const Case& case_;
  const exact::Expectation& expectation_;
  ValueCache& values_;
  std::vector<ComponentSource> sources_;
  std::vector<Landing> landing_;  // for each primitive, once asked
  uint32_t top_ = kNoOwner;
  uint32_t hits_ = 0;
  size_t begin_ = 0;
  size_t size_ = 0;
  double x_ = 0;
  double y_ = 0;
  bool has_w_ = false;
  std::vector<double> w_;  // of the run's samples, as what follows; there may be more
  // Of the plane that was asked for last.
  PlaneKind kind_ = PlaneKind::kDepth;
  uint32_t component_ = 0;
  std::optional<float> constant_;  // the exact value of all samples, to the bit
  std::vector<double> expected_;
  std::vector<double> least_;
};

}  // namespace fillrule::judge
