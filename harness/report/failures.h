// What a run leaves of the cases in which someone is at fault: each is drawn once more, and shown as PNG, EXR and in
// report.html. Whoever draws the same case twice gets the same bytes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/run/deviations.h"
#include "harness/run/suite_runner.h"

namespace fillrule::report {

struct FailureFiles {
  uint64_t cases = 0;         // that have pictures
  std::vector<Error> errors;  // of cases that could not be drawn, and of files that could not be written
};

// `runner` is the one that gave `result` for `cases`; `faults_file`: faults.json of `fillrule faults`, shown where it
// is there; `jobs`: cases encoded at the same time.
FailureFiles write_failures(const std::string& folder, const std::string& faults_file, run::SuiteRunner& runner,
                            const judge::Profile& profile, const std::vector<Case>& cases,
                            const run::RunResult& result, const run::DeviationReport& deviations, uint32_t jobs);

}  // namespace fillrule::report
