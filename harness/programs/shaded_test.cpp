#include "harness/programs/shaded.h"

#include <gmock/gmock.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace fillrule::programs {
namespace {

using ::testing::HasSubstr;

DrawShading lit_from(const glm::vec3& to_light) {
  DrawShading shading;
  shading.uniforms.lights = 1;
  shading.uniforms.to_light[0] = glm::vec4(glm::normalize(to_light), 0);
  shading.uniforms.light_color[0] = {1, 1, 1, 0};
  shading.uniforms.eye = {0, 0, 5, 1};
  return shading;
}

SurfacePoint facing_eye() {
  return {.position_world = {0, 0, 0}, .normal_world = {0, 0, 3}};
}

TEST(ShadedColor, IsTheMaterialsWithoutLight) {
  DrawShading shading;
  shading.uniforms.color = {0.25F, 0.5F, 2, 0};
  EXPECT_EQ(shaded_color(shading, facing_eye()), glm::vec3(0.25F, 0.5F, 1)) << "clamped";
}

TEST(ShadedColor, FollowsLambertsLaw) {
  EXPECT_NEAR(shaded_color(lit_from({0, 0, 1}), facing_eye()).r, 1, 1e-6);
  EXPECT_NEAR(shaded_color(lit_from({0, std::sqrt(3.0F), 1}), facing_eye()).r, 0.5, 1e-6);
  EXPECT_EQ(shaded_color(lit_from({0, 0, -1}), facing_eye()).r, 0) << "from behind";
}

TEST(ShadedColor, AddsAmbientLight) {
  DrawShading shading = lit_from({0, 0, -1});
  shading.uniforms.ambient = {0.1F, 0.2F, 0.3F, 0};
  shading.uniforms.color = {1, 0.5F, 1, 0};
  EXPECT_EQ(shaded_color(shading, facing_eye()), glm::vec3(0.1F, 0.1F, 0.3F));
}

TEST(ShadedColor, ReflectsTheLightToTheEye) {
  // The light at 30 degrees: its reflection is 30 degrees off the eye.
  DrawShading shading = lit_from({0, 0.5F, std::sqrt(0.75F)});
  shading.uniforms.color = {0, 0, 0, 0};
  shading.uniforms.specular = {1, 1, 1, 0};
  for (const int exponent : {1, 2, 7, 64}) {
    shading.uniforms.shininess = exponent;
    EXPECT_NEAR(shaded_color(shading, facing_eye()).g, std::pow(std::sqrt(0.75), exponent), 1e-5);
  }
  shading.uniforms.eye = {0, -0.5F, std::sqrt(0.75F), 0};  // the direction to it
  EXPECT_NEAR(shaded_color(shading, facing_eye()).g, 1, 1e-5);
}

TEST(ShadedColor, IsBlackWhereThereIsNoNormal) {
  EXPECT_EQ(shaded_color(lit_from({0, 0, 1}), {}), glm::vec3(0));
}

TEST(ShadedColor, ChoosesTheLevelByTheLargerStep) {
  DrawShading shading;
  Texture texture{.sampling = {.filter = VK_FILTER_NEAREST, .mipmaps = Mipmaps::kNearest}};
  for (const uint32_t size : {4U, 2U, 1U}) {
    const float value = static_cast<float>(size) / 4;
    texture.levels.push_back(
        {.width = size, .height = size, .texels = std::vector<Texel>(size_t{size} * size, {value, 0, 0, 1})});
  }
  shading.texture = std::make_shared<const Texture>(texture);
  shading.uniforms.textured = shading.uniforms.mipmapped = 1;
  shading.uniforms.texture_size = {4, 4, 2, 0};
  const auto red = [&](glm::vec2 step_x, glm::vec2 step_y) {
    return shaded_color(shading, {.uv_step_x = step_x, .uv_step_y = step_y}).r;
  };
  EXPECT_EQ(red({0.25F, 0}, {0, 0.25F}), 1) << "a texel a pixel";
  EXPECT_EQ(red({0.25F, 0}, {0, 0.5F}), 0.5F);
  EXPECT_EQ(red({-0.6F, 0.8F}, {0, 0.25F}), 0.25F);
  EXPECT_EQ(red({0, 0}, {0, 0}), 1);
  EXPECT_EQ(red({9, 0}, {0, 0}), 0.25F);
}

// A rectangle over the whole target of 8x8 pixels, with uv from 0 to 1 and normals to the eye.
Case whole_target() {
  Case one;
  one.target.width = one.target.height = 8;
  one.varyings = scene_varyings(false);
  Draw draw;
  draw.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  draw.state.viewport = {.width = 8, .height = 8, .maxDepth = 1};
  draw.state.scissor = {.extent = {8, 8}};
  for (const auto& [x, y] : {std::pair(-1.0F, -1.0F), {1.0F, -1.0F}, {-1.0F, 1.0F}, {1.0F, 1.0F}}) {
    draw.positions.push_back({x, y, 0.5F, 1});
    draw.varyings.insert(draw.varyings.end(), {x, y, 0, 0, 0, 1, (x + 1) / 2, (y + 1) / 2});
  }
  one.draws.push_back(std::move(draw));
  return one;
}

TEST(DrawShaded, WritesColoursAndEverythingElse) {
  DrawShading shading;
  shading.uniforms.textured = 1;
  shading.texture = std::make_shared<const Texture>(
      Texture{.levels = {{.width = 2, .height = 1, .texels = {{0.25F, 0.5F, 0.75F, 1}, {1, 0, 0, 1}}}},
              .sampling = {.filter = VK_FILTER_NEAREST}});
  const Result<Planes> planes = draw_shaded(whole_target(), {shading}, {});
  ASSERT_TRUE(planes) << to_string(planes.error());
  ASSERT_EQ(planes->varyings.size(), 4U);
  EXPECT_THAT(planes->hits, ::testing::Each(1U));
  EXPECT_EQ(planes->owner[0], 0U);
  EXPECT_EQ(planes->owner[63], 1U);
  EXPECT_EQ(planes->varyings[0][3], 0.25F);
  EXPECT_EQ(planes->varyings[2][3], 0.75F);
  EXPECT_EQ(planes->varyings[0][4], 1);
  EXPECT_EQ(planes->varyings[1][4], 0);
  EXPECT_THAT(planes->varyings[3], ::testing::Each(1.0F));
}

TEST(DrawShaded, TransformsInTheVertexStage) {
  Case one = whole_target();
  for (ClipPosition& position : one.draws[0].positions) position[2] = 0;
  DrawShading shading;
  shading.uniforms.transforms = 1;
  shading.uniforms.model = glm::mat4(0.5F);
  shading.uniforms.model[3] = {0.25F, 0, 0.5F, 1};
  const Result<Planes> planes = draw_shaded(one, {shading}, {});
  ASSERT_TRUE(planes) << to_string(planes.error());
  uint64_t covered = 0;
  for (const uint32_t hits : planes->hits) covered += hits;
  EXPECT_EQ(covered, 16U);
  EXPECT_EQ(planes->hits[2 * 8 + 3], 1U);
  EXPECT_EQ(planes->hits[2 * 8 + 2], 0U);
}

TEST(DrawShaded, RefusesWhatIsNoScene) {
  Case one = whole_target();
  EXPECT_THAT(to_string(draw_shaded(one, {}, {}).error()), HasSubstr("shading for 0 draws of 1"));
  one.varyings.pop_back();
  EXPECT_THAT(to_string(draw_shaded(one, {DrawShading{}}, {}).error()), HasSubstr("varyings of a scene"));
}

}  // namespace
}  // namespace fillrule::programs
