// The state file: how far a small world has been gone through and what was found, so that an interruption loses
// seconds. JSON; replaced as a whole, so that there is never half of one.
#pragma once

#include <optional>
#include <string>

#include "harness/exhaust/exhaust.h"

namespace fillrule::exhaust {

// What must be equal for a state to be taken up again: the world, the parties with their versions, and the program
// itself, since another build may draw otherwise.
std::string identity_of(const Options& options, const Parties& parties);

Result<void> save_state(const std::string& path, const std::string& identity, const Progress& progress);

// Nothing if there is no such file. An error if it is no state file, or one of another identity.
Result<std::optional<Progress>> load_state(const std::string& path, const std::string& identity);

}  // namespace fillrule::exhaust
