// Makes a case with a fault small: whatever triangle it does not take is left out.
#pragma once

#include <functional>

#include "cases/model/case.h"

namespace fillrule::stress {

// True if the case still shows the fault.
using StillFails = std::function<bool(const Case&)>;

// Leaves out one triangle after the other while `still_fails` says so. Strips, fans and indexed draws become lists if
// the fault survives that; otherwise they stay whole.
Case reduce(const Case& failing, const StillFails& still_fails);

}  // namespace fillrule::stress
