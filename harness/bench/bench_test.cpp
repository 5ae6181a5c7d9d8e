#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/bench/curves.h"
#include "harness/bench/measure.h"
#include "harness/bench/report.h"
#include "harness/bench/workloads.h"

namespace fillrule::bench {
namespace {

using testing::HasSubstr;

TEST(Timing, IsTheMedianWithItsQuartiles) {
  const Timing timing = timing_of({5, 1, 4, 2, 3});
  EXPECT_EQ(timing.median, 3);
  EXPECT_EQ(timing.lower_quartile, 2);
  EXPECT_EQ(timing.upper_quartile, 4);
}

TEST(PictureDifference, TellsCoverageFromColor) {
  const std::vector<uint32_t> picture{0xFF102030, 0xFF102030, 0, 0xFF102030, 0x80102030};
  const std::vector<uint32_t> other{0xFF102031, 0xFF102060, 0xFF000000, 0, 0xC0102030};
  EXPECT_EQ(difference(picture, picture, 4).coverage, 0U);
  EXPECT_EQ(difference(picture, other, 4).coverage, 3U);
  EXPECT_EQ(difference(picture, other, 4).color, 1U);
}

// Small scenes of every family, and both kinds of samples and attributes.
std::vector<Scene> small_scenes() {
  std::vector<Scene> scenes{fill_scene(3, 100), random_triangles_scene(200, 60, 100), grid_scene(2'000, 100),
                            lines_scene(100, 20, 100), clip_scene(50, 100)};
  for (const Scene& scene :
       {fill_scene(3, 100), random_triangles_scene(200, 60, 100), grid_scene(2'000, 100), clip_scene(50, 100)}) {
    scenes.push_back(scene);
    scenes.back().samples = 4;
  }
  scenes.push_back(random_triangles_scene(200, 60, 100));
  scenes.back().is_flat = true;
  return scenes;
}

std::vector<uint32_t> picture_of(const Scene& scene, uint32_t threads, renderer::Isa isa) {
  const Party party = make_renderer(scene, threads, isa);
  EXPECT_TRUE(party.draw());
  return *party.picture();
}

TEST(Renderer, DrawsTheSameColorsWithAnyInstructionSetAndThreads) {
  for (const Scene& scene : small_scenes()) {
    const std::vector<uint32_t> expected = picture_of(scene, 1, renderer::Isa::kScalar);
    EXPECT_GT(std::ranges::count_if(expected, [](uint32_t color) { return color != 0; }), 500);
    for (const renderer::Isa isa : renderer::kAllIsas) {
      if (!renderer::is_supported(isa)) continue;
      EXPECT_EQ(picture_of(scene, 1, isa), expected) << renderer::to_string(isa);
      EXPECT_EQ(picture_of(scene, 3, isa), expected) << renderer::to_string(isa);
    }
  }
}

TEST(Measure, ComparesTheRendererWithTheDriver) {
  const std::vector<Scene> small = small_scenes();
  for (const Scene& scene : small) {
    SCOPED_TRACE(&scene - small.data());
    const auto measured = measure("small", scene, {.repetitions = 1});
    ASSERT_TRUE(measured) << to_string(measured.error());
    EXPECT_EQ(measured->difference.coverage, 0U);
    EXPECT_GT(measured->ratio(), 0);
  }
}

TEST(Report, HasNamesAndRatios) {
  const Measurement one{.name = "fill",
                        .threads = 2,
                        .isa = renderer::Isa::kAvx2,
                        .renderer = {.median = 2},
                        .reference = {.median = 5}};
  const std::string json = to_json(std::vector{one});
  EXPECT_THAT(json, HasSubstr("\"name\": \"fill\""));
  EXPECT_THAT(json, HasSubstr("\"isa\": \"avx2\""));
  EXPECT_THAT(json, HasSubstr("\"renderer_ms\": 2.0"));
  EXPECT_THAT(json, HasSubstr("\"ratio\": 2.5"));
  EXPECT_THAT(to_svg(std::vector{one}), HasSubstr(">2.50</text>"));
}

TEST(Curves, VaryOneThingAndCountItsWork) {
  const std::vector<Curve> curves = scaling_curves(2);
  ASSERT_EQ(curves.size(), 4U);
  const CurvePoint& first = curves[0].points.front();
  EXPECT_NEAR(static_cast<double>(first.make().indices.size()) / 3, first.work, first.work / 20);
  EXPECT_EQ(curves[2].points.size(), 2U);
}

}  // namespace
}  // namespace fillrule::bench
