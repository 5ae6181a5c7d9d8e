// Lines, points and outlined polygons through the whole pipeline.
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

using Pixel = std::pair<uint32_t, uint32_t>;

std::vector<Pixel> pixels_of(const TestPlanes& planes) {
  std::vector<Pixel> pixels;
  for (size_t i = 0; i < planes.hits.size(); i += planes.samples) {
    if (planes.hits[i] != 0) {
      const auto pixel = static_cast<uint32_t>(i / planes.samples);
      pixels.emplace_back(pixel % planes.width, pixel / planes.width);
    }
  }
  return pixels;
}

std::vector<Pixel> rectangle(uint32_t left, uint32_t top, uint32_t right, uint32_t bottom) {
  std::vector<Pixel> pixels;
  for (uint32_t y = top; y < bottom; ++y) {
    for (uint32_t x = left; x < right; ++x) {
      pixels.emplace_back(x, y);
    }
  }
  return pixels;
}

TestScene lines(VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_LINE_LIST) {
  TestScene scene(64, 64);
  scene.topology = topology;
  return scene;
}

TestScene points() {
  return lines(VK_PRIMITIVE_TOPOLOGY_POINT_LIST);
}

TEST(Lines, AreRectanglesOfTheirWidth) {
  TestScene scene = lines();
  scene.positions = {scene.at(4, 10), scene.at(12, 10)};
  scene.state.line_width = 4;
  EXPECT_EQ(pixels_of(render(scene)), rectangle(4, 8, 12, 12));
  scene.positions = {scene.at(10, 12), scene.at(10, 4)};
  EXPECT_EQ(pixels_of(render(scene)), rectangle(8, 4, 12, 12));
  // One pixel wide, on a row of centres: the top edge is on the row's top border.
  scene.state.line_width = 1;
  scene.positions = {scene.at(4.5, 10.5), scene.at(12.5, 10.5)};
  EXPECT_EQ(pixels_of(render(scene)), rectangle(4, 10, 12, 11));
  // Without length nothing is drawn, but it counts.
  scene.positions = {scene.at(4, 4), scene.at(4, 4), scene.at(4, 10), scene.at(12, 10)};
  EXPECT_EQ(count_of(render(scene).owner, 1), 8U);
}

TEST(Lines, BothFillsDrawThemAlike) {
  SeededRandom random;
  for (const uint32_t samples : {1U, 4U}) {
    TestScene scene = lines();
    scene.samples = samples;
    scene.state.line_width = 3.5F;
    for (int i = 0; i < 200; ++i) {
      scene.positions.push_back(scene.at(random.uniform(-10, 74), random.uniform(-10, 74)));
    }
    EXPECT_TRUE(same_bytes(render(scene, {.fill = Fill::kScanline}), render(scene)));
  }
}

TEST(Lines, ValuesAreThoseOfTheNearestPointOfTheLine) {
  SeededRandom random;
  for (int i = 0; i < 300; ++i) {
    TestScene scene = lines();
    scene.state.line_width = 5;
    scene.state.depth_test = true;
    const double x0 = random.uniform(5, 59);
    const double y0 = random.uniform(5, 59);
    const double x1 = random.uniform(5, 59);
    const double y1 = random.uniform(5, 59);
    const double length = std::hypot(x1 - x0, y1 - y0);
    if (length < 4) {
      continue;
    }
    const double w0 = random.uniform(0.5, 4);
    const double w1 = random.uniform(0.5, 4);
    scene.positions = {scene.at(x0, y0, 0.25, w0), scene.at(x1, y1, 0.75, w1)};
    scene.values = {-3, 5};
    const TestPlanes planes = render(scene);
    ASSERT_GT(pixels_of(planes).size(), 15U);
    for (const auto& [x, y] : pixels_of(planes)) {
      const double t = ((x + 0.5 - x0) * (x1 - x0) + (y + 0.5 - y0) * (y1 - y0)) / (length * length);
      const double smooth = ((1 - t) / w0 * -3 + t / w1 * 5) / ((1 - t) / w0 + t / w1);
      const size_t pixel = planes.pixel(x, y);
      ASSERT_NEAR(planes.noperspective[pixel], -3 + 8 * t, 1e-4);
      ASSERT_NEAR(planes.smooth[pixel], smooth, 1e-4);
      ASSERT_NEAR(planes.depth[pixel], 0.25 + 0.5 * t, 1e-5);
      ASSERT_EQ(planes.flat[pixel], -3);
      ASSERT_EQ(planes.front_facing[pixel], 1U);
    }
  }
}

