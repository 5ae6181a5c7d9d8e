#include <gtest/gtest.h>

#include "renderer/edge_function.h"
#include "renderer/sample_locations.h"
#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

constexpr std::array<uint32_t, 5> kSampleCounts{1, 2, 4, 8, 16};

TEST(SampleLocations, AreTheStandardOnes) {
  const auto centre = standard_sample_locations(1)[0].from_centre();
  EXPECT_EQ(centre.x, 0);
  EXPECT_EQ(centre.y, 0);
  // Of 4 samples: (0.375, 0.125), (0.875, 0.375), (0.125, 0.625), (0.625, 0.875).
  const auto four = standard_sample_locations(4);
  EXPECT_EQ(four[0].fixed(8), (FixedPosition{96, 32}));
  EXPECT_EQ(four[1].fixed(8), (FixedPosition{224, 96}));
  EXPECT_EQ(four[2].fixed(4), (FixedPosition{2, 10}));
  EXPECT_EQ(four[3].from_centre().x, 0.125);
  EXPECT_EQ(four[3].from_centre().y, 0.375);
  EXPECT_TRUE(standard_sample_locations(3).empty());
  EXPECT_TRUE(standard_sample_locations(32).empty());
}

// From 2 samples on, no two samples of a pixel share a column or a row: the pattern is a Latin square.
TEST(SampleLocations, ShareNoColumnAndNoRow) {
  for (const uint32_t samples : kSampleCounts) {
    const auto locations = standard_sample_locations(samples);
    ASSERT_EQ(locations.size(), samples);
    uint32_t columns = 0;
    uint32_t rows = 0;
    for (const SampleLocation& location : locations) {
      columns |= 1U << location.x_16;
      rows |= 1U << location.y_16;
    }
    EXPECT_EQ(std::popcount(columns), static_cast<int>(samples));
    EXPECT_EQ(std::popcount(rows), static_cast<int>(samples));
  }
}

// One sample of n is the single sample of the scene moved so that it comes to the pixels' centres. Coordinates are
// multiples of 1/16 px, so that nothing rounds.
TEST(Samples, EachIsTheSingleSampleOfTheSceneMoved) {
  SeededRandom random;
  for (const uint32_t samples : kSampleCounts) {
    TestScene scene(128, 128);
    scene.samples = samples;
    TestScene single = scene;
    single.samples = 1;
    std::vector<std::array<double, 2>> points;
    for (int i = 0; i < 60; ++i) {
      const double size = i % 10 == 0 ? 400 : 30;
      const auto coordinate = [&] { return std::floor(random.uniform(-size, 128 + size) * 16) / 16; };
      points.push_back({coordinate(), coordinate()});
      scene.positions.push_back(scene.at(points.back()[0], points.back()[1]));
    }
    const TestPlanes planes = render(scene);
    for (uint32_t sample = 0; sample < samples; ++sample) {
      const WindowOffset offset = standard_sample_locations(samples)[sample].from_centre();
      single.positions.clear();
      for (const auto& [x, y] : points) {
        single.positions.push_back(single.at(x - offset.x, y - offset.y));
      }
      const TestPlanes expected = render(single);
      // The viewport does not move along: its first and last pixels are left out.
      for (uint32_t y = 1; y < 127; ++y) {
        for (uint32_t x = 1; x < 127; ++x) {
          const size_t i = planes.pixel(x, y, sample);
          ASSERT_EQ(planes.hits[i], expected.hits[expected.pixel(x, y)]) << samples << ": " << x << ", " << y;
          ASSERT_EQ(planes.owner[i], expected.owner[expected.pixel(x, y)]);
        }
      }
    }
  }
}

TEST(Samples, SameBytesForAnyNumberOfThreads) {
  SeededRandom random;
  TestScene scene(200, 150);
  scene.samples = 8;
  scene.state.depth_test = true;
  for (int i = 0; i < 3000; ++i) {
    scene.positions.push_back(
        scene.at(random.uniform(-20, 220), random.uniform(-20, 170), random.uniform(-0.1, 1.1), 1));
    scene.values.push_back(static_cast<float>(random.uniform(0, 1)));
  }
  const TestPlanes expected = render(scene, {.threads = 1});
  EXPECT_TRUE(same_bytes(render(scene, {.threads = 3}), expected));
}

// A mesh covers each sample once.
TEST(Samples, AMeshIsWatertightAtEverySample) {
  SeededRandom random;
  for (const uint32_t samples : kSampleCounts) {
    TestScene scene(64, 64);
    scene.samples = samples;
    const ClipPosition centre = scene.at(random.uniform(20, 40), random.uniform(20, 40));
    const std::array<ClipPosition, 4> corners{scene.at(-1, -1), scene.at(65, -1), scene.at(65, 65), scene.at(-1, 65)};
    for (size_t i = 0; i < 4; ++i) {
      for (const ClipPosition& position : {corners[i], corners[(i + 1) % 4], centre}) {
        scene.positions.push_back(position);
      }
    }
    EXPECT_EQ(count_of(render(scene).hits, 1), size_t{64} * 64 * samples);
  }
}

