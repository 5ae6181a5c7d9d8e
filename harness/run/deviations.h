// The known deviations of a reference driver: faults of its own that have been looked into, so that a new one stands
// out, and so does an old one that is gone. One file for each version of a driver:
// ci/expected/<driver>-<version>.toml.
//
//   [[deviation]]
//   cases = ["interpolation/noperspective_clipped*"]   # with * and ? as wildcards
//   planes = ["straight"]
//   reason = "..."                                     # what goes wrong and how that was found out
//   source = "..."                                     # a thread, or "derived"
#pragma once

#include <string>
#include <vector>

#include "cases/model/result.h"
#include "harness/run/run.h"

namespace fillrule::run {

struct Deviation {
  std::vector<std::string> cases;  // patterns
  std::vector<std::string> planes;
  std::string reason;
  std::string source;
};

// What a run says about the list.
struct DeviationReport {
  struct Fault {
    std::string case_name;
    std::string plane;
    uint64_t samples = 0;
  };
  std::vector<Fault> unexpected;  // faults of the reference that no entry covers
  std::vector<Fault> known;
  std::vector<Deviation> gone;  // entries whose cases were run without a fault in one of the planes
};

// "lavapipe-22.3.6.toml": the driver and the first number with dots in its version.
std::string deviations_file_name(const Reference& reference);

// Errors name file, line and column.
Result<std::vector<Deviation>> read_deviations(const std::string& path);

// What is known of the reference, from the lists in the folder; nothing where there is none for its version.
Result<std::vector<Deviation>> known_deviations(const std::string& folder, const Reference& reference);

DeviationReport compare_with_known(const std::vector<CaseResult>& cases, const std::vector<Deviation>& known);

}  // namespace fillrule::run
