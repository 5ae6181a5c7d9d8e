// The one case, scene or model that a command looks at, and the size it is looked at in.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "harness/cli/options.h"
#include "harness/scene/assets.h"

namespace fillrule::cli {

// The case that the first selector names, a scene not yet built; of an OBJ file a scene around it. `command` is what
// the errors call the command.
Result<Case> find_subject(const SuiteOptions& options, scene::Assets& assets, const std::string& command);

// "640x480"
Result<std::pair<uint32_t, uint32_t>> parse_size(const std::string& text);

}  // namespace fillrule::cli
