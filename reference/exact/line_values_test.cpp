#include "reference/exact/line_values.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace fillrule::exact {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

RasterState state_of() {
  RasterState state;
  state.viewport = {.x = 0, .y = 0, .width = 64, .height = 64, .minDepth = 0, .maxDepth = 1};
  return state;
}

ClipPosition at(double x, double y, double z, double w) {
  return {static_cast<float>((x / 32 - 1) * w), static_cast<float>((y / 32 - 1) * w), static_cast<float>(z * w),
          static_cast<float>(w)};
}

LineValues values_of(const ClipPosition& a, const ClipPosition& b,
                     LineValues::Rule rule = LineValues::Rule::kProjected) {
  return LineValues(Segment({a, b}, {}, state_of()), latitude_of(state_of().viewport, 8), rule);
}

TEST(LineValues, RunAlongTheProjectionOntoTheLine) {
  LineValues values = values_of(at(10, 20, 0.25, 1), at(30, 20, 0.75, 1));
  values.add_component(Interpolation::kNoperspective, {0, 20}, 0);
  EXPECT_NEAR(values.depth(15, 20).value, 0.375, 1e-6);
  EXPECT_NEAR(values.depth(15, 23).value, 0.375, 1e-6);
  EXPECT_NEAR(values.exact_varying(0, 15, 23), 5, 1e-5);
  EXPECT_NEAR(values.exact_varying(0, 32, 23), 22, 1e-5);  // extrapolated
  // Half a subpixel of either end, and a few units in the last place.
  EXPECT_NEAR(values.varying_tolerance(0, 15, 20).snapping, 1.0 / 512, 1e-4);
  EXPECT_LT(values.varying_tolerance(0, 15, 20).rounding, 4e-5);
}

TEST(LineValues, AreCorrectInPerspective) {
  LineValues values = values_of(at(10, 20, 0.2, 1), at(30, 40, 0.8, 4));
  values.add_component(Interpolation::kSmooth, {1, 2}, 1);
  values.add_component(Interpolation::kNoperspective, {1, 2}, 1);
  // Half way in the window: (1/1 + 2/4) / (1/1 + 1/4).
  EXPECT_NEAR(values.exact_varying(0, 20, 30), 1.2, 1e-6);
  EXPECT_NEAR(values.exact_varying(1, 20, 30), 1.5, 1e-6);
  EXPECT_NEAR(values.depth(20, 30).value, 0.5, 1e-6);
}

TEST(LineValues, NeedNoVertexInFrontOfTheEye) {
  // The same line, its second end beyond w = 0: A + 2 (B - A).
  const ClipPosition a = at(10, 20, 0.2, 1);
  const ClipPosition b = at(30, 40, 0.3, 0.25);
  const auto beyond = [](float p, float q) { return p + 2 * (q - p); };
  ClipPosition behind;
  for (size_t i = 0; i < 4; ++i) behind[i] = beyond(a[i], b[i]);
  ASSERT_LT(behind[3], 0);
  LineValues near = values_of(a, b);
  LineValues far = values_of(a, behind);
  near.add_component(Interpolation::kSmooth, {1, 2}, 1);
  far.add_component(Interpolation::kSmooth, {1, 3}, 1);
  EXPECT_NEAR(near.exact_varying(0, 16, 26), far.exact_varying(0, 16, 26), 1e-6);
  EXPECT_NEAR(near.depth(16, 26).value, far.depth(16, 26).value, 1e-6);
}

TEST(LineValues, OfABresenhamLineMayFollowItsMajorAxis) {
  const ClipPosition a = at(10, 20, 0.25, 1);
  const ClipPosition b = at(30, 30, 0.75, 1);
  LineValues values = values_of(a, b, LineValues::Rule::kBresenham);
  values.add_component(Interpolation::kNoperspective, {0, 20}, 0);
  // At (20, 26), one below the line: 10 by the major axis, 10 + 0.4 by projection.
  for (const float right : {10.0F, 10.2F, 10.4F})
    EXPECT_NEAR(values.varying_for(0, right, 20, 26).value, right, 1e-5);
  EXPECT_NEAR(values.varying_for(0, 9, 20, 26).value, 10, 1e-5);
  EXPECT_NEAR(values.varying_for(0, 11, 20, 26).value, 10.4, 1e-5);
  EXPECT_NEAR(values.exact_varying(0, 20, 26), 10.2, 1e-5);
  LineValues projected = values_of(a, b);
  projected.add_component(Interpolation::kNoperspective, {0, 20}, 0);
  EXPECT_NEAR(projected.varying_for(0, 10, 20, 26).value, 10.4, 1e-5);
}

