#include "harness/programs/texture_sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fillrule::programs {
namespace {

// Four texels in a row, of the values 0 to 3.
Texture row(VkFilter filter, VkSamplerAddressMode wrap, Mipmaps mipmaps = Mipmaps::kNone) {
  TextureLevel level{.width = 4, .height = 1};
  for (int i = 0; i < 4; ++i) level.texels.push_back({static_cast<float>(i), 0, 0, 1});
  Texture texture{.levels = {level},
                  .sampling = {.filter = filter,
                               .wrap_u = wrap,
                               .wrap_v = wrap,
                               .border = VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE,
                               .mipmaps = mipmaps}};
  if (mipmaps != Mipmaps::kNone) {
    texture.levels.push_back({.width = 2, .height = 1, .texels = {{10, 0, 0, 1}, {11, 0, 0, 1}}});
    texture.levels.push_back({.width = 1, .height = 1, .texels = {{20, 0, 0, 1}}});
  }
  return texture;
}

// Red, at a coordinate in texels.
float red(const Texture& texture, double x, double level = 0) {
  return sample(texture, x / 4, 0.5, level)[0];
}

TEST(TextureSampler, TakesTheTexelThatTheCoordinateIsIn) {
  const Texture texture = row(VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_REPEAT);
  EXPECT_EQ(red(texture, 0), 0);
  EXPECT_EQ(red(texture, 0.99), 0);
  EXPECT_EQ(red(texture, 1), 1);
  EXPECT_EQ(red(texture, 3.5), 3);
}

TEST(TextureSampler, MixesBetweenTexelCentres) {
  const Texture texture = row(VK_FILTER_LINEAR, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
  EXPECT_EQ(red(texture, 0.5), 0);
  EXPECT_EQ(red(texture, 1), 0.5F);
  EXPECT_EQ(red(texture, 2.75), 2.25F);
  EXPECT_EQ(red(texture, 0.1), 0);
  EXPECT_EQ(red(texture, 3.9), 3);
}

TEST(TextureSampler, Wraps) {
  const auto at = [](VkSamplerAddressMode mode, double x) { return red(row(VK_FILTER_NEAREST, mode), x); };
  EXPECT_EQ(at(VK_SAMPLER_ADDRESS_MODE_REPEAT, -0.5), 3);
  EXPECT_EQ(at(VK_SAMPLER_ADDRESS_MODE_REPEAT, 9.5), 1);
  EXPECT_EQ(at(VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT, -0.5), 0);
  EXPECT_EQ(at(VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT, -1.5), 1);
  EXPECT_EQ(at(VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT, 4.5), 3);
  EXPECT_EQ(at(VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT, 7.5), 0);
  EXPECT_EQ(at(VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT, 8.5), 0);
  EXPECT_EQ(at(VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE, -7), 0);
  EXPECT_EQ(at(VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE, 70), 3);
  EXPECT_EQ(at(VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER, -0.5), 1);
  EXPECT_EQ(at(VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER, 0.5), 0);
  EXPECT_EQ(at(VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER, 4), 1);
}

TEST(TextureSampler, MixesAcrossTheSeam) {
  EXPECT_EQ(red(row(VK_FILTER_LINEAR, VK_SAMPLER_ADDRESS_MODE_REPEAT), 0), 1.5F);
  EXPECT_EQ(red(row(VK_FILTER_LINEAR, VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT), 0), 0);
  EXPECT_EQ(red(row(VK_FILTER_LINEAR, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER), 4), 2);
}

TEST(TextureSampler, ChoosesLevels) {
  const Texture nearest = row(VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_REPEAT, Mipmaps::kNearest);
  EXPECT_EQ(red(nearest, 0.5, 0.4), 0);
  EXPECT_EQ(red(nearest, 0.5, 0.5), 0);
  EXPECT_EQ(red(nearest, 0.5, 0.6), 10);
  EXPECT_EQ(red(nearest, 0.5, 9), 20);
  const Texture linear = row(VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_REPEAT, Mipmaps::kLinear);
  EXPECT_EQ(red(linear, 0.5, 0.25), 2.5F);
  EXPECT_EQ(red(linear, 0.5, 1.5), 15);
  EXPECT_EQ(red(linear, 0.5, 2), 20);
  EXPECT_EQ(red(row(VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_REPEAT), 0.5, 5), 0);
}

TEST(TextureSampler, SurvivesAnyCoordinate) {
  for (const VkFilter filter : {VK_FILTER_NEAREST, VK_FILTER_LINEAR}) {
    for (const auto wrap : {VK_SAMPLER_ADDRESS_MODE_REPEAT, VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT,
                            VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER}) {
      const Texture texture = row(filter, wrap);
      for (const double x : {1e30, -1e30, std::numeric_limits<double>::infinity(), std::nan("")}) {
        const float value = red(texture, x);
        EXPECT_TRUE(value >= 0 && value <= 3);
      }
    }
  }
}

}  // namespace
}  // namespace fillrule::programs
