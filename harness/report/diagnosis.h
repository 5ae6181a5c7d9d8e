// What is wrong with a case as a whole, in one plain sentence: the class of error, how much of it, and the pattern if
// there is one.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "harness/explain/explanation.h"
#include "harness/report/sample_class.h"
#include "harness/run/suite_runner.h"

namespace fillrule::report {

struct Diagnosis {
  bool of_reference = false;  // only the reference is at fault
  SampleClass main = SampleClass::kRight;
  std::array<uint64_t, kSampleClassCount> counts{};  // samples by class; the faults are those of the party told of
  std::string sentence;                              // empty where there is no fault
};

// `marks`: mark_of() each sample. Patterns are found from the `explanations` of some samples, the gravest first.
Diagnosis diagnose(const Case& test_case, const run::Drawing& drawing, std::span<const SampleMark> marks,
                   std::span<const explain::Explanation> explanations);

}  // namespace fillrule::report