TEST(Lines, AStripIsTheSumOfItsSegmentsAndTheProvokingVertexMayBeTheLast) {
  TestScene strip = lines(VK_PRIMITIVE_TOPOLOGY_LINE_STRIP);
  strip.positions = {strip.at(4, 10), strip.at(30, 14), strip.at(34, 50), strip.at(6, 40)};
  strip.values = {1, 2, 3, 4};
  TestScene list = lines();
  list.positions = {strip.positions[0], strip.positions[1], strip.positions[1],
                    strip.positions[2], strip.positions[2], strip.positions[3]};
  list.values = {1, 2, 2, 3, 3, 4};
  for (const auto mode : {VK_PROVOKING_VERTEX_MODE_FIRST_VERTEX_EXT, VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT}) {
    strip.state.provoking_vertex = list.state.provoking_vertex = mode;
    const TestPlanes planes = render(strip);
    EXPECT_TRUE(same_bytes(planes, render(list)));
    const bool is_last = mode == VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
    const size_t pixel = planes.pixel(16, 11);
    ASSERT_EQ(planes.owner[pixel], 0U);
    EXPECT_EQ(planes.flat[pixel], is_last ? 2 : 1);
    EXPECT_NEAR(planes.noperspective[pixel], 1 + 12.5 / 26, 0.05);
  }
}

TEST(Lines, AreCutAtTheViewVolumeAndKeepTheirValues) {
  TestScene scene = lines();
  // From x = -32 to 96, through z = -0.5 to 1.5, behind and before the viewport alike.
  scene.positions = {scene.at(-32, 20.5, -0.5), scene.at(96, 20.5, 1.5)};
  scene.values = {0, 128};
  scene.state.depth_test = true;
  scene.state.depth_compare = VK_COMPARE_OP_ALWAYS;
  const TestPlanes planes = render(scene);
  // z in [0, 1] is the quarter to three quarters: just the viewport.
  EXPECT_EQ(pixels_of(planes), rectangle(0, 20, 64, 21));
  EXPECT_NEAR(planes.noperspective[planes.pixel(10, 20)], 42.5, 1e-4);
  EXPECT_NEAR(planes.depth[planes.pixel(10, 20)], -0.5 + 2 * 42.5 / 128, 1e-6);
  // Half of the depth range: half of the line.
  scene.positions = {scene.at(0, 20.5, 0.5), scene.at(64, 20.5, 1.5)};
  EXPECT_EQ(pixels_of(render(scene)), rectangle(0, 20, 32, 21));
  scene.state.depth_clip = false;
  EXPECT_EQ(pixels_of(render(scene)), rectangle(0, 20, 64, 21));
  scene.state.depth_clip = true;
  scene.state.negative_one_to_one = true;
  scene.positions = {scene.at(0, 20.5, -2), scene.at(64, 20.5, 0)};
  EXPECT_EQ(pixels_of(render(scene)), rectangle(32, 20, 64, 21));
}

TEST(Lines, WithAnEndBehindTheEyeShowThePartBeforeIt) {
  TestScene scene = lines();
  // Clip space x = -0.5 + 4.5 t, w = 1 - 2 t: w = x at t = 1.5 / 6.5, framebuffer x from 16 on.
  scene.positions = {{-0.5F, 0, 0.25F, 1}, {4, 0, 0.25F, -1}};
  scene.values = {1, 2};
  scene.state.line_width = 2;
  const TestPlanes planes = render(scene);
  EXPECT_EQ(pixels_of(planes), rectangle(16, 31, 64, 33));
  const double x_ndc = (40.5 - 32) / 32;
  const double t = (x_ndc + 0.5) / (4.5 + 2 * x_ndc);
  EXPECT_NEAR(planes.smooth[planes.pixel(40, 31)], 1 + t, 1e-6);
}

