// A closer look at one case: it is drawn once more, which gives the same bytes.
#pragma once

#include <string>

#include "cases/model/case.h"
#include "harness/explain/explain.h"
#include "harness/judge/judge.h"
#include "harness/run/run.h"
#include "harness/run/suite_runner.h"
#include "harness/terminal/style.h"

namespace fillrule::cli {

// Everything about one sample of what the parties of the run have drawn.
Result<explain::Explanation> explain_sample(const run::RunResult& parties, const judge::Profile& profile,
                                            const Case& test_case, const run::Drawing& drawing,
                                            const explain::SampleId& sample);

// The one sentence that says why the worst sample is wrong; empty where none is.
std::string reason_of(const run::RunResult& parties, const judge::Profile& profile, const Case& test_case,
                      const run::Drawing& drawing);

// The worst samples, the map, and pictures if the terminal shows them.
std::string inspection_text(const Case& test_case, const run::Drawing& drawing, const terminal::Style& style);

}  // namespace fillrule::cli
