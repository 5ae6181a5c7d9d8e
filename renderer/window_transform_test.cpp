#include "renderer/window_transform.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "renderer/isa.h"

namespace fillrule::renderer {
namespace {

constexpr VkViewport kViewport{.x = 0, .y = 0, .width = 200, .height = 100, .minDepth = 0, .maxDepth = 1};

TEST(WindowTransform, MapsTheClipVolumeOntoTheViewport) {
  const WindowTransform transform(kViewport, 8);
  EXPECT_EQ(transform.window_vertex({-1, -1, 0, 1}).position, (FixedPosition{0, 0}));
  EXPECT_EQ(transform.window_vertex({2, 2, 0, 2}).position, (FixedPosition{200 * 256, 100 * 256}));
  EXPECT_EQ(transform.window_vertex({0, 0, 0, 3}).position, (FixedPosition{100 * 256, 50 * 256}));
}

TEST(WindowTransform, UsesTheFloatArithmeticOfLavapipeInsideTheClipVolume) {
  const WindowTransform transform({.x = 3, .y = 5, .width = 201, .height = 77, .minDepth = 0, .maxDepth = 1}, 8);
  size_t different_in_double = 0;
  for (int i = -1000; i <= 1000; ++i) {
    const float x = static_cast<float>(i) / 1001.0F;
    const float w = 1.0F + std::abs(x);
    const float expected = std::fma(x * (1.0F / w), 100.5F, 103.5F);
    const FixedPosition position = transform.window_vertex({x, 0, 0, w}).position;
    EXPECT_EQ(position.x_fixed, static_cast<int32_t>(std::lrint(expected * 256)));
    different_in_double += position != transform.project({x, 0, 0, w}) ? 1U : 0U;
  }
  EXPECT_LT(different_in_double, 20U);
}

TEST(WindowTransform, TellsWhichPlanesAVertexIsOutsideOf) {
  const WindowTransform transform(kViewport, 8);
  const auto code = [&](const ClipPosition& pos_clip) {
    return uint32_t{transform.window_vertex(pos_clip).clip_code};
  };
  EXPECT_EQ(code({0, 0, 0.5F, 1}), 0U);
  EXPECT_EQ(code({5, -5, 0.5F, 1}), 0U);  // outside of the viewport, inside of the guard band
  EXPECT_EQ(code({0, 0, -0.1F, 1}), 1U << 0);
  EXPECT_EQ(code({0, 0, 1.1F, 1}), 1U << 1);
  EXPECT_EQ(code({-1e6F, 0, 0.5F, 1}), 1U << 2);
  EXPECT_EQ(code({1e6F, 0, 0.5F, 1}), 1U << 3);
  EXPECT_EQ(code({0, -1e6F, 0.5F, 1}), 1U << 4);
  EXPECT_EQ(code({0, 1e6F, 0.5F, 1}), 1U << 5);
  EXPECT_EQ(code({0, 0, 0, 0}), uint32_t{kClipAtOrigin});
  EXPECT_EQ(code({0, 0, 0, std::numeric_limits<float>::quiet_NaN()}), uint32_t{kClipNotFinite});
  EXPECT_EQ(code({std::numeric_limits<float>::infinity(), 0, 0, 1}), uint32_t{kClipNotFinite});
}

TEST(WindowTransform, ProjectsVerticesWhoseReciprocalWIsNoFloat) {
  const WindowTransform transform(kViewport, 8);
  const float denormal = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(transform.window_vertex({0, denormal, denormal, denormal}).position, (FixedPosition{25600, 25600}));
  const float huge = std::numeric_limits<float>::max();
  EXPECT_EQ(transform.window_vertex({huge / 2, huge, huge, huge}).position, (FixedPosition{150 * 256, 25600}));
}

TEST(WindowTransform, ViewportPixelsHaveTheirCentresInside) {
  const auto pixels = [](const VkViewport& viewport) {
    return WindowTransform(viewport, 8).viewport_pixels(pixel_centre_fixed(8));
  };
  EXPECT_EQ(pixels(kViewport), (PixelRect{0, 0, 200, 100}));
  // The left and the top border on a pixel's centre take it in, the right and the bottom leave it out.
  EXPECT_EQ(pixels({.x = 1.5F, .y = 2.5F, .width = 10, .height = 20}), (PixelRect{1, 2, 11, 22}));
  EXPECT_EQ(pixels({.x = 1.75F, .y = 2.25F, .width = 10, .height = 20}), (PixelRect{2, 2, 12, 22}));
  EXPECT_EQ(pixels({.x = 5, .y = 30, .width = 10, .height = -20}), (PixelRect{5, 10, 15, 30}));
  EXPECT_EQ(pixels({.x = -7, .y = -9, .width = 10, .height = 20}), (PixelRect{-7, -9, 3, 11}));
}

// Usual vertices beside all others, in every lane.
TEST(WindowTransform, GivesSeveralVerticesWhatItGivesEach) {
  constexpr uint32_t kSeed = 20;
  constexpr size_t kVertices = 4096;
  SCOPED_TRACE(kSeed);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr std::array kSpecial{0.0F,     -0.0F,     1.0F,       -1.0F, 0x1p-126F, 0x1p-127F, 0x1p126F,
                                0x1p127F, kInfinity, -kInfinity, 1e30F, 3e38F,     -2.0F,     kNan};
  std::mt19937 random(kSeed);
  const auto coordinate = [&](float least) {
    return random() % 16 == 0 ? kSpecial[random() % kSpecial.size()]
                              : std::uniform_real_distribution<float>(least, 1.2F)(random);
  };
  std::vector<ClipPosition> positions(kVertices);
  for (ClipPosition& position : positions) {
    position = {coordinate(-1.2F), coordinate(-1.2F), coordinate(-0.2F), coordinate(0.8F)};
  }
  for (const VkViewport& viewport : {kViewport, VkViewport{3.5F, 77, 201, -77, 0, 1}}) {
    for (const DepthVolume& volume : {DepthVolume{}, DepthVolume{.clips = false}, DepthVolume{true, true}}) {
      for (const uint32_t subpixel_bits : {4U, 8U}) {
        const WindowTransform transform(viewport, subpixel_bits, volume);
        for (const Isa isa : kAllIsas) {
          if (!is_supported(isa)) continue;
          std::vector<WindowVertex> vertices(kVertices);
          dispatch(
              isa, [&]<typename L>() __attribute__((always_inline)) {
                for (size_t i = 0; i < kVertices; i += L::kWidth) {
                  transform.window_vertices<L>(&positions[i], &vertices[i]);
                }
              });
          for (size_t i = 0; i < kVertices; ++i) {
            const WindowVertex expected = transform.window_vertex(positions[i]);
            ASSERT_EQ(vertices[i].position, expected.position) << to_string(isa) << ", vertex " << i;
            ASSERT_EQ(vertices[i].clip_code, expected.clip_code) << to_string(isa) << ", vertex " << i;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace fillrule::renderer
