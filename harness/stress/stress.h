// Random triangles by the million: drawn by both parties, judged, counted by family; every case with a fault is made
// as small as it gets and written as a case file.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "harness/run/deviations.h"
#include "harness/run/run.h"
#include "harness/run/suite_runner.h"
#include "harness/stress/family.h"

namespace fillrule::stress {

struct StressOptions {
  uint64_t seed = 1;
  uint64_t triangles = 100'000;  // at least so many; the last case is drawn whole
  std::vector<Family> families;  // all, if none
  std::string folder = "build/stress";
  // Files for each family: so many for faults of the candidate, and so many for new faults of the reference alone.
  uint32_t files_per_family = 20;
  std::vector<run::Deviation> known;  // faults of the reference that are counted and not told
};

// Samples are summed over all planes.
struct FamilyCounts {
  Family family{};
  uint64_t cases = 0;
  uint64_t triangles = 0;
  uint64_t identical = 0;
  uint64_t permitted = 0;
  uint64_t imprecise = 0;
  uint64_t candidate_faults = 0;
  uint64_t reference_faults = 0;
  uint64_t failed_cases = 0;  // the candidate is at fault, or somebody could not draw
  // Cases where the reference alone is at fault, with deviations that are all known, and with others.
  uint64_t known_deviation_cases = 0;
  uint64_t unexpected_deviation_cases = 0;
};

// A case with a fault, reduced to the triangles that it takes.
struct Finding {
  run::CaseResult result;  // its name is the file's, as other commands take it
  std::string message;     // why none was, otherwise empty
};

struct StressResult {
  run::RunResult run;  // who was judged against whom, and the timing; without cases
  std::vector<FamilyCounts> families;
  std::vector<Finding> findings;
  double wall_seconds = 0;

  [[nodiscard]] FamilyCounts total() const;
};

// How many triangles have been judged so far.
using Progress = std::function<void(uint64_t)>;

// The cases and the counts depend on the options alone, not on the number of jobs.
StressResult run_stress(const StressOptions& options, run::SuiteRunner& runner, const Progress& progress);

// The counts as a table, and the rate.
std::string summary_text(const StressResult& result);

}  // namespace fillrule::stress