TEST(Lines, WithoutFiniteEndsAreDropped) {
  TestScene scene = lines();
  for (const float bad : {INFINITY, -INFINITY, NAN}) {
    scene.positions = {scene.at(4, 10), {bad, 0, 0.5F, 1}, {0, 0, 0.5F, bad}, scene.at(4, 10)};
    EXPECT_EQ(count_of(render(scene).hits, 0), 64U * 64U);
  }
}

TEST(BresenhamLines, CoverAllSamplesOfTheirPixels) {
  SeededRandom random;
  TestScene scene = lines(VK_PRIMITIVE_TOPOLOGY_LINE_STRIP);
  scene.state.line_mode = VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT;
  for (int i = 0; i < 40; ++i) {
    scene.positions.push_back(scene.at(random.uniform(-10, 74), random.uniform(-10, 74)));
  }
  const TestPlanes single = render(scene);
  EXPECT_GT(pixels_of(single).size(), 100U);
  scene.samples = 8;
  const TestPlanes planes = render(scene);
  for (size_t i = 0; i < planes.hits.size(); ++i) {
    ASSERT_EQ(planes.hits[i], single.hits[i / 8]);
    ASSERT_EQ(planes.owner[i], single.owner[i / 8]);
  }
}

TEST(BresenhamLines, ValuesGoAlongTheMajorDirection) {
  TestScene scene = lines();
  scene.state.line_mode = VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT;
  scene.state.line_width = 3;
  scene.positions = {scene.at(10.5, 10.5), scene.at(42.5, 26.5)};
  scene.values = {0, 32};
  TestPlanes planes = render(scene);
  EXPECT_EQ(pixels_of(planes).size(), 32U * 3);
  for (const auto& [x, y] : pixels_of(planes)) {
    ASSERT_NEAR(planes.noperspective[planes.pixel(x, y)], x - 10.0, 1e-4);
  }
  scene.positions = {scene.at(10.5, 10.5), scene.at(26.5, 42.5)};
  planes = render(scene);
  for (const auto& [x, y] : pixels_of(planes)) {
    ASSERT_NEAR(planes.noperspective[planes.pixel(x, y)], y - 10.0, 1e-4);
  }
}

TEST(BresenhamLines, OfAStripDoNotShareTheirJoints) {
  TestScene scene = lines(VK_PRIMITIVE_TOPOLOGY_LINE_STRIP);
  scene.state.line_mode = VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT;
  for (const double x : {5.5, 11.25, 17.0, 30.875, 44.5}) {
    scene.positions.push_back(scene.at(x, 20.5));
  }
  for (const bool reversed : {false, true}) {
    const TestPlanes planes = render(scene);
    EXPECT_EQ(pixels_of(planes).size(), 39U);
    EXPECT_EQ(count_of(planes.hits, 1), 39U);
    EXPECT_EQ(planes.hits[planes.pixel(5, 20)], reversed ? 0U : 1U);
    std::reverse(scene.positions.begin(), scene.positions.end());
  }
}

TEST(Points, AreSquaresOfTheirSize) {
  TestScene scene = points();
  scene.positions = {scene.at(10, 20), scene.at(30.5, 40.5), scene.at(50, 50)};
  EXPECT_EQ(count_of(render(scene).hits, 1), 3U);
  scene.point_sizes = {4, 3, 0.5F};
  const TestPlanes planes = render(scene);
  for (uint32_t y = 0; y < 64; ++y) {
    for (uint32_t x = 0; x < 64; ++x) {
      const bool first = x >= 8 && x < 12 && y >= 18 && y < 22;
      const bool second = x >= 29 && x < 32 && y >= 39 && y < 42;
      const bool third = x == 49 && y == 49;  // a size below 1 is 1: (49.5, 49.5) is its left top corner
      const size_t pixel = planes.pixel(x, y);
      ASSERT_EQ(planes.hits[pixel] != 0, first || second || third) << x << ", " << y;
      ASSERT_EQ(planes.owner[pixel], first ? 0 : (second ? 1 : (third ? 2 : kNobody)));
    }
  }
}

