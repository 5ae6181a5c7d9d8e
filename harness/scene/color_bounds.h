// The colours that a fragment of a scene may have: interval arithmetic over everything that its varyings may be.
//
// The varyings are exact values with the latitude that the oracle gives them. Every step of the shading is monotone,
// or continuous with a known slope, or a choice between texels, so that the bounds follow step by step:
//  - a texel coordinate u * size moves by the latitude of u times the size, by 2^-23 of itself in float32, and
//  bilinear
//    weights by 2^-subTexelPrecisionBits. A nearest filter may then give any texel that the range touches. A bilinear
//    one is bilinear between texel centres, so its extremes are at the range's ends and the centres within it.
//  - a level of detail is log2 of the larger of two steps between neighbouring pixels, whose latitude is that of both
//    ends; log2 errs by 2^-21, and the weight between levels by 2^-mipmapPrecisionBits. Within a level everything is
//    as above; between levels the colour is linear.
//  - a direction n / |n| turns by at most 2 |dn| / |n|. A cosine n . l moves by as much as n; the reflected vector's,
//    2 (n . l) (n . e) - l . e, by at most 4 dn + 3 de. Powers are monotone, lights add up, and where n . l may have
//    either sign the light may be missing.
//  - at last everything is rounded to float32 some 64 times, numbers of the colour's size: 2^-18 of it; a power errs
//  by
//    its exponent times as much as one product.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "harness/programs/shading.h"

namespace fillrule::scene {

struct Interval {
  double low = 0;
  double high = 0;
};
using ColorBounds = std::array<Interval, 3>;  // r, g, b

// Where a fragment is, with how far each component may be from it.
struct SurfaceRange {
  glm::dvec3 position_world{};
  glm::dvec3 position_error{};
  glm::dvec3 normal_world{};
  glm::dvec3 normal_error{};
  glm::dvec2 uv{};
  glm::dvec2 uv_error{};
  // To the next pixel of the quad to the right and down, in uv.
  std::array<glm::dvec2, 2> uv_step{};
  std::array<glm::dvec2, 2> uv_step_error{};
};

// What the specification lets a sampler be inexact by (VkPhysicalDeviceLimits).
struct SamplerPrecision {
  uint32_t sub_texel_bits = 8;
  uint32_t mipmap_bits = 4;
};

// Of the colour's size, what float32 rounds on the way to it: see above.
inline constexpr double kRounding = 0x1p-18;

// A highlight without colour adds nothing, and is most of the work. Asked here, not of the program that is judged.
bool has_highlights(const programs::ShadingUniforms& uniforms);

// Nothing is read of a range that the shading does not depend on: positions without highlights, normals without
// lights, uv without a texture.
ColorBounds color_bounds(const programs::DrawShading& shading, const SurfaceRange& range,
                         const SamplerPrecision& precision);

// The colour in the middle of the range, its errors left aside: much cheaper, and any that is within kLeastRounding
// of it in each channel is within color_bounds().
std::array<double, 3> exact_color(const programs::DrawShading& shading, const SurfaceRange& range);
// color_bounds() leaves at least kRounding on either side of whatever the range allows, the exact colour among it.
// Both functions round some fifty times in double, numbers of the colour's size: far less than 2^-20 of that.
inline constexpr double kLeastRounding = kRounding * (1 - 0x1p-20);

}  // namespace fillrule::scene
