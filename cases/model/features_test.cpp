#include "cases/model/features.h"

#include <gtest/gtest.h>

namespace fillrule {
namespace {

Case one_draw() {
  Case one;
  one.draws.emplace_back();
  return one;
}

TEST(Features, TheTableIsInTheOrderOfTheEnumeration) {
  for (size_t i = 0; i < kFeatureCount; ++i) EXPECT_EQ(static_cast<size_t>(kFeatures[i].feature), i);
}

TEST(Features, FilledTrianglesNeedNone) {
  EXPECT_TRUE(features_of(one_draw()).empty());
}

TEST(Features, WidthsAndSizesCountWhereTheyAreUsed) {
  Case one = one_draw();
  Draw& draw = one.draws.front();
  draw.state.line_width = 2;
  draw.point_sizes = {2, 2, 2};
  EXPECT_TRUE(features_of(one).empty());
  draw.state.polygon_mode = VK_POLYGON_MODE_LINE;
  EXPECT_TRUE(features_of(one).has(Feature::kWideLines));
  EXPECT_FALSE(features_of(one).has(Feature::kLargePoints));
  draw.state.polygon_mode = VK_POLYGON_MODE_POINT;
  EXPECT_TRUE(features_of(one).has(Feature::kLargePoints));
  EXPECT_FALSE(features_of(one).has(Feature::kWideLines));
}

TEST(Features, DepthClampTurnsClippingOffByItself) {
  Case one = one_draw();
  RasterState& state = one.draws.front().state;
  state.depth_clamp = true;
  state.depth_clip = false;
  EXPECT_FALSE(features_of(one).has(Feature::kDepthClipOff));
  state.depth_clip = true;
  EXPECT_TRUE(features_of(one).has(Feature::kDepthClipOff));
}

TEST(Features, NamesWhatIsMissingWithItsKey) {
  Case one = one_draw();
  one.target.samples = VK_SAMPLE_COUNT_8_BIT;
  one.draws.front().state.depth_bounds = DepthBounds{};
  EXPECT_EQ(to_string(features_of(one)), "8 samples (samples), depth bounds (depth_bounds)");
  EXPECT_EQ(to_string(features_of(one).without(features_of(one))), "");
}

}  // namespace
}  // namespace fillrule
