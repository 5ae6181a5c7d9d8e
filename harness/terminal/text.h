// What a run says on the terminal, as text; the command line prints it. Names from outside are made harmless.
#pragma once

#include <string>
#include <string_view>

#include "harness/run/deviations.h"
#include "harness/run/run.h"
#include "harness/terminal/style.h"

namespace fillrule::terminal {

// One case: its status, the reason in one sentence if it is known, and for each plane that is not identical
// throughout the counts, the bounding box, and the first and the worst sample with both values, the exact one and the
// tolerance; then `inspection`, and the commands that show more.
std::string case_text(const run::CaseResult& result, const Style& style, std::string_view inspection = {});

// "depth: 4 candidate fault, 252 identical": every sample of the plane.
std::string counts_text(const judge::PlaneVerdict& plane);

// What is wrong with a case, in one line: why it could not be judged, the counts of each plane with a fault, and the
// checks that failed. Empty if nothing is wrong.
std::string fault_text(const run::CaseResult& result);

// Who was judged against whom.
std::string parties_text(const run::RunResult& result);

// The parties, and counts of cases and samples.
std::string summary_text(const run::RunResult& result, const Style& style);

// What the run says about the list of the reference's known deviations; empty if there is nothing to say.
std::string deviations_text(const run::RunResult& result, const run::DeviationReport& deviations);

// Of a run in which the candidate is a reference too: the cases in which the two draw differently, and who is wrong.
std::string disagreements_text(const run::RunResult& result);

}  // namespace fillrule::terminal
