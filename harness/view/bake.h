// A view as a case file: its clip-space floats, so that every party gets identical bits.
#pragma once

#include <string>

#include "cases/model/case.h"
#include "cases/model/result.h"

namespace fillrule::view {

// Writes a case that is built, without its scene, to FOLDER/NAME_view_N.toml with the first N from 1 that is free: no
// file is overwritten. The path.
Result<std::string> bake(const Case& built, const std::string& folder);

}  // namespace fillrule::view
