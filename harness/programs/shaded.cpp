#include "harness/programs/shaded.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "harness/programs/draw_draws.h"
#include "harness/programs/texture_sampler.h"

namespace fillrule::programs {
namespace {

glm::vec3 direction_of(const glm::vec3& vector) {
  const float squared = glm::dot(vector, vector);
  return squared > 0 ? vector / std::sqrt(squared) : glm::vec3(0);
}

float power(float base, int32_t exponent) {
  float result = 1;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 != 0) result *= base;
    base *= base;
  }
  return result;
}

glm::vec3 texel_at(const DrawShading& shading, const SurfacePoint& point) {
  const ShadingUniforms& uniforms = shading.uniforms;
  float level = 0;
  if (uniforms.mipmapped != 0) {
    const glm::vec2 size(uniforms.texture_size);
    const glm::vec2 step_x = point.uv_step_x * size;
    const glm::vec2 step_y = point.uv_step_y * size;
    const float squared = std::max(glm::dot(step_x, step_x), glm::dot(step_y, step_y));
    level = squared > 0 ? std::clamp(0.5F * std::log2(squared), 0.0F, uniforms.texture_size.z) : 0.0F;
  }
  const Texel texel = sample(*shading.texture, point.uv.x, point.uv.y, level);
  return {texel[0], texel[1], texel[2]};
}

// A highlight without colour adds nothing, and is most of the work.
bool shines(const ShadingUniforms& uniforms) {
  return uniforms.lights > 0 && glm::vec3(uniforms.specular) != glm::vec3(0);
}

glm::vec3 lit(const ShadingUniforms& uniforms, const glm::vec3& base, const SurfacePoint& point) {
  const glm::vec3 normal = direction_of(point.normal_world);
  const bool has_highlights = shines(uniforms);
  const glm::vec3 to_eye =
      has_highlights ? direction_of(glm::vec3(uniforms.eye) - point.position_world * uniforms.eye.w) : glm::vec3(0);
  glm::vec3 diffuse(uniforms.ambient);
  glm::vec3 specular(0);
  for (size_t i = 0; i < static_cast<size_t>(uniforms.lights); ++i) {
    const glm::vec3 to_light(uniforms.to_light[i]);
    const float cosine = glm::dot(normal, to_light);
    if (cosine <= 0) continue;
    const glm::vec3 color(uniforms.light_color[i]);
    diffuse += color * cosine;
    if (!has_highlights) continue;
    const glm::vec3 reflected = normal * (2 * cosine) - to_light;
    specular += color * power(std::max(glm::dot(reflected, to_eye), 0.0F), uniforms.shininess);
  }
  return base * diffuse + glm::vec3(uniforms.specular) * specular;
}

// At so many pixels from the fragment's centre, however far outside of the primitive that is: what a derivative is
// made from, where the renderer's own weights would stay inside.
renderer::PixelWeights extrapolated_weights(const renderer::Fragment& fragment, double x, double y) {
  const renderer::PrimitiveInterpolation& planes = fragment.interpolation;
  renderer::PixelWeights weights{};
  double reciprocal_w = 0;
  for (size_t i = 0; i < 3; ++i) {
    const double l = planes.per_w[i].at(fragment.x - planes.anchor_x + x, fragment.y - planes.anchor_y + y);
    reciprocal_w += l;
    weights.smooth[i] = l;
    weights.noperspective[i] = l * planes.w[i];
  }
  for (double& weight : weights.smooth) weight /= reciprocal_w;
  return weights;
}

// The draw with its vertex stage done.
Draw transformed(const Draw& draw, const ShadingUniforms& uniforms) {
  Draw result = draw;
  for (size_t i = 0; i < draw.positions.size(); ++i) {
    const size_t first = i * kSceneComponents;
    const TransformedVertex vertex = transformed_vertex(uniforms, draw.positions[i], &draw.varyings[first]);
    result.positions[i] = vertex.position_clip;
    std::copy(vertex.position_and_normal.begin(), vertex.position_and_normal.end(),
              result.varyings.begin() + static_cast<ptrdiff_t>(first));
  }
  return result;
}

}  // namespace

std::vector<Varying> scene_varyings(bool affine_texture) {
  return {{.name = "position_world", .components = 3},
          {.name = "normal_world", .components = 3},
          {.name = "uv",
           .components = 2,
           .interpolation = affine_texture ? Interpolation::kNoperspective : Interpolation::kSmooth}};
}

