#include "harness/programs/texture_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace fillrule::programs {
namespace {

// Texels that are further away are all alike to wrapping, within float32's own resolution.
constexpr double kFarTexel = 0x1p40;

int64_t floor_to_texel(double coordinate) {
  return static_cast<int64_t>(std::floor(std::clamp(coordinate, -kFarTexel, kFarTexel)));
}

int64_t modulo(int64_t value, int64_t divisor) {
  // Nearly always; a division takes longer than all else.
  if (value >= 0 && value < divisor) return value;
  const int64_t rest = value % divisor;
  return rest < 0 ? rest + divisor : rest;
}

// Nothing is the border.
std::optional<int64_t> wrapped(int64_t i, int64_t size, VkSamplerAddressMode mode) {
  switch (mode) {
    case VK_SAMPLER_ADDRESS_MODE_REPEAT:
      return modulo(i, size);
    case VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT: {
      const int64_t within = modulo(i, 2 * size);
      return within < size ? within : 2 * size - 1 - within;
    }
    case VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER:
      return i < 0 || i >= size ? std::nullopt : std::optional(i);
    default:
      return std::clamp<int64_t>(i, 0, size - 1);
  }
}

Texel mix(const Texel& a, const Texel& b, double weight) {
  Texel mixed{};
  for (size_t c = 0; c < mixed.size(); ++c) {
    mixed[c] = static_cast<float>(double{a[c]} * (1 - weight) + double{b[c]} * weight);
  }
  return mixed;
}

// At coordinates that are wrapped.
Texel texel_at(const TextureLevel& level, const Sampling2D& sampling, std::optional<int64_t> x,
               std::optional<int64_t> y) {
  if (!x || !y) {
    const float value = sampling.border == VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE ? 1.0F : 0.0F;
    return {value, value, value, 1};
  }
  return level.texels[static_cast<size_t>(*y) * level.width + static_cast<size_t>(*x)];
}

}  // namespace

Texel texel(const TextureLevel& level, const Sampling2D& sampling, int64_t x, int64_t y) {
  return texel_at(level, sampling, wrapped(x, level.width, sampling.wrap_u),
                  wrapped(y, level.height, sampling.wrap_v));
}

Texel sample_level(const TextureLevel& level, const Sampling2D& sampling, double u, double v) {
  // What a coordinate that is not a number gives is left open; nothing may break.
  const double x = std::isnan(u) ? 0 : u * level.width;
  const double y = std::isnan(v) ? 0 : v * level.height;
  if (sampling.filter == VK_FILTER_NEAREST) {
    return texel(level, sampling, floor_to_texel(x), floor_to_texel(y));
  }
  const int64_t left = floor_to_texel(x - 0.5);
  const int64_t top = floor_to_texel(y - 0.5);
  const double weight_x = std::clamp(x - 0.5 - static_cast<double>(left), 0.0, 1.0);
  const double weight_y = std::clamp(y - 0.5 - static_cast<double>(top), 0.0, 1.0);
  const std::array columns{wrapped(left, level.width, sampling.wrap_u),
                           wrapped(left + 1, level.width, sampling.wrap_u)};
  const auto row = [&](int64_t y) {
    const std::optional<int64_t> wrapped_y = wrapped(y, level.height, sampling.wrap_v);
    return mix(texel_at(level, sampling, columns[0], wrapped_y), texel_at(level, sampling, columns[1], wrapped_y),
               weight_x);
  };
  return mix(row(top), row(top + 1), weight_y);
}

Texel sample(const Texture& texture, double u, double v, double level_of_detail) {
  const Sampling2D& sampling = texture.sampling;
  const auto last = static_cast<double>(texture.levels.size() - 1);
  const double level = std::clamp(level_of_detail, 0.0, last);
  if (sampling.mipmaps != Mipmaps::kLinear) {
    // "Image Level(s) Selection": the preferred rounding of the nearest one is ceil(d + 0.5) - 1.
    const double nearest = sampling.mipmaps == Mipmaps::kNone ? 0 : std::max(std::ceil(level + 0.5) - 1, 0.0);
    return sample_level(texture.levels[static_cast<size_t>(nearest)], sampling, u, v);
  }
  const double fine = std::floor(level);
  const auto coarse = static_cast<size_t>(std::min(fine + 1, last));
  return mix(sample_level(texture.levels[static_cast<size_t>(fine)], sampling, u, v),
             sample_level(texture.levels[coarse], sampling, u, v), level - fine);
}

}  // namespace fillrule::programs