TEST(LineValues, OfLeastToleranceAreTheSameAndTheirToleranceNoLarger) {
  constexpr unsigned kSeed = 23;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const std::array rules{LineValues::Rule::kProjected, LineValues::Rule::kBresenham,
                         LineValues::Rule::kWideBresenham};
  constexpr std::array<uint32_t, 2> kBoth{0, 1};
  int close = 0;
  for (int i = 0; i < 3000; ++i) {
    const double w = i % 2 == 0 ? 1 : between(0.1, 100);
    const ClipPosition a = at(between(-20, 80), between(-20, 80), between(0, 1), between(0.5, 2));
    const ClipPosition b = at(between(-20, 80), between(-20, 80), between(0, 1), w);
    LineValues values = values_of(a, b, rules[static_cast<size_t>(i) % rules.size()]);
    values.add_component(Interpolation::kSmooth, {1, static_cast<float>(between(-3, 3))}, 0);
    values.add_component(Interpolation::kNoperspective, {1, static_cast<float>(between(-3, 3))}, 0);
    const double x = std::floor(between(0, 64)) + 0.5;
    const double y = std::floor(between(0, 64)) + 0.5;
    std::array<Expected, 2> all;
    std::array<Expected, 2> least;
    values.varyings(x, y, kBoth, all);
    values.least_varyings(x, y, kBoth, least);
    for (uint32_t c = 0; c < 2; ++c) {
      EXPECT_NEAR(least[c].value, all[c].value, 1e-12 * (1 + std::abs(all[c].value))) << i;
      EXPECT_LE(least[c].tolerance, all[c].tolerance * (1 + 1e-12)) << i;
      close += least[c].tolerance >= all[c].tolerance / 16 ? 1 : 0;
      // A value just beyond all of the tolerance is told so whichever of both is asked.
      constexpr double kOfFloat = 0x1p-22;  // more than converting it to float32 rounds
      const double beyond = all[c].value + all[c].tolerance * 1.01 + kOfFloat * std::abs(all[c].value);
      if (!std::isfinite(beyond)) continue;
      const Expected asked = values.varying_for(c, static_cast<float>(beyond), x, y);
      EXPECT_GT(std::abs(double{static_cast<float>(beyond)} - asked.value), asked.tolerance) << i;
    }
  }
  EXPECT_GT(close, 1000);
}

TEST(LineValues, WithoutFiniteInputNothingIsJudged) {
  LineValues values = values_of(at(10, 20, 0.25, 1), at(30, 30, 0.75, 1));
  values.add_component(Interpolation::kSmooth, {0, kNan}, 0);
  EXPECT_FALSE(values.judged(0));
  EXPECT_TRUE(std::isinf(values.varying_for(0, 1, 20, 25).tolerance));
}

TEST(LineValues, AClippersRoundingOfFarEndsIsAllowedFor) {
  const LineValues near = values_of(at(10, 20, 0.5, 1), at(30, 20, 0.5, 1));
  const LineValues far = values_of(at(10, 20, 0.5, 1), at(30000, 20, 0.5, 1));
  EXPECT_LT(near.depth(15, 20).tolerance, 3e-7);
  EXPECT_GT(far.depth(15, 20).tolerance, 5e-7);
  EXPECT_LT(far.depth(15, 20).tolerance, 2e-6);
}

TEST(LineValues, DepthFollowsTheViewportAndTheVolume) {
  RasterState state = state_of();
  state.viewport.minDepth = 0.75F;
  state.viewport.maxDepth = 0.25F;
  state.negative_one_to_one = true;
  const Segment segment({at(10, 20, -1, 1), at(30, 20, 1, 1)}, {}, state);
  const LineValues values(segment, latitude_of(state.viewport, 8), LineValues::Rule::kProjected);
  EXPECT_NEAR(values.depth(15, 20).value, 0.625, 1e-6);
}

}  // namespace
}  // namespace fillrule::exact
