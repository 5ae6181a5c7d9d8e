#include "harness/mesh/image.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>

#include "cases/model/case.h"

namespace fillrule::mesh {
namespace {

tl::unexpected<Error> cannot_read(const std::string& path, const std::string& reason) {
  return tl::unexpected(Error{.file = path, .what = "cannot be read as an image: " + reason});
}

Texel texel_of(const float* channels, int count) {
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

Result<void> write_image(const std::string& path, uint32_t width, uint32_t height, std::span<const float> rgb) {
  const auto cannot_write = [&](const std::string& reason) {
    return tl::unexpected(Error{.file = path, .what = "cannot be written as an image: " + reason});
  };
  const auto output = OIIO::ImageOutput::create(path);
  if (!output) return cannot_write(OIIO::geterror());
  const OIIO::TypeDesc type = path.ends_with(".exr") ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
  const OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), 3, type);
  if (!output->open(path, spec) || !output->write_image(OIIO::TypeDesc::FLOAT, rgb.data()) || !output->close()) {
    return cannot_write(output->geterror());
  }
  return {};
}

Result<Texture> read_texture(const std::string& path, const Sampling2D& sampling) {
  const auto input = OIIO::ImageInput::open(path);
  if (!input) return cannot_read(path, OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  const auto is_size = [](int size) { return size > 0 && size <= static_cast<int>(kMaxTargetSize); };
  if (!is_size(spec.width) || !is_size(spec.height) || spec.nchannels < 1) {
    return cannot_read(path, fmt::format("{} x {} pixels of {} channels; at most {} x {}", spec.width, spec.height,
                                         spec.nchannels, kMaxTargetSize, kMaxTargetSize));
  }
  const int channels = std::min(spec.nchannels, 4);
  const size_t pixels = static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height);
  std::vector<float> values(pixels * static_cast<size_t>(channels));
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, values.data())) {
    return cannot_read(path, input->geterror());
  }
  Texture texture{.sampling = sampling};
  TextureLevel level{.width = static_cast<uint32_t>(spec.width), .height = static_cast<uint32_t>(spec.height)};
  level.texels.reserve(pixels);
  for (size_t i = 0; i < pixels; ++i) {
    level.texels.push_back(texel_of(&values[i * static_cast<size_t>(channels)], channels));
  }
  texture.levels.push_back(std::move(level));
  while (sampling.mipmaps != Mipmaps::kNone &&
         (texture.levels.back().width > 1 || texture.levels.back().height > 1)) {
    texture.levels.push_back(half_of(texture.levels.back()));
  }
  return texture;
}

}  // namespace fillrule::mesh
