// What a fragment program samples, and how: texels and the state of a sampler (Vulkan specification, "Image
// Operations", "Samplers").
//
// Plain values. Texel (0, 0) of a level is at (u, v) = (0, 0), the image's top left corner; v grows downwards.
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <vector>

namespace fillrule {

using Texel = std::array<float, 4>;  // r, g, b, a as stored: no conversion between colour spaces

struct TextureLevel {
  uint32_t width = 0;  // texels
  uint32_t height = 0;
  std::vector<Texel> texels;  // row by row from the top left
};

// How levels are chosen; Vulkan has no enumerator for "only the first one".
enum class Mipmaps : uint8_t { kNone, kNearest, kLinear };

struct Sampling2D {
  VkFilter filter = VK_FILTER_LINEAR;
  VkSamplerAddressMode wrap_u = VK_SAMPLER_ADDRESS_MODE_REPEAT;
  VkSamplerAddressMode wrap_v = VK_SAMPLER_ADDRESS_MODE_REPEAT;
  VkBorderColor border = VK_BORDER_COLOR_FLOAT_OPAQUE_BLACK;  // or white
  Mipmaps mipmaps = Mipmaps::kNone;
  bool operator==(const Sampling2D&) const = default;
};

struct Texture {
  // Level 0 first, each half of the one before, rounded down, to 1 x 1. Only the first without mipmaps.
  std::vector<TextureLevel> levels;
  Sampling2D sampling;
};

}  // namespace fillrule
