// A texture sampled as Vulkan has it ("Texel Filtering", "Texel Coordinate Systems", "Wrapping Operation"), in double
// from float32 coordinates.
#pragma once

#include <cstdint>

#include "cases/model/texture.h"

namespace fillrule::programs {

// The texel (x, y) of a level, wrapped, or the border's colour.
Texel texel(const TextureLevel& level, const Sampling2D& sampling, int64_t x, int64_t y);

// One level at normalized coordinates.
Texel sample_level(const TextureLevel& level, const Sampling2D& sampling, double u, double v);

// At a level of detail within those that there are.
Texel sample(const Texture& texture, double u, double v, double level_of_detail);

}  // namespace fillrule::programs
