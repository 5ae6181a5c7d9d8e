// What samples that are missing or too many have in common.
#pragma once

#include <span>
#include <string>

#include "cases/model/case.h"
#include "harness/explain/explanation.h"
#include "harness/report/sample_class.h"
#include "harness/run/suite_runner.h"

namespace fillrule::report {

// "primitive 2 is lost as a whole"; empty where nothing is found.
std::string coverage_pattern(const Case& test_case, const run::Drawing& drawing, bool of_reference,
                             std::span<const SampleMark> marks, std::span<const explain::Explanation> explanations);

// "the picture is shifted by a pixel to the right": where the party's picture, if it were put elsewhere, would be
// right throughout; empty where it would not.
std::string displacement_of(const run::Drawing& drawing, bool of_reference);

}  // namespace fillrule::report
