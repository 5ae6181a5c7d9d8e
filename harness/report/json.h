// results.json: everything a run found, for other programs.
#pragma once

#include <string>

#include "cases/model/result.h"
#include "harness/run/deviations.h"
#include "harness/run/run.h"

namespace fillrule::report {

// {summary, candidate, reference, timing, cases: [{name, file, status, message, seconds, samples, may_samples,
// checks, planes: {NAME: {identical, permitted, imprecise, candidate_faults, reference_faults, first, worst}}}]}
std::string to_json(const run::RunResult& result, const run::DeviationReport& deviations);

// Writes the text to the file. The error names the file.
Result<void> write_text(const std::string& path, const std::string& text);

}  // namespace fillrule::report
