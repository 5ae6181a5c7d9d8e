// Several samples a pixel, on each driver: which are covered, what each holds, and where varyings are evaluated.
#include <gmock/gmock.h>

#include <bit>
#include <cmath>

#include "reference/vulkan/test_support.h"

namespace fillrule::vulkan {
namespace {

using testing::Each;
using testing::ElementsAre;

class Samples : public OnEachDriver {};
INSTANTIATE_TEST_SUITE_P(Drivers, Samples, testing::ValuesIn(kDrivers));

// Four samples are at (3, 1) / 8, (7, 3) / 8, (1, 5) / 8 and (5, 7) / 8 of the pixel.
constexpr std::array<float, 4> kX = {0.375F, 0.875F, 0.125F, 0.625F};
constexpr std::array<float, 4> kY = {0.125F, 0.375F, 0.625F, 0.875F};

// An 8 x 8 target with the triangle (x0, -8) (x0, 16) (x0 + 24, 4): everything from x0 to the right.
Case right_of(float x0, std::vector<Varying> varyings = {}, std::vector<float> values = {}) {
  Case drawn = empty_case(8, std::move(varyings));
  drawn.target.samples = VK_SAMPLE_COUNT_4_BIT;
  drawn.draws = {draw_of(drawn, {at(8, x0, -8), at(8, x0, 16), at(8, x0 + 24, 4)}, std::move(values))};
  return drawn;
}

// The samples of a pixel.
template <typename T>
std::vector<T> samples_of(const Planes& planes, const std::vector<T>& plane, uint32_t x, uint32_t y) {
  const auto first = plane.begin() + static_cast<ptrdiff_t>(pixel(planes, x, y) * planes.samples);
  return {first, first + planes.samples};
}

TEST_P(Samples, AreCoveredOneByOne) {
  Case drawn = right_of(3.5F);
  drawn.draws.push_back(right_of(3.8125F).draws[0]);
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  EXPECT_EQ(planes->samples, 4U);
  ASSERT_EQ(planes->hits.size(), 256U);
  EXPECT_THAT(samples_of(*planes, planes->hits, 2, 5), ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(samples_of(*planes, planes->hits, 3, 5), ElementsAre(0, 2, 0, 1));
  EXPECT_THAT(samples_of(*planes, planes->hits, 4, 5), ElementsAre(2, 2, 2, 2));
  EXPECT_THAT(samples_of(*planes, planes->owner, 3, 5), ElementsAre(kNoOwner, 1, kNoOwner, 0));
  EXPECT_THAT(samples_of(*planes, planes->front_facing, 3, 5), ElementsAre(0, 1, 0, 1));
}

TEST_P(Samples, OfEveryCountAreAtTheirStandardLocations) {
  for (const VkSampleCountFlagBits count :
       {VK_SAMPLE_COUNT_2_BIT, VK_SAMPLE_COUNT_4_BIT, VK_SAMPLE_COUNT_8_BIT, VK_SAMPLE_COUNT_16_BIT}) {
    Case drawn = right_of(3.5F);
    drawn.target.samples = count;
    const auto planes = draw(drawn);
    if (!planes) continue;  // a count that the device lacks
    const std::vector<uint32_t> hits = samples_of(*planes, planes->hits, 3, 5);
    EXPECT_EQ(std::ranges::count(hits, 1U), count / 2) << count;
  }
}

TEST_P(Samples, HaveADepthEach) {
  // z = (y + 8) / 32. Along x, SwiftShader's depths are those of the samples mirrored at the pixel's centre.
  for (const VkFormat format : {VK_FORMAT_D32_SFLOAT, VK_FORMAT_D16_UNORM, VK_FORMAT_X8_D24_UNORM_PACK32}) {
    Case drawn = right_of(3.5F);
    drawn.target.depth_format = format;
    drawn.draws[0].state.depth_test = true;
    drawn.draws[0].positions = {at(8, 3.5F, -8, 0), at(8, 3.5F, 16, 0.75F), at(8, 27.5F, 4, 0.375F)};
    const auto planes = draw(drawn);
    if (!planes) GTEST_SKIP() << planes.error().what;
    const std::vector<float> depths = samples_of(*planes, planes->depth, 5, 2);
    for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(depths[i], (10 + kY[i]) / 32, 1e-5) << format << ' ' << i;
    const std::vector<float> at_edge = samples_of(*planes, planes->depth, 3, 2);
    for (const size_t i : {0U, 2U}) EXPECT_EQ(at_edge[i], 1.0F) << format << ' ' << i;
    for (const size_t i : {1U, 3U}) EXPECT_NEAR(at_edge[i], (10 + kY[i]) / 32, 1e-5) << format << ' ' << i;
    const double max = format == VK_FORMAT_D16_UNORM ? 65535 : 16777215;
    for (const float depth : depths) {
      const bool is_code = static_cast<float>(std::nearbyint(depth * max) / max) == depth;
      EXPECT_TRUE(is_code || format == VK_FORMAT_D32_SFLOAT) << format << ' ' << depth;
    }
  }
}

TEST_P(Samples, AreMasked) {
  Case drawn = right_of(-1);
  drawn.draws[0].state.sample_mask = 0b0110;
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  EXPECT_THAT(samples_of(*planes, planes->hits, 4, 4), ElementsAre(0, 1, 1, 0));
}

// The window position as a varying: x is 0 at the left edge of the triangle and 24 at its tip, y -8 to 16.
Case window_position(float x0, Sampling sampling) {
  const Varying position{
      .name = "at", .components = 2, .interpolation = Interpolation::kNoperspective, .sampling = sampling};
  return right_of(x0, {position}, {x0, -8, x0, 16, x0 + 24, 4});
}

TEST_P(Samples, ShareTheCentersValue) {
  const auto planes = draw(window_position(3.75F, Sampling::kCenter));
  if (!planes) GTEST_SKIP() << planes.error().what;
  // The centre lies outside of the primitive in the first pixel.
  EXPECT_THAT(samples_of(*planes, planes->hits, 3, 2), ElementsAre(0, 1, 0, 0));
  EXPECT_NEAR(samples_of(*planes, planes->varyings[0], 3, 2)[1], 3.5F, 1e-3);
  EXPECT_NEAR(samples_of(*planes, planes->varyings[1], 3, 2)[1], 2.5F, 1e-3);
}

TEST_P(Samples, HaveTheCentroidsValueWithinThePrimitive) {
  const auto planes = draw(window_position(3.75F, Sampling::kCentroid));
  if (!planes) GTEST_SKIP() << planes.error().what;
  const float x = samples_of(*planes, planes->varyings[0], 3, 2)[1];
  const float y = samples_of(*planes, planes->varyings[1], 3, 2)[1];
  EXPECT_GE(x, 3.75F - 1e-3F);
  EXPECT_LE(x, 4);
  EXPECT_GE(y, 2);
  EXPECT_LE(y, 3);
}

TEST_P(Samples, HaveAValueEachWhereInterpolatedAtSamples) {
  Case drawn = window_position(3.75F, Sampling::kSample);
  drawn.varyings.push_back({.name = "frag", .components = 4, .source = VaryingSource::kFragCoord});
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(samples_of(*planes, planes->varyings[0], 5, 2)[i], 5 + kX[i], 1e-3) << i;
    EXPECT_NEAR(samples_of(*planes, planes->varyings[1], 5, 2)[i], 2 + kY[i], 1e-3) << i;
    EXPECT_NEAR(samples_of(*planes, planes->varyings[2], 5, 2)[i], 5 + kX[i], 1e-3) << i;
    EXPECT_NEAR(samples_of(*planes, planes->varyings[3], 5, 2)[i], 2 + kY[i], 1e-3) << i;
  }
}

TEST_P(Samples, KeepTheBitsOfFlatValues) {
  const std::array<uint32_t, 4> bits = {0x7FC12345U, 0xFFC00001U, 0x00000001U, 0x80000000U};
  const Varying flat{.name = "f", .components = 4, .interpolation = Interpolation::kFlat};
  std::vector<float> values;
  for (int vertex = 0; vertex < 3; ++vertex) {
    for (const uint32_t value : bits) values.push_back(std::bit_cast<float>(value));
  }
  const auto planes = draw(right_of(-1, {flat}, values));
  if (!planes) GTEST_SKIP() << planes.error().what;
  for (size_t i = 0; i < 4; ++i) {
    for (const float value : samples_of(*planes, planes->varyings[i], 7, 7)) {
      EXPECT_EQ(std::bit_cast<uint32_t>(value), bits[i]);
    }
  }
}

TEST_P(Samples, TakeMoreThanOnePass) {
  std::vector<Varying> varyings(8, {.name = "v", .components = 4, .interpolation = Interpolation::kFlat});
  std::vector<float> values;
  for (int vertex = 0; vertex < 3; ++vertex) {
    for (int i = 0; i < 32; ++i) values.push_back(static_cast<float>(i));
  }
  Case drawn = right_of(-1, varyings, values);
  drawn.target.width = 7;
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  for (size_t i = 0; i < 32; ++i) EXPECT_THAT(planes->varyings[i], Each(static_cast<float>(i))) << i;
  EXPECT_THAT(planes->hits, Each(1U));
}

TEST_P(Samples, AreDrawnAmongCasesOfOneSample) {
  std::vector<Case> cases = {right_of(3.5F), right_of(3.5F), right_of(3.5F), right_of(3.5F)};
  cases[1].target.samples = VK_SAMPLE_COUNT_1_BIT;
  cases[2].target.width = 5;
  std::vector<const Case*> pointers;
  pointers.reserve(cases.size());
  for (const Case& drawn : cases) pointers.push_back(&drawn);
  const auto together = reference().draw(pointers);
  expect_no_messages(reference());
  for (size_t i = 0; i < cases.size(); ++i) {
    const auto alone = draw(cases[i]);
    if (!alone) GTEST_SKIP() << alone.error().what;
    ASSERT_TRUE(together[i]) << to_string(together[i].error());
    EXPECT_TRUE(same_bytes(*together[i], *alone)) << i;
  }
}

}  // namespace
}  // namespace fillrule::vulkan
