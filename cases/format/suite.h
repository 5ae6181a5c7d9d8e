// The suite: which case files there are, and the cases that a command line names.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/result.h"

namespace fillrule::format {

// Cases have distinct names. An error stops neither the other files nor the other selectors.
struct Suite {
  std::vector<Case> cases;
  std::vector<Error> errors;
};

// Shown the text of each file, before any of them is made into cases.
using Preview = std::function<void(std::string_view text)>;

// The cases that `selectors` name, each once, in the order of the selectors and by name within each; all below
// `root` if there are none. A selector is
//   - a file or a folder, looked up from the current folder, then from `root`. Its cases are named by their path
//     below `root`, or outside of it by their path below the given folder (a file: by its stem); or
//   - a case name with the wildcards of glob.h, with the sweep's suffix or without: "clipping/*",
//     "clipping/near_plane[angle=30]", "coverage/tie".
// Only files whose cases can match are read. A selector that finds nothing is an error.
Suite load_suite(const std::string& root, std::span<const std::string> selectors, const Preview& preview = {});

}  // namespace fillrule::format
