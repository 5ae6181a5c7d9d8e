// The functions that expressions have beyond muParser's own. Plain functions of doubles, without state.
#pragma once

namespace fillrule::format {

// The remainder of floored division: 0 <= mod(x, y) < y for y > 0.
double floored_mod(double x, double y);

// x rounded to float32 and moved by `steps` representable float32 values; both zeros count as one value, and the
// infinities end the scale.
double ulp(double x, double steps);

// In [0, 1), the same on every machine: the top 53 bits of splitmix64(splitmix64(seed) xor k) of the arguments' bits.
double random_unit(double seed, double k);

}  // namespace fillrule::format
