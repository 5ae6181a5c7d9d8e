#include "renderer/outlines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer/edge_function.h"
#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

TEST(PointOutline, IsTheSquareAroundItsCentre) {
  EXPECT_EQ(point_outline({8.5, 4.25}, 1, 8), (FixedQuad{{{2048, 960}, {2304, 960}, {2304, 1216}, {2048, 1216}}}));
  // The size is rounded to whole subpixels, and of an odd one the larger half lies to the right and down.
  EXPECT_EQ(point_outline({0, 0}, 1.0F + 1.0F / 256, 8),
            (FixedQuad{{{-128, -128}, {129, -128}, {129, 129}, {-128, 129}}}));
  EXPECT_EQ(point_outline({1, 1}, 3, 4), (FixedQuad{{{-8, -8}, {40, -8}, {40, 40}, {-8, 40}}}));
}

TEST(Outlines, EndsHalfWayBetweenSubpixelsGoAwayFromZero) {
  EXPECT_EQ(snapped_end({2.5 / 256, -2.5 / 256}, 8), (FixedPosition{3, -3}));
  EXPECT_EQ(snapped_end({3.5 / 256, 1.4375 / 16}, 8), (FixedPosition{4, 23}));
}

TEST(PointOutline, SizesAreClamped) {
  EXPECT_EQ(effective_point_size(0), 1);
  EXPECT_EQ(effective_point_size(-5), 1);
  EXPECT_EQ(effective_point_size(7.5F), 7.5F);
  EXPECT_EQ(effective_point_size(1000), 255);
  EXPECT_EQ(effective_point_size(std::numeric_limits<float>::quiet_NaN()), 1);
}

TEST(LineOutline, IsTheRectangleAroundTheSegment) {
  EXPECT_EQ(line_outline({2, 3}, {6, 3}, 1, 8), (FixedQuad{{{512, 896}, {1536, 896}, {1536, 640}, {512, 640}}}));
  EXPECT_EQ(line_outline({3, 2}, {3, 6}, 2, 8), (FixedQuad{{{512, 512}, {512, 1536}, {1024, 1536}, {1024, 512}}}));
  EXPECT_EQ(line_outline({3, 2}, {3, 2}, 1, 8), std::nullopt);
}

// Ends and half widths are rounded apart: no corner is further than one subpixel from the exact rectangle's, in x or
// y.
TEST(LineOutline, CornersAreThoseOfTheExactRectangle) {
  SeededRandom random;
  for (int i = 0; i < 5000; ++i) {
    const auto coordinate = [&] { return static_cast<double>(static_cast<float>(random.uniform(0, 256))); };
    const FramebufferPosition a{coordinate(), coordinate()};
    const FramebufferPosition b{coordinate(), coordinate()};
    const auto width = static_cast<float>(random.uniform(1, 16));
    const std::optional<FixedQuad> quad = line_outline(a, b, width, 8);
    ASSERT_TRUE(quad);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const double aside_x = (b.y - a.y) / length * double{width} / 2;
    const double aside_y = -(b.x - a.x) / length * double{width} / 2;
    const auto expect_near = [&](const FixedPosition& corner, const FramebufferPosition& end, double side) {
      EXPECT_LE(std::abs(corner.x_fixed - (end.x + side * aside_x) * 256), 1.01);
      EXPECT_LE(std::abs(corner.y_fixed - (end.y + side * aside_y) * 256), 1.01);
    };
    expect_near((*quad)[0], a, -1);
    expect_near((*quad)[1], b, -1);
    expect_near((*quad)[2], b, 1);
    expect_near((*quad)[3], a, 1);
    // A parallelogram without a fold, always the same way round.
    EXPECT_LE(doubled_area((*quad)[0], (*quad)[1], (*quad)[2]), 0);
  }
}

}  // namespace
}  // namespace fillrule::renderer
