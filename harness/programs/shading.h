// What the program `shaded` reads beside its vertices: one of these for each draw, laid out as the uniform block of
// shaded.frag has it (std140).
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/scene.h"
#include "cases/model/texture.h"

namespace fillrule::programs {

// Vectors are of the world; directions have length 1.
struct ShadingUniforms {
  // Applied in the vertex stage if `transforms` says so, else positions are final and normals of the world already.
  glm::mat4 model{1};
  glm::mat4 view{1};
  glm::mat4 projection{1};
  glm::mat4 normal{1};
  glm::vec4 eye{0, 0, 0, 1};  // w = 0: the direction to it, of an orthographic projection
  glm::vec4 color{1};         // of the material; rgb
  glm::vec4 specular{0};      // rgb
  glm::vec4 ambient{0};       // rgb
  std::array<glm::vec4, kMaxLights> to_light{};
  std::array<glm::vec4, kMaxLights> light_color{};
  glm::vec4 texture_size{1, 1, 0, 0};  // texels of level 0; z: the last level
  int32_t lights = -1;                 // -1: colours as they are
  int32_t shininess = 1;
  int32_t textured = 0;
  int32_t mipmapped = 0;
  int32_t transforms = 0;
  std::array<int32_t, 3> padding{};
};
static_assert(sizeof(ShadingUniforms) == 496);

// VARIANT of shaded.frag and shaded.vert: 1 for a texture, 2 for light, 4 for matrices to apply, added up.
constexpr uint32_t shaded_variant(const ShadingUniforms& uniforms) {
  return (uniforms.textured != 0 ? 1 : 0) + (uniforms.lights >= 0 ? 2 : 0) + (uniforms.transforms != 0 ? 4 : 0);
}

struct DrawShading {
  ShadingUniforms uniforms;
  std::shared_ptr<const Texture> texture;  // null: none
};

// For each draw of a case.
using CaseShading = std::vector<DrawShading>;

// The varyings of a scene's case, in this order: position_world (3), normal_world (3), uv (2), the last one smooth or
// noperspective. Packed by kind they fill vec4 slots as shaded.frag reads them.
inline constexpr uint32_t kPositionComponent = 0;
inline constexpr uint32_t kNormalComponent = 3;
inline constexpr uint32_t kUvComponent = 6;
inline constexpr uint32_t kSceneComponents = 8;
std::vector<Varying> scene_varyings(bool affine_texture);

}  // namespace fillrule::programs