TEST(Points, HaveTheValuesOfTheirVertexAndCoordinatesOfTheirOwn) {
  TestScene scene = points();
  scene.positions = {scene.at(10.25, 20.75, 0.625, 3)};
  scene.values = {7};
  scene.point_sizes = {8};
  scene.state.depth_test = true;
  const TestPlanes planes = render(scene);
  EXPECT_EQ(pixels_of(planes), rectangle(6, 17, 14, 25));
  for (const auto& [x, y] : pixels_of(planes)) {
    const size_t pixel = planes.pixel(x, y);
    ASSERT_EQ(planes.smooth[pixel], 7);
    ASSERT_EQ(planes.noperspective[pixel], 7);
    ASSERT_EQ(planes.flat[pixel], 7);
    ASSERT_NEAR(planes.depth[pixel], 0.625, 1e-7);
    ASSERT_NEAR(planes.point_s[pixel], 0.5 + (x + 0.5 - 10.25) / 8, 1e-6);
    ASSERT_NEAR(planes.point_t[pixel], 0.5 + (y + 0.5 - 20.75) / 8, 1e-6);
    ASSERT_EQ(planes.front_facing[pixel], 1U);
  }
}

TEST(Points, AreCutAtTheViewportAndVanishWithTheirCentre) {
  TestScene scene = points();
  scene.state.viewport = {16, 16, 32, 32, 0, 1};
  const auto at = [](float x, float y, float z) { return ClipPosition{x, y, z, 1}; };
  scene.point_sizes = {10};
  scene.positions = {at(-1, -1, 0)};
  EXPECT_EQ(pixels_of(render(scene)), rectangle(16, 16, 21, 21));
  scene.positions = {at(1, 1, 1)};
  EXPECT_EQ(pixels_of(render(scene)), rectangle(43, 43, 48, 48));
  for (const ClipPosition& outside : {at(-1.01F, 0, 0.5F), at(0, 1.01F, 0.5F), at(0, 0, -0.01F), at(0, 0, 1.01F),
                                      ClipPosition{0, 0, 0, -1}, ClipPosition{0, 0, 0, 0}, at(NAN, 0, 0.5F)}) {
    scene.positions = {outside};
    EXPECT_EQ(count_of(render(scene).hits, 0), 64U * 64U);
  }
}

TestScene outlined(VkPolygonMode mode) {
  TestScene scene(64, 64);
  scene.state.polygon_mode = mode;
  scene.positions = {scene.at(8, 8, 0.25), scene.at(50, 12, 0.5), scene.at(20, 44, 0.75)};
  scene.values = {1, 2, 4};
  return scene;
}

TEST(OutlinedPolygons, AreTheirThreeEdges) {
  const TestScene scene = outlined(VK_POLYGON_MODE_LINE);
  const TestPlanes planes = render(scene);
  TestScene edges = lines();
  for (const size_t i : {0U, 1U, 1U, 2U, 2U, 0U}) {
    edges.positions.push_back(scene.positions[i]);
    edges.values.push_back(scene.values[i]);
  }
  const TestPlanes expected = render(edges);
  EXPECT_EQ(planes.hits, expected.hits);
  EXPECT_TRUE(same_bytes(planes.smooth, expected.smooth));
  EXPECT_TRUE(same_bytes(planes.noperspective, expected.noperspective));
  // One primitive, and the flat value of the polygon's provoking vertex.
  for (const auto& [x, y] : pixels_of(planes)) {
    ASSERT_EQ(planes.owner[planes.pixel(x, y)], 0U);
    ASSERT_EQ(planes.flat[planes.pixel(x, y)], 1);
  }
}

