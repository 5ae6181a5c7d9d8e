// Images as textures.
#pragma once

#include <string>

#include "cases/model/result.h"
#include "cases/model/texture.h"

namespace fillrule::mesh {

// The image with its levels, if the sampling has mipmaps; a single channel is grey, a missing alpha is 1. Integers
// are scaled to 0 to 1.
Result<Texture> read_texture(const std::string& path, const Sampling2D& sampling);

// The level below: each texel the mean of up to 2x2. A size that is odd loses its last row or column's own texel.
TextureLevel half_of(const TextureLevel& level);

}  // namespace fillrule::mesh
