// Images as textures, by OpenImageIO: BMP, PNG, JPEG, EXR and whatever else it knows.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "cases/model/result.h"
#include "cases/model/texture.h"

namespace fillrule::mesh {

// The image with its levels, if the sampling has mipmaps; a single channel is grey, a missing alpha is 1. Integers
// are scaled to 0 to 1.
Result<Texture> read_texture(const std::string& path, const Sampling2D& sampling);

// Writes r, g, b of each pixel, row by row from the top left: .png as 8 bits, .exr and whatever else OpenImageIO
// knows by the path's ending as it takes them. Values are not converted but for rounding.
Result<void> write_image(const std::string& path, uint32_t width, uint32_t height, std::span<const float> rgb);

// The level below: each texel the mean of up to 2x2. A size that is odd loses its last row or column's own texel.
TextureLevel half_of(const TextureLevel& level);

}  // namespace fillrule::mesh
