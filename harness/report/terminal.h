// What a run says on the terminal, as text without colours; the command line prints it.
#pragma once

#include <string>

#include "harness/run/run.h"

namespace fillrule::report {

// One case: its status, and for each plane that is not identical throughout the counts, the bounding box, and the
// first and the worst sample with both values, the exact one and the tolerance.
std::string case_text(const run::CaseResult& result);

// Who was judged against whom.
std::string parties_text(const run::RunResult& result);

// The parties, and counts of cases and samples.
std::string summary_text(const run::RunResult& result);

// Where the time went.
std::string timing_text(const run::RunResult& result);

}  // namespace fillrule::report
