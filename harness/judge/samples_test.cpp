// Several samples a pixel, depth formats and built-ins: what the renderer draws is right, and what is changed in it
// is found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "harness/judge/judge.h"
#include "harness/programs/varyings.h"

namespace fillrule::judge {
namespace {

// A slanted triangle with a varying evaluated at the centre, one at a centroid and gl_FragCoord.
Case slanted(VkSampleCountFlagBits samples, VkFormat depth_format) {
  Case one{.target = {.width = 16, .height = 16, .depth_format = depth_format, .samples = samples},
           .varyings = {{.name = "a"},
                        {.name = "c", .sampling = Sampling::kCentroid},
                        {.name = "place", .components = 4, .source = VaryingSource::kFragCoord}}};
  Draw draw;
  draw.state.viewport = {.width = 16, .height = 16, .maxDepth = 1};
  draw.state.scissor = {.extent = {.width = 16, .height = 16}};
  draw.state.depth_test = true;
  draw.state.depth_compare = VK_COMPARE_OP_LESS;
  draw.positions = {{-0.8F, -0.7F, 0.1F, 1}, {1.5F, -0.4F, 0.9F, 2}, {-0.3F, 0.9F, 0.6F, 1}};
  draw.varyings = {0, 0, 1, 1, 2, 2};
  one.draws.push_back(draw);
  return one;
}

Planes drawn(const Case& one) {
  Result<Planes> planes = programs::draw_case(one, {});
  EXPECT_TRUE(planes);
  return std::move(*planes);
}

uint64_t faults(const Case& one, const Planes& planes, const std::string& plane) {
  const CaseVerdict verdict = judge(one, {.planes = &planes, .subpixel_bits = 8}, nullptr, {});
  for (const PlaneVerdict& of_plane : verdict.planes) {
    if (of_plane.name == plane) return of_plane.candidate_faults();
  }
  ADD_FAILURE() << "no plane " << plane;
  return 0;
}

// The faults of a plane after a change.
uint64_t faults_after(const Case& one, const std::string& plane, const std::function<void(Planes&)>& change) {
  Planes planes = drawn(one);
  change(planes);
  return faults(one, planes, plane);
}

size_t covered_sample(const Planes& planes) {
  return static_cast<size_t>(std::ranges::find(planes.hits, 1U) - planes.hits.begin());
}

TEST(Samples, TheRendererIsRightAtAnyNumber) {
  for (const VkSampleCountFlagBits samples : {VK_SAMPLE_COUNT_1_BIT, VK_SAMPLE_COUNT_2_BIT, VK_SAMPLE_COUNT_4_BIT,
                                              VK_SAMPLE_COUNT_8_BIT, VK_SAMPLE_COUNT_16_BIT}) {
    for (const VkFormat format : {VK_FORMAT_D16_UNORM, VK_FORMAT_X8_D24_UNORM_PACK32, VK_FORMAT_D32_SFLOAT}) {
      const Case one = slanted(samples, format);
      const Planes planes = drawn(one);
      EXPECT_EQ(judge(one, {.planes = &planes, .subpixel_bits = 8}, nullptr, {}).candidate_faults(), 0U) << samples;
    }
  }
}

TEST(Samples, SamplesInTheWrongOrderAreFound) {
  const Case one = slanted(VK_SAMPLE_COUNT_4_BIT, VK_FORMAT_D32_SFLOAT);
  EXPECT_GT(faults_after(one, "coverage",
                         [](Planes& planes) {
                           for (size_t i = 0; i < planes.hits.size(); i += 4) {
                             std::swap(planes.hits[i], planes.hits[i + 3]);
                           }
                         }),
            0U);
}

// Values that grow by a pixel's worth from sample to sample, beginning with the right one in each row.
TEST(Samples, SamplesOfAPixelAreNoPixelsOfARow) {
  Case one = slanted(VK_SAMPLE_COUNT_4_BIT, VK_FORMAT_D32_SFLOAT);
  one.varyings = {{.name = "x", .sampling = Sampling::kSample}};
  Draw& draw = one.draws.front();
  draw.positions = {{-1, -1, 0.5F, 1}, {3, -1, 0.5F, 1}, {-1, 3, 0.5F, 1}};
  draw.varyings = {0, 32, 0};
  EXPECT_EQ(faults(one, drawn(one), "x"), 0U);
  EXPECT_GT(faults_after(one, "x",
                         [](Planes& planes) {
                           std::vector<float>& x = planes.varyings[0];
                           for (size_t i = 0; i < x.size(); ++i) {
                             const size_t row_begin = i - i % 64;
                             x[i] = x[row_begin] + static_cast<float>(i % 64);
                           }
                         }),
            0U);
}

TEST(Samples, AMaskedSampleMustNotBeCovered) {
  Case one = slanted(VK_SAMPLE_COUNT_4_BIT, VK_FORMAT_D32_SFLOAT);
  const Planes unmasked = drawn(one);
  one.draws.front().state.sample_mask = 0b1011;
  EXPECT_GT(faults(one, unmasked, "coverage"), 0U);
  EXPECT_EQ(faults(one, drawn(one), "coverage"), 0U);
}

TEST(Samples, ADepthIsOfItsFormatAndNotFarFromTheExactOne) {
  const Case one = slanted(VK_SAMPLE_COUNT_4_BIT, VK_FORMAT_D16_UNORM);
  const auto after_adding = [&](double codes) {
    return faults_after(one, "depth", [codes](Planes& planes) {
      float& depth = planes.depth[covered_sample(planes)];
      depth = static_cast<float>((std::nearbyint(double{depth} * 0xFFFF) + codes) / 0xFFFF);
    });
  };
  EXPECT_EQ(after_adding(0), 0U);
  EXPECT_EQ(after_adding(0.5), 1U);
  EXPECT_EQ(after_adding(8000), 1U);
}

TEST(Samples, FragCoordIsThePixelsCentreToTheBit) {
  const Case one = slanted(VK_SAMPLE_COUNT_4_BIT, VK_FORMAT_D32_SFLOAT);
  const auto after_adding = [&](size_t component, float difference) {
    return faults_after(
        one, "place", [&](Planes& planes) { planes.varyings[2 + component][covered_sample(planes)] += difference; });
  };
  EXPECT_EQ(after_adding(0, 0), 0U);
  EXPECT_EQ(after_adding(0, 0.125F), 1U);
  EXPECT_EQ(after_adding(1, -0.5F), 1U);
  EXPECT_EQ(after_adding(2, 0.5F), 1U);
  EXPECT_EQ(after_adding(3, 0.25F), 1U);
}

TEST(Samples, ACentroidLiesInThePixel) {
  const Case one = slanted(VK_SAMPLE_COUNT_4_BIT, VK_FORMAT_D32_SFLOAT);
  EXPECT_EQ(faults_after(one, "c", [](Planes& planes) { planes.varyings[1][covered_sample(planes)] += 0.5F; }), 1U);
}

TEST(DepthBounds, ThoseOfTheStoredDepthDecide) {
  Case one = slanted(VK_SAMPLE_COUNT_1_BIT, VK_FORMAT_D32_SFLOAT);
  const Planes without = drawn(one);
  one.draws.front().state.depth_bounds = DepthBounds{.min = 0, .max = 0.5F};  // the target is cleared to 1
  EXPECT_GT(faults(one, without, "coverage"), 0U);
  EXPECT_EQ(faults(one, drawn(one), "coverage"), 0U);
}

TEST(DepthBias, ABiasOfAnotherSignIsFound) {
  Case one = slanted(VK_SAMPLE_COUNT_1_BIT, VK_FORMAT_D32_SFLOAT);
  one.draws.front().state.depth_bias = DepthBias{.slope_factor = 2};
  const Planes right = drawn(one);
  EXPECT_EQ(faults(one, right, "depth"), 0U);
  one.draws.front().state.depth_bias->slope_factor = -2;
  EXPECT_GT(faults(one, right, "depth"), 0U);
}

}  // namespace
}  // namespace fillrule::judge
