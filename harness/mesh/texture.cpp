#include "harness/mesh/texture.h"

#include <algorithm>

#include "harness/images/images.h"

namespace fillrule::mesh {
namespace {

Texel texel_of(const float* channels, size_t count) {
  switch (count) {
    case 1:
      return {channels[0], channels[0], channels[0], 1};
    case 2:
      return {channels[0], channels[0], channels[0], channels[1]};
    case 3:
      return {channels[0], channels[1], channels[2], 1};
    default:
      return {channels[0], channels[1], channels[2], channels[3]};
  }
}

}  // namespace

TextureLevel half_of(const TextureLevel& level) {
  TextureLevel half{.width = std::max(level.width / 2, 1U), .height = std::max(level.height / 2, 1U)};
  half.texels.reserve(size_t{half.width} * half.height);
  for (uint32_t y = 0; y < half.height; ++y) {
    for (uint32_t x = 0; x < half.width; ++x) {
      Texel sum{};
      for (uint32_t i = 0; i < 4; ++i) {
        const uint32_t from_x = std::min(2 * x + i % 2, level.width - 1);
        const uint32_t from_y = std::min(2 * y + i / 2, level.height - 1);
        const Texel& texel = level.texels[size_t{from_y} * level.width + from_x];
        for (size_t c = 0; c < 4; ++c) sum[c] += texel[c];
      }
      for (float& channel : sum) channel /= 4;
      half.texels.push_back(sum);
    }
  }
  return half;
}

Result<Texture> read_texture(const std::string& path, const Sampling2D& sampling) {
  const Result<images::Image> image = images::read(path, 4);
  if (!image) return tl::unexpected(image.error());
  const size_t channels = image->layout.channels.size();
  Texture texture{.sampling = sampling};
  TextureLevel level{.width = image->layout.width, .height = image->layout.height};
  level.texels.reserve(image->values.size() / channels);
  for (size_t i = 0; i < image->values.size(); i += channels) {
    level.texels.push_back(texel_of(&image->values[i], channels));
  }
  texture.levels.push_back(std::move(level));
  while (sampling.mipmaps != Mipmaps::kNone &&
         (texture.levels.back().width > 1 || texture.levels.back().height > 1)) {
    texture.levels.push_back(half_of(texture.levels.back()));
  }
  return texture;
}

}  // namespace fillrule::mesh
