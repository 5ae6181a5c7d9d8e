#include "harness/scene/color_bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "harness/scene/texel_bounds.h"

namespace fillrule::scene {
namespace {

// A vector of length 1, and by how much it may be off.
struct Direction {
  glm::dvec3 value{};
  double error = 2;
};

Direction direction_of(const glm::dvec3& vector, const glm::dvec3& error) {
  const double length = glm::length(vector);
  const double turned = glm::length(error);
  if (!(length > turned)) return {};
  constexpr double kRounding = 0x1p-21;
  return {.value = vector / length, .error = std::min(2 * turned / length + kRounding, 2.0)};
}

Interval power_of(const Interval& base, int32_t exponent) {
  return {std::pow(std::clamp(base.low, 0.0, 1.0), exponent), std::pow(std::clamp(base.high, 0.0, 1.0), exponent)};
}

// What the lights add up to: factors of the base colour, and what is added to it.
struct Light {
  std::array<Interval, 3> diffuse{};
  std::array<Interval, 3> specular{};
};

void add(std::array<Interval, 3>& sum, const glm::dvec3& color, const Interval& factor) {
  for (size_t c = 0; c < 3; ++c) {
    const auto channel = color[static_cast<glm::length_t>(c)];
    sum[c].low += std::min(channel * factor.low, channel * factor.high);
    sum[c].high += std::max(channel * factor.low, channel * factor.high);
  }
}

Light light_on(const programs::ShadingUniforms& uniforms, const SurfaceRange& range) {
  const Direction normal = direction_of(range.normal_world, range.normal_error);
  const bool highlights = has_highlights(uniforms);
  Direction to_eye;
  if (highlights) {
    to_eye = direction_of(glm::dvec3(uniforms.eye) - range.position_world * static_cast<double>(uniforms.eye.w),
                          range.position_error * static_cast<double>(uniforms.eye.w));
  }
  Light light;
  add(light.diffuse, glm::dvec3(uniforms.ambient), {1, 1});
  for (size_t i = 0; i < static_cast<size_t>(uniforms.lights); ++i) {
    const glm::dvec3 to_light(uniforms.to_light[i]);
    const glm::dvec3 color(uniforms.light_color[i]);
    const double cosine = glm::dot(normal.value, to_light);
    const Interval cosines{cosine - normal.error, cosine + normal.error};
    if (cosines.high <= 0) continue;
    add(light.diffuse, color, {std::max(cosines.low, 0.0), std::min(cosines.high, 1 + 0x1p-20)});
    if (!highlights) continue;
    const double reflected = 2 * cosine * glm::dot(normal.value, to_eye.value) - glm::dot(to_light, to_eye.value);
    const double error = 4 * normal.error + 3 * to_eye.error;
    Interval shine = power_of({reflected - error, reflected + error}, uniforms.shininess);
    if (cosines.low <= 0) shine.low = 0;
    add(light.specular, color, shine);
  }
  return light;
}

// The same where nothing is off.
struct ExactLight {
  glm::dvec3 diffuse{};
  glm::dvec3 specular{};
};

ExactLight exact_light_on(const programs::ShadingUniforms& uniforms, const SurfaceRange& range) {
  const bool highlights = has_highlights(uniforms);
  const glm::dvec3 normal = glm::normalize(range.normal_world);
  glm::dvec3 to_eye{};
  if (highlights) {
    to_eye = glm::normalize(glm::dvec3(uniforms.eye) - range.position_world * static_cast<double>(uniforms.eye.w));
  }
  ExactLight light{.diffuse = glm::dvec3(uniforms.ambient)};
  for (size_t i = 0; i < static_cast<size_t>(uniforms.lights); ++i) {
    const glm::dvec3 to_light(uniforms.to_light[i]);
    const glm::dvec3 color(uniforms.light_color[i]);
    const double cosine = glm::dot(normal, to_light);
    if (!(cosine > 0)) continue;
    light.diffuse += color * std::min(cosine, 1.0);
    if (!highlights) continue;
    const double reflected = 2 * cosine * glm::dot(normal, to_eye) - glm::dot(to_light, to_eye);
    light.specular += color * std::pow(std::clamp(reflected, 0.0, 1.0), uniforms.shininess);
  }
  return light;
}

}  // namespace

bool has_highlights(const programs::ShadingUniforms& uniforms) {
  return glm::vec3(uniforms.specular) != glm::vec3(0);
}

ColorBounds color_bounds(const programs::DrawShading& shading, const SurfaceRange& range,
                         const SamplerPrecision& precision) {
  const programs::ShadingUniforms& uniforms = shading.uniforms;
  ColorBounds bounds{Interval{1, 1}, Interval{1, 1}, Interval{1, 1}};
  if (uniforms.textured != 0) bounds = texel_bounds(*shading.texture, range, precision);
  Light light;
  if (uniforms.lights >= 0) light = light_on(uniforms, range);
  for (size_t c = 0; c < 3; ++c) {
    const auto channel = static_cast<glm::length_t>(c);
    const double material = uniforms.color[channel];
    const auto [low, high] = std::minmax({bounds[c].low * material, bounds[c].high * material});
    bounds[c] = {low, high};
    double rounding = kRounding;
    if (uniforms.lights >= 0) {
      const double shine = uniforms.specular[channel];
      const Interval factor = light.diffuse[c];
      const std::array corners{low * factor.low, low * factor.high, high * factor.low, high * factor.high};
      const auto [least, most] = std::minmax_element(corners.begin(), corners.end());
      bounds[c] = {*least + shine * light.specular[c].low, *most + shine * light.specular[c].high};
      rounding += std::abs(shine) * uniforms.shininess * 0x1p-22;
    }
    rounding *= std::max({1.0, std::abs(bounds[c].low), std::abs(bounds[c].high)});
    bounds[c] = {std::clamp(bounds[c].low, 0.0, 1.0) - rounding, std::clamp(bounds[c].high, 0.0, 1.0) + rounding};
  }
  return bounds;
}

std::array<double, 3> exact_color(const programs::DrawShading& shading, const SurfaceRange& range) {
  const programs::ShadingUniforms& uniforms = shading.uniforms;
  std::array<double, 3> color{1, 1, 1};
  if (uniforms.textured != 0) color = exact_texel(*shading.texture, range);
  ExactLight light;
  if (uniforms.lights >= 0) light = exact_light_on(uniforms, range);
  for (size_t c = 0; c < 3; ++c) {
    const auto channel = static_cast<glm::length_t>(c);
    color[c] *= static_cast<double>(uniforms.color[channel]);
    if (uniforms.lights >= 0) {
      color[c] = color[c] * light.diffuse[channel] +
                 static_cast<double>(uniforms.specular[channel]) * light.specular[channel];
    }
    color[c] = std::clamp(color[c], 0.0, 1.0);
  }
  return color;
}

}  // namespace fillrule::scene
