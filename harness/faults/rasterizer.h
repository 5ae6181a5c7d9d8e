// A naive rasterizer that draws everything a case can ask for: each sample of each primitive is asked one by one. It
// is not the renderer under test and shares nothing with it. On request it makes one classic fault.
#pragma once

#include <cstdint>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "harness/faults/fault.h"

namespace fillrule::faults {

Planes draw_case(const Case& drawn, Fault fault, uint32_t subpixel_bits);

}  // namespace fillrule::faults