TEST(OutlinedPolygons, AreTheirCorners) {
  TestScene scene = outlined(VK_POLYGON_MODE_POINT);
  scene.point_sizes = {2, 4, 6};
  const TestPlanes planes = render(scene);
  EXPECT_EQ(count_of(planes.hits, 1), 4U + 16U + 36U);
  EXPECT_EQ(planes.smooth[planes.pixel(50, 12)], 2);
  EXPECT_EQ(planes.flat[planes.pixel(50, 12)], 1);
  EXPECT_EQ(count_of(planes.owner, 0), 4U + 16U + 36U);
}

TEST(OutlinedPolygons, HaveTheFacingAndTheCullingOfThePolygon) {
  for (const auto mode : {VK_POLYGON_MODE_LINE, VK_POLYGON_MODE_POINT}) {
    TestScene scene = outlined(mode);
    const uint32_t facing = [&] {
      TestScene filled = scene;
      filled.state.polygon_mode = VK_POLYGON_MODE_FILL;
      const TestPlanes planes = render(filled);
      return planes.front_facing[planes.pixel(20, 20)];
    }();
    TestPlanes planes = render(scene);
    for (const auto& [x, y] : pixels_of(planes)) {
      ASSERT_EQ(planes.front_facing[planes.pixel(x, y)], facing);
    }
    scene.state.cull_mode = facing == 1 ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_BACK_BIT;
    EXPECT_TRUE(pixels_of(render(scene)).empty());
    scene.state.cull_mode = facing == 1 ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_FRONT_BIT;
    EXPECT_EQ(pixels_of(render(scene)), pixels_of(planes));
    // Without area it is back-facing, and its edges are still there.
    scene.positions[2] = scene.positions[1];
    scene.state.cull_mode = VK_CULL_MODE_FRONT_BIT;
    EXPECT_FALSE(pixels_of(render(scene)).empty());
    scene.state.cull_mode = VK_CULL_MODE_BACK_BIT;
    EXPECT_TRUE(pixels_of(render(scene)).empty());
  }
}

TEST(OutlinedPolygons, ClippingMakesNoEdges) {
  TestScene scene = outlined(VK_POLYGON_MODE_LINE);
  // The third vertex is beyond the far plane, which cuts the polygon.
  scene.positions[2] = scene.at(20, 44, 1.75);
  const TestPlanes planes = render(scene);
  TestScene edges = lines();
  for (const size_t i : {0U, 1U, 1U, 2U, 2U, 0U}) {
    edges.positions.push_back(scene.positions[i]);
  }
  EXPECT_EQ(planes.hits, render(edges).hits);
  scene.state.polygon_mode = VK_POLYGON_MODE_POINT;
  EXPECT_EQ(count_of(render(scene).hits, 1), 2U);
}

TEST(OutlinedPolygons, AreBiasedAsThePolygonIs) {
  for (const auto mode : {VK_POLYGON_MODE_LINE, VK_POLYGON_MODE_POINT}) {
    TestScene scene = outlined(mode);
    scene.state.depth_test = true;
    const TestPlanes planes = render(scene);
    // dz/dx = 0.25 / 42 less 4 / 42 of dz/dy; the slope is that of the polygon wherever the line goes.
    scene.state.depth_bias = {.slope_factor = 4};
    const TestPlanes biased = render(scene);
    const double dx1 = 42;
    const double dy1 = 4;
    const double dx2 = 12;
    const double dy2 = 36;
    const double area = dx1 * dy2 - dx2 * dy1;
    const double slope_x = (0.25 * dy2 - 0.5 * dy1) / area;
    const double slope_y = (0.5 * dx1 - 0.25 * dx2) / area;
    for (const auto& [x, y] : pixels_of(planes)) {
      const size_t pixel = planes.pixel(x, y);
      ASSERT_NEAR(biased.depth[pixel] - planes.depth[pixel], 4 * std::max(slope_x, slope_y), 1e-6);
    }
  }
  TestScene scene = lines();
  scene.state.depth_test = true;
  scene.positions = {scene.at(4, 10, 0.25), scene.at(12, 10, 0.5)};
  const TestPlanes planes = render(scene);
  scene.state.depth_bias = {.constant_factor = 100, .slope_factor = 4};
  EXPECT_EQ(render(scene).depth, planes.depth);
}

