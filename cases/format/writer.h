// Writes a case as a case file: what the reader makes of it is the same case, to the bit of every float. The name and
// the file are not part of the text. Positions are written in clip space, every state in full.
#pragma once

#include <string>

#include "cases/model/case.h"

namespace fillrule::format {

// `one` is a case that the reader could have given: within the format's limits and with all varyings present.
std::string write(const Case& one);

}  // namespace fillrule::format
