// The bounds hold what the shading gives anywhere within the range, and not much more.
#include "harness/scene/color_bounds.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <map>
#include <random>

#include "harness/mesh/texture.h"
#include "harness/programs/shaded.h"

namespace fillrule::scene {
namespace {

class Random {
 public:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  glm::dvec3 vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

 private:
  std::mt19937 engine_{5};
};

programs::DrawShading random_shading(Random& random, bool textured) {
  programs::DrawShading shading;
  programs::ShadingUniforms& uniforms = shading.uniforms;
  uniforms.color = {random.between(0, 1), random.between(0, 1), 1, 0};
  uniforms.ambient = {0.1, 0.2, 0.05, 0};
  uniforms.specular = {0.5, 0.2, 0.9, 0};
  uniforms.shininess = static_cast<int32_t>(random.between(1, 200));
  uniforms.eye = glm::vec4(random.vector(5), 1);
  uniforms.lights = 2;
  for (size_t i = 0; i < 2; ++i) {
    uniforms.to_light[i] = glm::vec4(glm::normalize(random.vector(1)), 0);
    uniforms.light_color[i] = {0.7, 0.3, 0.5, 0};
  }
  if (!textured) return shading;
  const std::array filters{VK_FILTER_NEAREST, VK_FILTER_LINEAR};
  const std::array wraps{VK_SAMPLER_ADDRESS_MODE_REPEAT, VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT,
                         VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER};
  const std::array mipmaps{Mipmaps::kNone, Mipmaps::kNearest, Mipmaps::kLinear};
  Texture texture{.sampling = {.filter = filters[static_cast<size_t>(random.between(0, 2))],
                               .wrap_u = wraps[static_cast<size_t>(random.between(0, 4))],
                               .wrap_v = wraps[static_cast<size_t>(random.between(0, 4))],
                               .mipmaps = mipmaps[static_cast<size_t>(random.between(0, 3))]}};
  TextureLevel level{.width = 13, .height = 7};
  for (int i = 0; i < 13 * 7; ++i) {
    level.texels.push_back(
        {static_cast<float>(random.between(0, 1)), static_cast<float>(random.between(0, 1)), 0, 1});
  }
  texture.levels.push_back(level);
  while (texture.sampling.mipmaps != Mipmaps::kNone && texture.levels.back().width > 1) {
    texture.levels.push_back(mesh::half_of(texture.levels.back()));
  }
  uniforms.textured = 1;
  uniforms.mipmapped = texture.sampling.mipmaps == Mipmaps::kNone ? 0 : 1;
  uniforms.texture_size = {13, 7, texture.levels.size() - 1, 0};
  shading.texture = std::make_shared<const Texture>(std::move(texture));
  return shading;
}

SurfaceRange random_range(Random& random, double error) {
  SurfaceRange range{.position_world = random.vector(3),
                     .position_error = glm::dvec3(error),
                     .normal_world = random.vector(1),
                     .normal_error = glm::dvec3(error),
                     .uv = {random.between(-2, 2), random.between(-2, 2)},
                     .uv_error = glm::dvec2(error)};
  for (size_t axis = 0; axis < 2; ++axis) {
    range.uv_step[axis] = {random.between(-0.5, 0.5), random.between(-0.5, 0.5)};
    range.uv_step_error[axis] = glm::dvec2(error);
  }
  return range;
}

// Somewhere in the range, its ends before all.
programs::SurfacePoint point_in(const SurfaceRange& range, Random& random) {
  const auto moved = [&](double value, double error) {
    return static_cast<float>(value + error * std::clamp(random.between(-1.5, 1.5), -1.0, 1.0));
  };
  programs::SurfacePoint point;
  for (int i = 0; i < 3; ++i) {
    point.position_world[i] = moved(range.position_world[i], range.position_error[i]);
    point.normal_world[i] = moved(range.normal_world[i], range.normal_error[i]);
  }
  for (int i = 0; i < 2; ++i) {
    point.uv[i] = moved(range.uv[i], range.uv_error[i]);
    point.uv_step_x[i] = moved(range.uv_step[0][i], range.uv_step_error[0][i]);
    point.uv_step_y[i] = moved(range.uv_step[1][i], range.uv_step_error[1][i]);
  }
  return point;
}

TEST(ColorBounds, HoldWhateverTheRangeAllows) {
  Random random;
  for (int round = 0; round < 3000; ++round) {
    const programs::DrawShading shading = random_shading(random, round % 3 != 0);
    const SurfaceRange range = random_range(random, std::exp2(random.between(-24, -3)));
    const ColorBounds bounds = color_bounds(shading, range, {});
    for (int i = 0; i < 20; ++i) {
      const glm::vec3 color = programs::shaded_color(shading, point_in(range, random));
      for (int c = 0; c < 3; ++c) {
        EXPECT_GE(color[c], bounds[static_cast<size_t>(c)].low) << round;
        EXPECT_LE(color[c], bounds[static_cast<size_t>(c)].high) << round;
      }
    }
  }
}

TEST(ColorBounds, OfPartOfARangeAreWithinThoseOfAllOfIt) {
  Random random;
  for (int round = 0; round < 3000; ++round) {
    const programs::DrawShading shading = random_shading(random, round % 3 != 0);
    const SurfaceRange all = random_range(random, std::exp2(random.between(-24, -3)));
    SurfaceRange part = all;
    const double share = random.between(0, 1);
    part.position_error *= share;
    part.normal_error *= share;
    part.uv_error *= share;
    for (glm::dvec2& error : part.uv_step_error) error *= share;
    const ColorBounds wide = color_bounds(shading, all, {});
    const ColorBounds narrow = color_bounds(shading, part, {});
    constexpr double kRounding = 0x1p-40;  // of the bounds themselves, which leave 2^-18 for what the colours round
    for (size_t c = 0; c < wide.size(); ++c) {
      EXPECT_GE(narrow[c].low, wide[c].low - kRounding) << round;
      EXPECT_LE(narrow[c].high, wide[c].high + kRounding) << round;
    }
  }
}

TEST(ColorBounds, HoldWhatIsCloseToTheExactColor) {
  Random random;
  std::map<Mipmaps, int> asked;
  for (int round = 0; round < 3000; ++round) {
    const programs::DrawShading shading = random_shading(random, round % 3 != 0);
    if (shading.uniforms.textured != 0) ++asked[shading.texture->sampling.mipmaps];
    const SurfaceRange range = random_range(random, round % 2 == 0 ? 0 : std::exp2(random.between(-24, -3)));
    const ColorBounds bounds = color_bounds(shading, range, {});
    const std::array<double, 3> exact = exact_color(shading, range);
    for (size_t c = 0; c < exact.size(); ++c) {
      EXPECT_GE(exact[c] - kLeastRounding, bounds[c].low) << round;
      EXPECT_LE(exact[c] + kLeastRounding, bounds[c].high) << round;
    }
  }
  for (const Mipmaps mipmaps : {Mipmaps::kNone, Mipmaps::kNearest, Mipmaps::kLinear}) EXPECT_GT(asked[mipmaps], 100);
}

TEST(ColorBounds, AreNarrowWhereTheRangeIs) {
  Random random;
  double sum = 0;
  constexpr int kRounds = 300;
  for (int round = 0; round < kRounds; ++round) {
    const programs::DrawShading shading = random_shading(random, false);
    const ColorBounds bounds = color_bounds(shading, random_range(random, 1e-7), {});
    for (const Interval& channel : bounds) sum += channel.high - channel.low;
  }
  EXPECT_LT(sum / (3 * kRounds), 1.0 / 255);
}

TEST(ColorBounds, LetANearestFilterTakeEitherTexelAtTheBorder) {
  programs::DrawShading shading;
  shading.uniforms.textured = 1;
  shading.texture = std::make_shared<const Texture>(
      Texture{.levels = {{.width = 2, .height = 1, .texels = {{0.25F, 0, 0, 1}, {0.75F, 0, 0, 1}}}},
              .sampling = {.filter = VK_FILTER_NEAREST}});
  const ColorBounds at_border = color_bounds(shading, {.uv = {0.5, 0.5}, .uv_error = {1e-7, 1e-7}}, {});
  EXPECT_NEAR(at_border[0].low, 0.25, 1e-4);
  EXPECT_NEAR(at_border[0].high, 0.75, 1e-4);
  const ColorBounds beside = color_bounds(shading, {.uv = {0.49, 0.5}, .uv_error = {1e-7, 1e-7}}, {});
  EXPECT_NEAR(beside[0].high, 0.25, 1e-4);
}

}  // namespace
}  // namespace fillrule::scene