TEST(LinesAndPoints, AreCutAtTheUsersClipDistances) {
  TestScene scene = lines();
  scene.positions = {scene.at(8, 20.5), scene.at(40, 20.5), scene.at(8, 30.5), scene.at(40, 30.5)};
  // Two distances a vertex: the first line is kept from a quarter to three quarters, the second not at all.
  scene.clip_distances = {-1, 3, 3, -1, 1, -1, 1, -2};
  EXPECT_EQ(pixels_of(render(scene)), rectangle(16, 20, 32, 21));
  scene.clip_distances = {1, 1, 1, NAN, 1, 1, 1, 1};
  EXPECT_EQ(pixels_of(render(scene)), rectangle(8, 30, 40, 31));
  scene.topology = VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
  scene.clip_distances = {0, -1, 5, -1};
  EXPECT_EQ(pixels_of(render(scene)), (std::vector<Pixel>{{7, 20}, {7, 30}}));
}

TEST(LinesAndPoints, AreDroppedByTheUsersCullDistances) {
  TestScene scene = lines();
  scene.positions = {scene.at(8, 20.5), scene.at(40, 20.5), scene.at(8, 30.5), scene.at(40, 30.5)};
  // The first line is outside of the first distance with one end, of the second with the other.
  scene.cull_distances = {-1, 1, 1, -1, -1, 1, -2, 1};
  EXPECT_EQ(pixels_of(render(scene)), rectangle(8, 20, 40, 21));
  // A polygon is dropped as a whole, never an edge or a corner of its own.
  for (const auto mode : {VK_POLYGON_MODE_LINE, VK_POLYGON_MODE_POINT}) {
    TestScene polygon = outlined(mode);
    const TestPlanes planes = render(polygon);
    polygon.cull_distances = {-1, -1, 1};
    EXPECT_TRUE(same_bytes(render(polygon), planes));
    polygon.cull_distances = {-1, -1, -1};
    EXPECT_TRUE(pixels_of(render(polygon)).empty());
  }
}

TEST(LinesAndPoints, AreTheSameForAnyNumberOfThreads) {
  SeededRandom random;
  for (const auto topology :
       {VK_PRIMITIVE_TOPOLOGY_POINT_LIST, VK_PRIMITIVE_TOPOLOGY_LINE_STRIP, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP}) {
    TestScene scene(300, 200);
    scene.topology = topology;
    scene.samples = 4;
    scene.state.depth_test = true;
    scene.state.polygon_mode = VK_POLYGON_MODE_LINE;
    scene.state.line_width = 2.5F;
    for (int i = 0; i < 500; ++i) {
      const auto coordinate = [&](double extent) { return static_cast<float>(random.uniform(-extent, extent)); };
      scene.positions.push_back({coordinate(2), coordinate(2), coordinate(2), coordinate(2)});
      scene.values.push_back(coordinate(1));
      scene.point_sizes.push_back(1 + std::abs(coordinate(20)));
    }
    const TestPlanes planes = render(scene);
    EXPECT_LT(count_of(planes.hits, 0), planes.hits.size());
    EXPECT_TRUE(same_bytes(render(scene, {.threads = 3}), planes));
  }
}

TEST(LinesAndPoints, RefusesWidthsAndSizesThatItCannotDraw) {
  TestScene scene = lines();
  scene.positions = {scene.at(4, 10), scene.at(12, 10)};
  TestPlanes planes = cleared_planes(scene);
  for (const float width : {0.0F, -1.0F, 256.0F, NAN}) {
    scene.state.line_width = width;
    EXPECT_FALSE(render_into(scene, planes));
  }
  scene.state.line_width = 1;
  scene.point_sizes = {1};
  EXPECT_FALSE(render_into(scene, planes));
}

}  // namespace
}  // namespace fillrule::renderer
