// report.html of several shards, put together: what each of them shows of a case is taken over as it is.
#pragma once

#include <string>
#include <vector>

#include "cases/model/result.h"
#include "harness/run/deviations.h"
#include "harness/run/run.h"

namespace fillrule::report {

// Reads report.html in each of `folders` and writes that of the merged results to `folder`. It is an error if one is
// missing, or is no page of this program.
Result<void> merge_pages(const std::vector<std::string>& folders, const std::string& folder,
                         const run::RunResult& merged, const run::DeviationReport& deviations);

}  // namespace fillrule::report
