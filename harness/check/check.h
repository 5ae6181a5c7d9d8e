// Lints case files: is the head complete and in the author's own words, is a control named, is the effect that the
// file is about really there? A case that nothing can fail is worse than none.
#pragma once

#include <span>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/result.h"

namespace fillrule::check {

// The findings in whole files. `cases`: all cases of these files, those of one file one after the other. `controls`:
// the cases of other files that they name as their control, and any others. Pictures are drawn by our renderer, what
// must be covered is the oracle's answer.
std::vector<Error> check_files(std::span<const Case> cases, std::span<const Case> controls);

}  // namespace fillrule::check
