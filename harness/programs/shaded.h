// The program `shaded` for the renderer: textured and lit surfaces of a scene. Its twin for the reference is GLSL.
//
// Vulkan leaves no step of it open but rounding: positions come from the case, or from matrices applied in float32;
// texels are chosen by "Texel Filtering"; the light is Phong's model. The colours are not converted.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "harness/programs/shading.h"
#include "harness/programs/varyings.h"

namespace fillrule::programs {

// The colour of a fragment whose texture coordinates change by these steps, in uv, to the next pixel of its quad.
struct SurfacePoint {
  glm::vec3 position_world{};
  glm::vec3 normal_world{};
  glm::vec2 uv{};
  glm::vec2 uv_step_x{};
  glm::vec2 uv_step_y{};
};
glm::vec3 shaded_color(const DrawShading& shading, const SurfacePoint& point);

// What the vertex stage makes of a vertex with `transforms`.
struct TransformedVertex {
  ClipPosition position_clip{};
  std::array<float, 6> position_and_normal{};  // of the world
};
TransformedVertex transformed_vertex(const ShadingUniforms& uniforms, const ClipPosition& position_object,
                                     const float* varyings);

// The surface of a draw: the colour of its fragments.
class ShadedSurface {
 public:
  // `draw` is one with the varyings of scene_varyings(). Where the vertex stage transforms, it has been transformed
  // already.
  ShadedSurface(const Case& drawn_case, const Draw& draw, const DrawShading& shading);

  // The components of each vertex, the provoking one first.
  using Corners = std::array<const float*, 3>;
  [[nodiscard]] Corners corners(const renderer::ShadedPrimitive& primitive) const;
  [[nodiscard]] glm::vec3 color(const Corners& corners, const renderer::Fragment& fragment) const;

 private:
  [[nodiscard]] SurfacePoint point_of(const Corners& v, const renderer::Fragment& fragment) const;
  [[nodiscard]] glm::vec2 uv_with(const Corners& v, const renderer::PixelWeights& weights) const;

  const Draw* draw_;
  const DrawShading* shading_;
  bool affine_texture_;
};

// To planes, with everything that is judged; the first four components are the colour.
class ShadedProgram {
 public:
  ShadedProgram(const Case& drawn_case, const Draw& draw, uint32_t first_primitive, const DrawShading& shading,
                Planes& planes);

  using PrimitiveData = VaryingsProgram::PrimitiveData;
  [[nodiscard]] ClipPosition position(uint32_t vertex) const { return hits_.position(vertex); }
  [[nodiscard]] PrimitiveData primitive_data(const renderer::ShadedPrimitive& primitive) const;
  void fragment(const PrimitiveData& data, const renderer::Fragment& fragment) const;

 private:
  VaryingsProgram hits_;  // everything but the colour
  ShadedSurface surface_;
  size_t width_;
  size_t samples_;
  std::array<float*, 4> color_{};
};

// Draws a scene's case in colour: planes whose four varyings are r, g, b (0 to 1) and coverage (1).
Result<Planes> draw_shaded(const Case& drawn_case, const CaseShading& shading, const renderer::Options& options);

// The same colours and nothing else, for a picture that is looked at: R8G8B8A8_UNORM, red in the lowest byte, row by
// row from the top left. Kept from one picture to the next, as it costs as much to make as to draw.
struct ColorTarget {
  uint32_t width = 0;  // pixels
  uint32_t height = 0;
  std::vector<uint32_t> rgba;
  std::vector<float> depth;
};

// Draws a scene's case of one sample a pixel on the background, which is opaque. The vertex stage transforms nothing.
Result<void> draw_colors(const Case& drawn_case, const CaseShading& shading, const glm::vec3& background,
                         const renderer::Options& options, ColorTarget& target);

}  // namespace fillrule::programs
