// results.json: everything a run found, for other programs.
#pragma once

#include <string>

#include "cases/model/result.h"
#include "harness/run/deviations.h"
#include "harness/run/run.h"

namespace fillrule::report {

// {summary, candidate, reference, timing, shard, cases: [{name, file, status, message, reason, seconds, samples,
// may_samples, checks, planes: {NAME: {identical, permitted, imprecise, candidate_faults, reference_faults,
// both_at_fault, components, first, worst}}}]}; both_at_fault is counted in the two before it, shard is absent where
// the suite was not split.
std::string to_json(const run::RunResult& result, const run::DeviationReport& deviations);

// What to_json() wrote, but for the deviations and the warm timing. The error names the file, which is read to make
// it out.
Result<run::RunResult> read_results(const std::string& path);

// Writes the text to the file. The error names the file.
Result<void> write_text(const std::string& path, const std::string& text);

}  // namespace fillrule::report
