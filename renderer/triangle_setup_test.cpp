#include "renderer/triangle_setup.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "renderer/edge_function.h"
#include "renderer/isa.h"
#include "renderer/prepared_draw.h"
#include "renderer/test_scene.h"

namespace fillrule::renderer::internal {
namespace {

constexpr uint32_t kTriangles = 64;

// Triangles of one draw, and what is asked of their setup.
struct Triangles {
  SetupState state;
  TinyCoverage tiny;
  std::array<std::array<FixedPosition, 3>, kTriangles> corners;
};

struct Found {
  bool is_visible = false;
  bool is_too_large = false;
  SetupPrimitive primitive;
};

std::vector<Found> set_up(const Triangles& triangles, Isa isa) {
  std::vector<Found> found(kTriangles);
  dispatch(
      isa, [&]<typename L>() __attribute__((always_inline)) {
        if constexpr (L::kWidth > 1) {
          TriangleLanes<L> lanes;
          for (uint32_t i = 0; i < kTriangles; ++i) {
            const auto& [a, b, c] = triangles.corners[i];
            lanes.put(i, a, b, c);
          }
          lanes.set_up(triangles.state, triangles.tiny, kTriangles);
          for (uint32_t i = 0; i < kTriangles; ++i) {
            found[i].is_visible = (lanes.visible() >> i & 1U) != 0;
            found[i].is_too_large = (lanes.too_large() >> i & 1U) != 0;
            lanes.get(i, found[i].primitive);
          }
        }
      });
  return found;
}

// By the edge functions themselves, as SetupPrimitive::covered_pixels() has them.
uint32_t covered_pixels(const Triangles& triangles, std::array<FixedPosition, 3> corners, const PixelRect& bounds) {
  if (doubled_area(corners[0], corners[1], corners[2]) < 0) {
    std::swap(corners[1], corners[2]);
  }
  uint32_t covered = 0;
  for (int32_t y = bounds.top; y < bounds.bottom; ++y) {
    for (int32_t x = bounds.left; x < bounds.right; ++x) {
      bool is_inside = true;
      for (size_t i = 0; i < 3; ++i) {
        const EdgeFunction edge = edge_function(corners[i], corners[(i + 1) % 3], triangles.tiny.sample_fixed,
                                                triangles.state.transform.subpixel_bits());
        is_inside = is_inside && edge.at(x, y) >= 0;
      }
      const int32_t bit = SetupPrimitive::kCoveredWidth * (y - bounds.top) + (x - bounds.left);
      covered |= (is_inside ? 1U : 0U) << static_cast<uint32_t>(bit);
    }
  }
  return covered;
}

// Against the setup of one triangle at a time.
void expect_right(const Triangles& triangles, const std::vector<Found>& found) {
  for (uint32_t i = 0; i < kTriangles; ++i) {
    const auto& corners = triangles.corners[i];
    SetupPrimitive expected{.vertices = corners};
    const bool is_visible = setup_whole_triangle(triangles.state, expected);
    if (found[i].is_too_large) {
      EXPECT_FALSE(found[i].is_visible) << i;
      continue;
    }
    const PixelRect bounds = expected.bounds();
    const bool is_small =
        bounds.width() <= SetupPrimitive::kCoveredWidth && bounds.height() <= SetupPrimitive::kCoveredHeight;
    const uint32_t pixels = is_visible && is_small ? covered_pixels(triangles, corners, bounds) : 0;
    const bool is_known_empty = triangles.tiny.is_wanted && is_small && pixels == 0;
    if (!found[i].is_visible) {
      EXPECT_TRUE(!is_visible || is_known_empty) << i;
      continue;
    }
    EXPECT_TRUE(is_visible) << i;
    EXPECT_EQ(found[i].primitive.front_facing, expected.front_facing) << i;
    EXPECT_EQ(found[i].primitive.bounds(), bounds) << i;
    if (found[i].primitive.covered_pixels() != 0) {
      EXPECT_TRUE(triangles.tiny.is_wanted && is_small) << i;
      EXPECT_EQ(found[i].primitive.covered_pixels(), pixels) << i;
    }
  }
}

Triangles random_triangles(SeededRandom& random) {
  const uint32_t bits = kMinSubpixelBits + random.bits() % (kMaxSubpixelBits - kMinSubpixelBits + 1);
  const FixedPosition sample = pixel_centre_fixed(bits);
  constexpr float kSize = 64;
  constexpr std::array<VkCullModeFlags, 4> kCullModes{VK_CULL_MODE_NONE, VK_CULL_MODE_FRONT_BIT,
                                                      VK_CULL_MODE_BACK_BIT, VK_CULL_MODE_FRONT_AND_BACK};
  Triangles triangles{
      .state = {.transform = WindowTransform({.width = kSize, .height = kSize, .maxDepth = 1}, bits),
                .cull_mode = kCullModes[random.bits() % 8 < 5 ? 0 : random.bits() % 4],
                .front_face = random.bits() % 2 == 0 ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE,
                .clip_pixels = {1, 2, 61, 63},
                .least_sample = sample,
                .greatest_sample = sample},
      .tiny = {.is_wanted = random.bits() % 8 != 0, .sample_fixed = sample}};
  // From less than a pixel to as far as coordinates go; on whole and half pixels often, so that edges meet samples.
  constexpr std::array<double, 6> kExtents{1.5, 3, 6, 40, 3000, 2000000};
  for (auto& corners : triangles.corners) {
    const double extent = kExtents[random.bits() % kExtents.size()];
    const double x = random.uniform(-2, kSize + 2);
    const double y = random.uniform(-2, kSize + 2);
    const bool is_coarse = random.bits() % 2 == 0;
    for (FixedPosition& corner : corners) {
      const auto coordinate = [&](double centre) {
        const int32_t fixed = snap(centre + random.uniform(-extent, extent), bits);
        const int32_t half = 1 << (bits - 1);
        return is_coarse ? fixed / half * half : fixed;
      };
      corner = {coordinate(x), coordinate(y)};
    }
  }
  return triangles;
}

TEST(TriangleSetup, ByLanesIsThatOfOneAtATime) {
  SeededRandom random;
  uint32_t tiny = 0;
  uint32_t dropped = 0;
  uint32_t too_large = 0;
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa) || isa == Isa::kScalar) continue;
    for (int round = 0; round < 2000; ++round) {
      const Triangles triangles = random_triangles(random);
      const std::vector<Found> found = set_up(triangles, isa);
      expect_right(triangles, found);
      for (const Found& one : found) {
        tiny += one.is_visible && one.primitive.covered_pixels() != 0 ? 1 : 0;
        dropped += one.is_visible ? 0 : 1;
        too_large += one.is_too_large ? 1 : 0;
      }
      ASSERT_FALSE(::testing::Test::HasFailure()) << to_string(isa) << ", round " << round;
    }
  }
  EXPECT_GT(tiny, 1000U);
  EXPECT_GT(dropped, 1000U);
  EXPECT_GT(too_large, 1000U);
}

