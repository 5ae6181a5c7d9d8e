// Renderers that are broken on purpose, for tests of the report.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/run/candidate.h"

namespace fillrule::report {

// Their names.
std::vector<std::string_view> broken_candidates();

// Our renderer with one fault; an error where there is no such fault.
Result<run::Candidate> make_broken(std::string_view name);

}  // namespace fillrule::report
