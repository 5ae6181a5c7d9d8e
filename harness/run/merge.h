// The shards of a run, put together again.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "harness/run/run.h"

namespace fillrule::run {

// The cases of the shard, of all the cases of a suite.
std::vector<Case> cases_of(const Shard& shard, std::vector<Case> suite);

struct NamedResult {
  std::string file;  // for errors
  RunResult result;
};

// One run of the whole suite, with its cases in the suite's order. Seconds are summed up, but for the run's own: the
// shards ran side by side, so it took as long as the longest. Results of runs that were not split are joined too, in
// the order of the names of their cases. It is an error if the parties or the profiles differ, a shard is missing or
// there twice, or two results hold a case of the same name.
Result<RunResult> merge_results(std::span<const NamedResult> parts);

}  // namespace fillrule::run
