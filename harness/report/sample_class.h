// What is wrong at a sample, over all planes: the classes that maps, pictures and reports mark by letter and colour.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "harness/run/suite_runner.h"

namespace fillrule::report {

// Ordered by gravity.
enum class SampleClass : uint8_t {
  kRight,      // identical throughout
  kPermitted,  // differs, as the specification permits
  kImprecise,
  kVarying,
  kDepth,
  kFacing,
  kOwner,    // another primitive landed last
  kHits,     // too many or too few fragments landed
  kExtra,    // covered where nothing may be
  kMissing,  // not covered where something must be
};
inline constexpr size_t kSampleClassCount = 10;

struct SampleMark {
  SampleClass kind = SampleClass::kRight;
  bool reference_alone = false;  // it is the reference that is at fault, and not the candidate
  bool covered = false;          // by the candidate

  // The candidate's faults before the reference's.
  [[nodiscard]] bool graver_than(const SampleMark& other) const;
  // An upper-case letter for a fault of the candidate, a lower-case one for the reference's.
  [[nodiscard]] char letter() const;
};

std::string_view name_of(SampleClass kind);

// The drawing has the judge's maps. `index` as in Planes.
SampleMark mark_of(const run::Drawing& drawing, size_t index);

}  // namespace fillrule::report
