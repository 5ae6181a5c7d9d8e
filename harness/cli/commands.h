// The commands of `fillrule`. They print, and return the exit code.
#pragma once

#include "harness/cli/arguments.h"

namespace fillrule::cli {

int execute(const Arguments& arguments);

}  // namespace fillrule::cli
