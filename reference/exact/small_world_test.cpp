#include "reference/exact/small_world.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "reference/exact/triangle.h"

namespace fillrule::exact {
namespace {

// A viewport large enough for the edges that are extended beyond the cell; positions in pixels from the cell's
// corner, which is its centre. All coordinates are dyadic and short, hence exact in float32.
constexpr float kViewportSize = 16384;
constexpr VkViewport kViewport{.x = -kViewportSize / 2,
                               .y = -kViewportSize / 2,
                               .width = kViewportSize,
                               .height = kViewportSize,
                               .minDepth = 0,
                               .maxDepth = 1};

ClipPosition clip_from_steps(double x, double y, uint32_t grid) {
  const double scale = 2.0 / (double{kViewportSize} * grid);
  return {static_cast<float>(x * scale), static_cast<float>(y * scale), 0.5F, 1.0F};
}

Triangle triangle_of(const SmallWorld& world, const std::array<uint32_t, 3>& numbers, uint32_t grid) {
  std::array<ClipPosition, 3> vertices{};
  for (size_t i = 0; i < 3; ++i) {
    const GridPosition at = world.position(numbers[i]);
    vertices[i] = clip_from_steps(at.x, at.y, grid);
  }
  return {vertices, kViewport};
}

// Of a pixel, in pixels from the cell's corner.
struct Centre {
  double x = 0;
  double y = 0;
};

Centre centre_of(uint32_t pixel, uint32_t size) {
  const uint32_t row = pixel / size;
  return {.x = pixel - row * size + 0.5, .y = row + 0.5};
}

CellMask owned(const Triangle& triangle, uint32_t size) {
  uint32_t mask = 0;
  for (uint32_t pixel = 0; pixel < size * size; ++pixel) {
    const Centre centre = centre_of(pixel, size);
    mask |= (triangle.owns(centre.x, centre.y) ? 1U : 0U) << pixel;
  }
  return static_cast<CellMask>(mask);
}

// Compares with owns(), the winding, and the consistency with must, may and must not.
void expect_as_triangle(const SmallWorld& world, const std::array<uint32_t, 3>& numbers, uint32_t grid,
                        uint32_t size) {
  const Triangle triangle = triangle_of(world, numbers, grid);
  const WoundCoverage coverage = world.coverage(numbers[0], numbers[1], numbers[2]);
  const CellMask either = coverage.clockwise | coverage.counter_clockwise;
  ASSERT_EQ(either, owned(triangle, size)) << numbers[0] << ' ' << numbers[1] << ' ' << numbers[2];
  ASSERT_EQ(triangle.orientation() > 0 ? coverage.counter_clockwise : coverage.clockwise, 0);
  ASSERT_TRUE(triangle.on_grid(4));
  for (uint32_t pixel = 0; pixel < size * size; ++pixel) {
    const Centre centre = centre_of(pixel, size);
    const Coverage answer = triangle.classify(centre.x, centre.y, {0x1p-9, 0x1p-9}).coverage;
    ASSERT_NE(answer, (either >> pixel & 1U) != 0 ? Coverage::kMustNot : Coverage::kMust);
  }
}

// Every directed edge by itself: as the base of a triangle so large that the cell sees of it only this edge.
void expect_every_edge(uint32_t grid, uint32_t size) {
  const SmallWorld world(grid, size);
  const double far = 4.0 * grid * size;
  for (uint32_t a = 0; a < world.positions(); ++a) {
    ASSERT_EQ(world.edge(a, a), 0);
    for (uint32_t b = 0; b < world.positions(); ++b) {
      if (a == b) continue;
      const GridPosition from = world.position(a);
      const GridPosition to = world.position(b);
      const double dx = 1.0 * to.x - from.x;
      const double dy = 1.0 * to.y - from.y;
      const Triangle triangle({clip_from_steps(from.x - far * dx, from.y - far * dy, grid),
                               clip_from_steps(to.x + far * dx, to.y + far * dy, grid),
                               clip_from_steps(from.x - far * dy, from.y + far * dx, grid)},
                              kViewport);
      ASSERT_EQ(triangle.orientation(), 1);
      ASSERT_EQ(world.edge(a, b), owned(triangle, size)) << "from " << a << " to " << b;
    }
  }
}

TEST(SmallWorld, EveryDirectedEdgeIsThatOfATriangle) {
  expect_every_edge(4, 4);
  expect_every_edge(4, 3);
  expect_every_edge(16, 1);
}

TEST(SmallWorld, EveryTriangleOfATinyWorldIsTheOracles) {
  const SmallWorld world(2, 2);
  for (uint32_t a = 0; a < world.positions(); ++a) {
    for (uint32_t b = 0; b < world.positions(); ++b) {
      for (uint32_t c = 0; c < world.positions(); ++c) expect_as_triangle(world, {a, b, c}, 2, 2);
    }
  }
}

TEST(SmallWorld, SamplesOfLargerWorldsAreTheOracles) {
  // NOLINTNEXTLINE(cert-msc32-c,cert-msc51-cpp): the same triangles every time
  std::mt19937 random(3);
  for (const auto& [grid, size] : {std::pair{4U, 4U}, {16U, 2U}, {8U, 3U}, {1U, 4U}}) {
    const SmallWorld world(grid, size);
    std::uniform_int_distribution<uint32_t> number(0, world.positions() - 1);
    for (int i = 0; i < 20'000; ++i) {
      expect_as_triangle(world, {number(random), number(random), number(random)}, grid, size);
    }
  }
}

TEST(SmallWorld, AnEdgeAndItsReverseShareTheCellOut) {
  const SmallWorld world(4, 4);
  for (uint32_t a = 0; a < world.positions(); ++a) {
    for (uint32_t b = 0; b < a; ++b) ASSERT_EQ(world.edge(a, b) ^ world.edge(b, a), 0xFFFF);
  }
}

}  // namespace
}  // namespace fillrule::exact
