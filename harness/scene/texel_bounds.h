// The bounds of what a sampler gives: color_bounds.h says how they come about.
#pragma once

#include "harness/scene/color_bounds.h"

namespace fillrule::scene {

ColorBounds texel_bounds(const Texture& texture, const SurfaceRange& range, const SamplerPrecision& precision);

// In the middle of the range, its errors left aside.
std::array<double, 3> exact_texel(const Texture& texture, const SurfaceRange& range);

}  // namespace fillrule::scene
