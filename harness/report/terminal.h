// What a run says on the terminal, as text without colours; the command line prints it.
#pragma once

#include <string>

#include "harness/run/deviations.h"
#include "harness/run/run.h"

namespace fillrule::report {

// One case: its status, and for each plane that is not identical throughout the counts, the bounding box, and the
// first and the worst sample with both values, the exact one and the tolerance.
std::string case_text(const run::CaseResult& result);

// Who was judged against whom.
std::string parties_text(const run::RunResult& result);

// The parties, and counts of cases and samples.
std::string summary_text(const run::RunResult& result);

// What the run says about the list of the reference's known deviations; empty if there is nothing to say.
std::string deviations_text(const run::RunResult& result, const run::DeviationReport& deviations);

// Of a run in which the candidate is a reference too: the cases in which the two draw differently, and who is wrong.
std::string disagreements_text(const run::RunResult& result);

}  // namespace fillrule::report
