#include "harness/scene/transform_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace fillrule::scene {
namespace {

constexpr double kUnit = 0x1p-24;
constexpr double kProduct = 5 * kUnit;

glm::dmat4 magnitudes(const glm::mat4& matrix) {
  glm::dmat4 result;
  for (int column = 0; column < 4; ++column) result[column] = glm::abs(glm::dvec4(matrix[column]));
  return result;
}

// In pixels, of x and y.
double window_error(const glm::dvec4& clip, const glm::dvec4& error, const VkViewport& viewport) {
  if (!(clip.w > 2 * error.w)) return INFINITY;
  const auto along = [&](double coordinate, double its_error, double extent) {
    return std::abs(extent) / 2 * (its_error + std::abs(coordinate / clip.w) * error.w) / (clip.w - error.w);
  };
  return std::max(along(clip.x, error.x, viewport.width), along(clip.y, error.y, viewport.height));
}

}  // namespace

Result<TransformError> transform_error(const Case& object, const programs::CaseShading& shading,
                                       uint32_t subpixel_bits) {
  TransformError worst;
  const double allowed = std::exp2(-static_cast<double>(subpixel_bits) - 1);
  for (size_t i = 0; i < object.draws.size(); ++i) {
    const programs::ShadingUniforms& uniforms = shading[i].uniforms;
    const glm::dmat4 model = magnitudes(uniforms.model);
    const glm::dmat4 to_clip = magnitudes(uniforms.projection) * magnitudes(uniforms.view);
    const glm::dmat3 normal_magnitudes(magnitudes(uniforms.normal));
    const Draw& draw = object.draws[i];
    for (size_t vertex = 0; vertex < draw.positions.size(); ++vertex) {
      const auto& [x, y, z, w] = draw.positions[vertex];
      const glm::dvec4 position(x, y, z, w);
      const glm::dvec4 world = model * glm::abs(position);
      const glm::dvec4 clip =
          glm::dmat4(uniforms.projection) * glm::dmat4(uniforms.view) * glm::dmat4(uniforms.model) * position;
      const double moved = window_error(clip, 16 * kUnit * (to_clip * world), draw.state.viewport);
      if (!(moved <= allowed)) {
        return failure(fmt::format("a vertex at w = {} may be off by {} pixels where the vertex stage transforms",
                                   clip.w, moved),
                       fmt::format("transform_on = \"both\" can be judged up to {} pixels", allowed));
      }
      worst.position_world = std::max(worst.position_world, kProduct * glm::length(glm::dvec3(world)));
      const float* const values = &draw.varyings[vertex * programs::kSceneComponents + programs::kNormalComponent];
      const glm::dvec3 normal(values[0], values[1], values[2]);
      const double length = glm::length(glm::dmat3(uniforms.normal) * normal);
      if (length > 0) {
        const double turned = 2 * kProduct * glm::length(normal_magnitudes * glm::abs(normal)) / length;
        worst.normal_world = std::max(worst.normal_world, turned + 8 * kUnit);
      }
    }
  }
  return worst;
}

}  // namespace fillrule::scene
