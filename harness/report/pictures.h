// Pictures and planes of one case: candidate | reference | difference as one PNG, every plane as EXR.
#pragma once

#include <string>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "harness/run/suite_runner.h"

namespace fillrule::report {

// A name for files: letters, digits and - = . , + _ stay, everything else becomes _; long names end in a hash.
std::string file_stem(const std::string& case_name);

// Writes FOLDER/STEM.png and FOLDER/STEM.candidate.exr (.reference.exr where there is a reference), and returns the
// paths. Small targets are enlarged in the PNG, each pixel to a square.
Result<std::vector<std::string>> write_pictures(const std::string& folder, const Case& test_case,
                                                const run::Drawing& drawing);

}  // namespace fillrule::report