// Of triangles that are tiny nothing is left to the tiles.
TEST(TriangleSetup, KnowsThePixelsOfEveryTinyTriangle) {
  Triangles triangles{.state = {.transform = WindowTransform({.width = 64, .height = 64, .maxDepth = 1}, 8),
                                .cull_mode = VK_CULL_MODE_NONE,
                                .front_face = VK_FRONT_FACE_CLOCKWISE,
                                .clip_pixels = {0, 0, 64, 64},
                                .least_sample = pixel_centre_fixed(8),
                                .greatest_sample = pixel_centre_fixed(8)},
                      .tiny = {.is_wanted = true, .sample_fixed = pixel_centre_fixed(8)}};
  // The lower left half of 8x4 pixels, and one between four centres.
  triangles.corners.fill({{{8 << 8, 4 << 8}, {16 << 8, 8 << 8}, {8 << 8, 8 << 8}}});
  triangles.corners[7] = {{{(8 << 8) + 150, (4 << 8) + 150}, {(9 << 8) + 100, (4 << 8) + 150}, {9 << 8, 5 << 8}}};
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa) || isa == Isa::kScalar) continue;
    const std::vector<Found> found = set_up(triangles, isa);
    EXPECT_TRUE(found[0].is_visible);
    EXPECT_EQ(found[0].primitive.covered_pixels(), 0x7F'1F'07'01U) << std::hex << found[0].primitive.covered_pixels();
    EXPECT_FALSE(found[7].is_visible);
  }
}

}  // namespace
}  // namespace fillrule::renderer::internal