TEST(Samples, ABorderOfTheViewportRunsBetweenThem) {
  TestScene scene(16, 16);
  scene.samples = 4;
  scene.state.viewport = {2.5F, 3.25F, 8, 8, 0, 1};
  scene.positions = {{-9, -9, 0.5F, 1}, {30, -9, 0.5F, 1}, {-9, 30, 0.5F, 1}};
  const TestPlanes planes = render(scene);
  const auto locations = standard_sample_locations(4);
  for (uint32_t y = 0; y < 16; ++y) {
    for (uint32_t x = 0; x < 16; ++x) {
      for (uint32_t sample = 0; sample < 4; ++sample) {
        const double x_sample = x + locations[sample].x_16 / 16.0;
        const double y_sample = y + locations[sample].y_16 / 16.0;
        const bool is_inside = x_sample >= 2.5 && x_sample < 10.5 && y_sample >= 3.25 && y_sample < 11.25;
        ASSERT_EQ(planes.hits[planes.pixel(x, y, sample)], is_inside ? 1U : 0U) << x << ", " << y << ", " << sample;
      }
    }
  }
}

// A slope of 1/64 in x: each sample has a depth of its own, and is tested by itself.
TEST(Samples, DepthIsTestedAtEachOfThem) {
  TestScene scene(64, 8);
  scene.samples = 4;
  scene.state.depth_test = true;
  scene.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  scene.positions = {scene.at(0, 0, 0), scene.at(64, 0, 1), scene.at(0, 8, 0), scene.at(64, 8, 1)};
  TestPlanes planes = render(scene);
  const auto locations = standard_sample_locations(4);
  for (uint32_t x = 0; x < 64; ++x) {
    for (uint32_t sample = 0; sample < 4; ++sample) {
      const double x_sample = x + locations[sample].x_16 / 16.0;
      ASSERT_NEAR(planes.depth[planes.pixel(x, 3, sample)], x_sample / 64, 1e-7);
    }
  }
  // A constant depth of 10.5/64 behind it: nearer from sample (10, 1) on.
  for (ClipPosition& position : scene.positions) {
    position[2] = 10.5F / 64;
  }
  ASSERT_TRUE(render_into(scene, planes));
  EXPECT_EQ(planes.hits[planes.pixel(10, 3, 0)], 1U);
  EXPECT_EQ(planes.hits[planes.pixel(10, 3, 1)], 2U);
  EXPECT_EQ(planes.hits[planes.pixel(10, 3, 2)], 1U);
  EXPECT_EQ(planes.hits[planes.pixel(10, 3, 3)], 2U);
}

TEST(Samples, TheMaskLeavesOut) {
  for (const uint32_t samples : {1U, 4U}) {
    TestScene scene(8, 8);
    scene.samples = samples;
    scene.state.depth_test = true;
    scene.positions = {{-9, -9, 0.5F, 1}, {30, -9, 0.5F, 1}, {-9, 30, 0.5F, 1}};
    scene.state.sample_mask = 0xFFFFFFFA;
    const TestPlanes planes = render(scene);
    for (size_t i = 0; i < planes.hits.size(); ++i) {
      const bool is_kept = samples == 4 && i % 2 == 1;
      ASSERT_EQ(planes.hits[i], is_kept ? 1U : 0U) << i;
      ASSERT_EQ(planes.depth[i], is_kept ? 0.5F : 1.0F) << i;
    }
  }
}

// The window's x as a varying tells where it was evaluated.
TEST(Samples, CentreCentroidAndSampleShading) {
  TestScene scene(16, 16);
  scene.samples = 4;
  scene.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  // The left border at 2.5 px leaves samples 1 and 3 of pixel 2.
  scene.positions = {scene.at(2.5, 0), scene.at(16, 0), scene.at(2.5, 16), scene.at(16, 16)};
  scene.values = {2.5, 16, 2.5, 16};
  for (const bool sample_shading : {false, true}) {
    scene.sample_shading = sample_shading;
    const TestPlanes planes = render(scene);
    const auto at = [&](const std::vector<float>& plane, uint32_t x, uint32_t sample) {
      return plane[planes.pixel(x, 5, sample)];
    };
    EXPECT_EQ(planes.hits[planes.pixel(2, 5, 0)], 0U);
    EXPECT_EQ(planes.hits[planes.pixel(2, 5, 3)], 1U);
    EXPECT_NEAR(at(planes.noperspective, 2, 3), 2.5, 1e-6);
    EXPECT_NEAR(at(planes.centroid, 2, 3), 2.875, 1e-6);
    EXPECT_NEAR(at(planes.at_sample, 2, 3), sample_shading ? 2.625 : 2.5, 1e-6);
    EXPECT_NEAR(at(planes.noperspective, 7, 2), 7.5, 1e-6);
    EXPECT_NEAR(at(planes.centroid, 7, 2), 7.5, 1e-6);
    EXPECT_NEAR(at(planes.at_sample, 7, 2), sample_shading ? 7.125 : 7.5, 1e-6);
  }
}

}  // namespace
}  // namespace fillrule::renderer