glm::vec3 shaded_color(const DrawShading& shading, const SurfacePoint& point) {
  const ShadingUniforms& uniforms = shading.uniforms;
  glm::vec3 color(uniforms.color);
  if (uniforms.textured != 0) color *= texel_at(shading, point);
  if (uniforms.lights >= 0) color = lit(uniforms, color, point);
  return glm::clamp(color, 0.0F, 1.0F);
}

TransformedVertex transformed_vertex(const ShadingUniforms& uniforms, const ClipPosition& position_object,
                                     const float* varyings) {
  const glm::vec4 position(position_object[0], position_object[1], position_object[2], position_object[3]);
  const glm::vec4 world = uniforms.model * position;
  const glm::vec4 clip = uniforms.projection * (uniforms.view * world);
  const float* const normal_object = varyings + kNormalComponent;
  const glm::vec3 normal =
      direction_of(glm::mat3(uniforms.normal) * glm::vec3(normal_object[0], normal_object[1], normal_object[2]));
  return {.position_clip = {clip.x, clip.y, clip.z, clip.w},
          .position_and_normal = {world.x, world.y, world.z, normal.x, normal.y, normal.z}};
}

ShadedSurface::ShadedSurface(const Case& drawn_case, const Draw& draw, const DrawShading& shading)
    : draw_(&draw),
      shading_(&shading),
      affine_texture_(drawn_case.varyings.back().interpolation == Interpolation::kNoperspective) {}

ShadedSurface::Corners ShadedSurface::corners(const renderer::ShadedPrimitive& primitive) const {
  Corners corners{};
  for (size_t i = 0; i < 3; ++i) {
    corners[i] = draw_->varyings.data() + size_t{primitive.vertices[i]} * kSceneComponents;
  }
  return corners;
}

glm::vec2 ShadedSurface::uv_with(const Corners& v, const renderer::PixelWeights& weights) const {
  const renderer::VertexWeights& chosen = affine_texture_ ? weights.noperspective : weights.smooth;
  const auto value = [&](uint32_t i) { return renderer::interpolate(v[0][i], v[1][i], v[2][i], chosen); };
  return {value(kUvComponent), value(kUvComponent + 1)};
}

SurfacePoint ShadedSurface::point_of(const Corners& v, const renderer::Fragment& fragment) const {
  const renderer::PixelWeights weights = fragment.weights();
  const auto value = [&](uint32_t i) { return renderer::interpolate(v[0][i], v[1][i], v[2][i], weights.smooth); };
  const auto vector = [&](uint32_t i) { return glm::vec3(value(i), value(i + 1), value(i + 2)); };
  SurfacePoint point;
  if (shines(shading_->uniforms)) point.position_world = vector(kPositionComponent);
  if (shading_->uniforms.lights >= 0) point.normal_world = vector(kNormalComponent);
  if (shading_->uniforms.textured == 0) return point;
  point.uv = uv_with(v, weights);
  if (shading_->uniforms.mipmapped == 0) return point;
  // The differences in the quad of pixels that begins at even coordinates ("Derivative Operations").
  const double to_other_x = fragment.x % 2 == 0 ? 1 : -1;
  const double to_other_y = fragment.y % 2 == 0 ? 1 : -1;
  const glm::vec2 other_x = uv_with(v, extrapolated_weights(fragment, to_other_x, 0));
  const glm::vec2 other_y = uv_with(v, extrapolated_weights(fragment, 0, to_other_y));
  point.uv_step_x = to_other_x > 0 ? other_x - point.uv : point.uv - other_x;
  point.uv_step_y = to_other_y > 0 ? other_y - point.uv : point.uv - other_y;
  return point;
}

glm::vec3 ShadedSurface::color(const Corners& corners, const renderer::Fragment& fragment) const {
  return shaded_color(*shading_, point_of(corners, fragment));
}

ShadedProgram::ShadedProgram(const Case& drawn_case, const Draw& draw, uint32_t first_primitive,
                             const DrawShading& shading, Planes& planes)
    : hits_({}, draw, first_primitive, planes),
      surface_(drawn_case, draw, shading),
      width_(planes.width),
      samples_(planes.samples) {
  for (size_t i = 0; i < color_.size(); ++i) color_[i] = planes.varyings[i].data();
}

ShadedProgram::PrimitiveData ShadedProgram::primitive_data(const renderer::ShadedPrimitive& primitive) const {
  PrimitiveData data = hits_.primitive_data(primitive);
  data.components = surface_.corners(primitive);
  return data;
}

