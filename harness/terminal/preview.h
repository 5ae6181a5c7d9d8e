// Pictures in the terminal itself.
#pragma once

#include <string>

#include "cases/model/case.h"
#include "harness/run/suite_runner.h"
#include "harness/terminal/style.h"

namespace fillrule::terminal {

// Candidate | reference | verdict, in the way that the style names; empty where that is none.
std::string preview_text(const Case& test_case, const run::Drawing& drawing, const Style& style);

}  // namespace fillrule::terminal
