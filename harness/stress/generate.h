// Random cases: a few triangles of one family, with random state, varyings and target.
//
// Triangles that fill their viewport have a cell of the target each, cut out by viewport or scissor, so that the
// values of every one can be judged; small ones are strewn over the whole target.
#pragma once

#include <cstdint>

#include "cases/model/case.h"
#include "harness/stress/family.h"

namespace fillrule::stress {

// The same case for the same arguments, always. It is called stress/<family>/<seed>-<number>.
Case random_case(uint64_t seed, Family family, uint64_t number);

}  // namespace fillrule::stress