void ShadedProgram::fragment(const PrimitiveData& data, const renderer::Fragment& fragment) const {
  hits_.fragment(data, fragment);
  const glm::vec3 color = surface_.color(data.components, fragment);
  const size_t pixel = static_cast<size_t>(fragment.y) * width_ + static_cast<size_t>(fragment.x);
  for (uint32_t rest = fragment.samples; rest != 0; rest &= rest - 1) {
    const size_t sample = pixel * samples_ + static_cast<size_t>(std::countr_zero(rest));
    color_[0][sample] = color.r;
    color_[1][sample] = color.g;
    color_[2][sample] = color.b;
    color_[3][sample] = 1;
  }
}

namespace {

uint32_t packed(const glm::vec3& color) {
  return static_cast<uint32_t>(renderer::packed_unorm8<renderer::ScalarLanes>({color.r, color.g, color.b, 1}));
}

// The colours alone, one sample a pixel.
struct PictureProgram {
  const Draw& draw;
  ShadedSurface surface;
  ColorTarget& target;

  using PrimitiveData = ShadedSurface::Corners;
  [[nodiscard]] ClipPosition position(uint32_t vertex) const { return draw.positions[vertex]; }
  [[nodiscard]] PrimitiveData primitive_data(const renderer::ShadedPrimitive& primitive) const {
    return surface.corners(primitive);
  }
  void fragment(const PrimitiveData& data, const renderer::Fragment& fragment) const {
    const size_t pixel = static_cast<size_t>(fragment.y) * target.width + static_cast<size_t>(fragment.x);
    target.rgba[pixel] = packed(surface.color(data, fragment));
  }
};

Result<void> check_scene_case(const Case& drawn_case, const CaseShading& shading) {
  if (drawn_case.varyings != scene_varyings(false) && drawn_case.varyings != scene_varyings(true)) {
    return failure("a case without the varyings of a scene", "add [scene] to the case");
  }
  if (shading.size() != drawn_case.draws.size()) {
    return failure(fmt::format("shading for {} draws of {}", shading.size(), drawn_case.draws.size()));
  }
  return {};
}

}  // namespace

Result<Planes> draw_shaded(const Case& drawn_case, const CaseShading& shading, const renderer::Options& options) {
  if (const auto checked = check_scene_case(drawn_case, shading); !checked) return tl::unexpected(checked.error());
  const bool transforms = std::any_of(shading.begin(), shading.end(),
                                      [](const DrawShading& one) { return one.uniforms.transforms != 0; });
  if (transforms) {
    Case with_vertices_done = drawn_case;
    CaseShading without = shading;
    for (size_t i = 0; i < shading.size(); ++i) {
      with_vertices_done.draws[i] = transformed(drawn_case.draws[i], shading[i].uniforms);
      without[i].uniforms.transforms = 0;
    }
    return draw_shaded(with_vertices_done, without, options);
  }
  return draw_draws(drawn_case, options,
                    [&](size_t draw, uint32_t first_primitive, Planes& planes) {
                      return ShadedProgram(drawn_case, drawn_case.draws[draw], first_primitive, shading[draw],
                                           planes);
                    })
      .map([](Planes planes) {
        planes.varyings.resize(4);
        return planes;
      });
}

Result<void> draw_colors(const Case& drawn_case, const CaseShading& shading, const glm::vec3& background,
                         const renderer::Options& options, ColorTarget& target) {
  if (auto checked = check_scene_case(drawn_case, shading); !checked) return checked;
  if (drawn_case.target.samples != VK_SAMPLE_COUNT_1_BIT) return failure("a picture of several samples a pixel");
  target.width = drawn_case.target.width;
  target.height = drawn_case.target.height;
  const size_t pixels = size_t{target.width} * target.height;
  target.rgba.assign(pixels, packed(background));
  const VkFormat format = drawn_case.target.depth_format;
  const bool has_depth = format != VK_FORMAT_UNDEFINED;
  target.depth.assign(has_depth ? pixels : 0,
                      renderer::quantized_depth(renderer::max_depth_code(format), drawn_case.target.clear_depth));
  for (size_t i = 0; i < drawn_case.draws.size(); ++i) {
    const Draw& draw = drawn_case.draws[i];
    const std::vector<ElementRun> runs = element_runs(draw);
    const PictureProgram program{draw, ShadedSurface(drawn_case, draw, shading[i]), target};
    const renderer::DrawInput input = draw_input(drawn_case, draw, runs, {target.depth, format});
    if (auto drawn = renderer::draw(input, program, options); !drawn) return drawn;
  }
  return {};
}

}  // namespace fillrule::programs
