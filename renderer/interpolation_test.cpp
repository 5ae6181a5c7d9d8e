#include "renderer/interpolation.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "renderer/isa.h"
#include "renderer/row_weights.h"
#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

struct Vertex {
  double x_framebuffer;
  double y_framebuffer;
  double w;
};

// Barycentric coordinates by areas, w > 0: the formulae of the specification, term by term.
std::array<double, 3> window_barycentrics(const std::array<Vertex, 3>& v, double x, double y) {
  const auto area = [](double ax, double ay, double bx, double by, double cx, double cy) {
    return (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
  };
  const double whole = area(v[0].x_framebuffer, v[0].y_framebuffer, v[1].x_framebuffer, v[1].y_framebuffer,
                            v[2].x_framebuffer, v[2].y_framebuffer);
  return {area(x, y, v[1].x_framebuffer, v[1].y_framebuffer, v[2].x_framebuffer, v[2].y_framebuffer) / whole,
          area(v[0].x_framebuffer, v[0].y_framebuffer, x, y, v[2].x_framebuffer, v[2].y_framebuffer) / whole,
          area(v[0].x_framebuffer, v[0].y_framebuffer, v[1].x_framebuffer, v[1].y_framebuffer, x, y) / whole};
}

// A row's values, pixel by pixel.
struct Row {
  bool is_plausible = false;
  bool is_finite = false;
  std::array<std::array<double, kBlockSize>, 3> smooth{};
  std::array<std::array<double, kBlockSize>, 3> noperspective{};
  std::array<float, kBlockSize> values{};
};

Row row_of(Isa isa, const PrimitiveInterpolation& planes, int32_t x, int32_t y,
           const std::array<float, 3>& vertices) {
  Row row;
  dispatch(
      isa, [&]<typename L>() __attribute__((always_inline)) {
        const RowWeights<L> weights(planes, x, y);
        row.is_plausible = weights.are_plausible();
        RowOfValues<L> values;
        row.is_finite = interpolate_row<L>(vertices[0], vertices[1], vertices[2], weights.smooth(), values);
        for (size_t i = 0; i < kRowVectors<L>; ++i) {
          L::store(values[i], row.values.data() + i * L::kWidth);
          for (size_t v = 0; v < 3; ++v) {
            L::store(weights.smooth()[v][i], row.smooth[v].data() + i * L::kWidth);
            L::store(weights.noperspective()[v][i], row.noperspective[v].data() + i * L::kWidth);
          }
        }
      });
  return row;
}

// Planes of any kind: rows that begin inside, beside and behind a primitive.
TEST(RowWeights, AreThoseOfItsPixelsToTheBit) {
  SeededRandom random;
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    SCOPED_TRACE(to_string(isa));
    size_t plausible_rows = 0;
    size_t other_rows = 0;
    for (int i = 0; i < 2000; ++i) {
      PrimitiveInterpolation planes{.anchor_x = 5, .anchor_y = -3};
      for (size_t v = 0; v < 3; ++v) {
        planes.per_w[v] = {random.uniform(0, 1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
        planes.w[v] = random.uniform(0.5, 4);
      }
      const auto x = static_cast<int32_t>(random.uniform(-4, 10));
      const auto y = static_cast<int32_t>(random.uniform(-8, 4));
      const Row row = row_of(isa, planes, x, y, {1.5F, -2, 0.25F});
      bool is_plausible = true;
      for (int32_t pixel = 0; pixel < kBlockSize; ++pixel) {
        double greatest = 0;
        for (const WindowPlane& plane : planes.per_w) {
          greatest = std::max(greatest, std::abs(plane.at(x + pixel - planes.anchor_x, y - planes.anchor_y)));
        }
        is_plausible = is_plausible && greatest <= 2 * planes.reciprocal_w_at(x + pixel, y);
      }
      ASSERT_EQ(row.is_plausible, is_plausible);
      (is_plausible ? plausible_rows : other_rows) += 1;
      if (!is_plausible) continue;
      ASSERT_TRUE(row.is_finite);
      for (int32_t pixel = 0; pixel < kBlockSize; ++pixel) {
        const PixelWeights weights = planes.weights_at(x + pixel, y);
        const auto column = static_cast<size_t>(pixel);
        EXPECT_EQ(row.values[column], interpolate(1.5F, -2, 0.25F, weights.smooth));
        for (size_t v = 0; v < 3; ++v) {
          EXPECT_EQ(row.smooth[v][column], weights.smooth[v]);
          EXPECT_EQ(row.noperspective[v][column], weights.noperspective[v]);
        }
      }
    }
    EXPECT_GT(plausible_rows, 100U);
    EXPECT_GT(other_rows, 100U);
  }
}

// One of a row's pixels beyond the greatest float.
TEST(RowWeights, TellOfInfiniteValues) {
  PrimitiveInterpolation planes{.w = {1, 1, 1}};
  planes.per_w[0] = {.at_anchor = 1, .step_x = 0.125};
  planes.per_w[1] = {.at_anchor = 0, .step_x = -0.125};
  for (const Isa isa : kAllIsas) {
    if (!is_supported(isa)) continue;
    EXPECT_TRUE(row_of(isa, planes, 0, 0, {1.8e38F, 0, 0}).is_finite) << to_string(isa);
    EXPECT_FALSE(row_of(isa, planes, 0, 0, {1.82e38F, 0, 0}).is_finite) << to_string(isa);
    EXPECT_FALSE(row_of(isa, planes, 0, 0, {-1.82e38F, 0, 0}).is_finite) << to_string(isa);
  }
}

TEST(Interpolation, AgreesWithTheFormulaeOfTheSpecification) {
  SeededRandom random;
  size_t compared = 0;
  for (int i = 0; i < 200; ++i) {
    TestScene scene(64, 64);
    scene.state.depth_test = true;
    std::array<Vertex, 3> vertices{};
    std::array<double, 3> z{};
    for (size_t k = 0; k < 3; ++k) {
      // From the very floats that are drawn.
      const ClipPosition position = scene.at(random.uniform(0, 64), random.uniform(0, 64), random.uniform(0.1, 0.9),
                                             std::exp2(random.uniform(0, 5)));
      const double w = position[3];
      vertices[k] = {(position[0] / w + 1) * 32, (position[1] / w + 1) * 32, w};
      z[k] = position[2] / w;
      scene.positions.push_back(position);
      scene.values.push_back(static_cast<float>(random.uniform(-10, 10)));
    }
    const TestPlanes planes = render(scene);
    for (uint32_t y = 0; y < 64; ++y) {
      for (uint32_t x = 0; x < 64; ++x) {
        const size_t pixel = planes.pixel(x, y);
        const std::array<double, 3> b = window_barycentrics(vertices, x + 0.5, y + 0.5);
        // Beside slivers' edges the pixel may be outside of the unsnapped triangle.
        if (planes.hits[pixel] == 0 || *std::min_element(b.begin(), b.end()) < 0) {
          continue;
        }
        ++compared;
        double noperspective = 0;
        double depth = 0;
        double over_w = 0;
        double reciprocal_w = 0;
        for (size_t k = 0; k < 3; ++k) {
          noperspective += b[k] * double{scene.values[k]};
          depth += b[k] * z[k];
          over_w += b[k] * double{scene.values[k]} / vertices[k].w;
          reciprocal_w += b[k] / vertices[k].w;
        }
        // Half an ULP of float32 at 10, and some double slack for thin triangles.
        ASSERT_NEAR(planes.noperspective[pixel], noperspective, 0x1p-21 + 1e-9);
        ASSERT_NEAR(planes.smooth[pixel], over_w / reciprocal_w, 0x1p-21 + 1e-9);
        ASSERT_NEAR(planes.depth[pixel], depth, 0x1p-25 + 1e-9);
      }
    }
  }
  EXPECT_GT(compared, 10000U);
}

// A plane through the eye's side and beyond: v = (x, y, w) is linear in clip space, so any varying that is linear in
// it is known at every pixel, whichever vertices are behind the eye.
TEST(Interpolation, VerticesBehindTheEye) {
  TestScene scene(64, 64);
  scene.positions = {{-4, -1, 0.5F, 1}, {4, -1, 0.5F, 1}, {0, 3, -0.5F, -1}};
  for (const ClipPosition& position : scene.positions) {
    scene.values.push_back(2 * position[0] + 3 * position[1] - 5 * position[3]);
  }
  const TestPlanes planes = render(scene);
  size_t compared = 0;
  for (uint32_t y = 0; y < 64; ++y) {
    for (uint32_t x = 0; x < 64; ++x) {
      const size_t pixel = planes.pixel(x, y);
      if (planes.hits[pixel] != 0) {
        ++compared;
        // The triangle lies in the plane y = 1 - 2w.
        const double x_ndc = (x + 0.5) / 32 - 1;
        const double y_ndc = (y + 0.5) / 32 - 1;
        const double w = 1 / (y_ndc + 2);
        ASSERT_NEAR(planes.smooth[pixel], w * (2 * x_ndc + 3 * y_ndc - 5), 1e-6);
      }
    }
  }
  EXPECT_GT(compared, 1000U);
}

TEST(Interpolation, AConstantVaryingIsConstantToTheBit) {
  SeededRandom random;
  TestScene scene(64, 64);
  for (int i = 0; i < 300; ++i) {
    const double w = std::exp2(random.uniform(-10, 10));
    scene.positions.push_back(scene.at(random.uniform(-80, 140), random.uniform(-80, 140), 0.5, w));
  }
  scene.values.assign(scene.positions.size(), 0.7F);
  const TestPlanes planes = render(scene);
  for (size_t pixel = 0; pixel < planes.hits.size(); ++pixel) {
    if (planes.hits[pixel] != 0) {
      ASSERT_EQ(planes.smooth[pixel], 0.7F);
      ASSERT_EQ(planes.noperspective[pixel], 0.7F);
    }
  }
}

TEST(Interpolation, FlatKeepsTheBitsOfTheProvokingVertex) {
  const auto nan_payload = std::bit_cast<float>(0x7FC12345U);
  struct Row {
    VkPrimitiveTopology topology;
    std::array<uint32_t, 2> provoking;
  };
  for (const Row& row :
       {Row{VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, {0, 3}}, Row{VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, {0, 1}},
        Row{VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN, {1, 2}}}) {
    for (uint32_t primitive = 0; primitive < 2; ++primitive) {
      TestScene scene(16, 16);
      scene.topology = row.topology;
      scene.positions = {scene.at(0, 0), scene.at(16, 0), scene.at(0, 16), scene.at(16, 16)};
      if (row.topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST) {
        scene.positions = {scene.at(0, 0),  scene.at(16, 0), scene.at(0, 16),
                           scene.at(16, 0), scene.at(0, 16), scene.at(16, 16)};
      }
      scene.values.assign(scene.positions.size(), 1.0F);
      scene.values[row.provoking[primitive]] = nan_payload;
      const TestPlanes planes = render(scene);
      size_t owned = 0;
      for (size_t pixel = 0; pixel < planes.hits.size(); ++pixel) {
        if (planes.owner[pixel] == primitive) {
          ++owned;
          ASSERT_EQ(std::bit_cast<uint32_t>(planes.flat[pixel]), 0x7FC12345U);
        }
      }
      EXPECT_GT(owned, 50U);
    }
  }
}

constexpr VkViewport kViewport{.width = 64, .height = 64, .maxDepth = 1};

TEST(Interpolation, ATriangleOnALineHasTheValuesOfItsFirstVisibleVertex) {
  std::array<ClipPosition, 3> positions = {{{-0.5F, -0.5F, 0.25F, 1}, {0, 0, 1, 2}, {0.5F, 0.5F, 0.75F, 1}}};
  PrimitiveInterpolation interpolation = make_interpolation(kViewport, {}, positions, 20, 20);
  EXPECT_EQ(interpolation.depth_at(40, 40), 0.25);
  EXPECT_EQ(interpolation.weights_at(40, 40).smooth, (VertexWeights{1, 0, 0}));
  EXPECT_EQ(interpolation.weights_at(40, 40).noperspective, (VertexWeights{1, 0, 0}));
  positions[0][3] = -1;
  positions[0][0] = 0.5F;
  positions[0][1] = 0.5F;
  interpolation = make_interpolation(kViewport, {}, positions, 20, 20);
  EXPECT_EQ(interpolation.depth_at(40, 40), 0.5);
  EXPECT_EQ(interpolation.weights_at(40, 40).smooth, (VertexWeights{0, 1, 0}));
}

TEST(Interpolation, FarOutsideOfTheTriangleSmoothWeightsStayBounded) {
  const std::array<ClipPosition, 3> positions = {{{-0.5F, -0.5F, 0.25F, 1}, {1, -1, 1, 2}, {-2, 2, 0.75F, 4}}};
  const PrimitiveInterpolation interpolation = make_interpolation(kViewport, {}, positions, 20, 20);
  // 1/w = 0 is crossed among these.
  for (int32_t i = -4000; i < 4000; i += 7) {
    const PixelWeights weights = interpolation.weights_at(i, i / 2);
    for (size_t vertex = 0; vertex < 3; ++vertex) {
      ASSERT_LE(std::abs(weights.smooth[vertex]), 2) << i;
      ASSERT_TRUE(std::isfinite(weights.noperspective[vertex])) << i;
    }
  }
}

TEST(Interpolation, ATriangleThinnerThanTheSnapHasTheValuesOfItsVertices) {
  TestScene scene(64, 64);
  scene.state.depth_test = true;
  // On one line, but snapping opens them: the third vertex is a tie away from the line through the others.
  SeededRandom random;
  size_t covered = 0;
  for (int i = 0; i < 9000; ++i) {  // of 3000, one seed in a thousand had no more than 20 pixels covered
    scene.positions.clear();
    const double x0 = random.uniform(0, 64);
    const double y0 = random.uniform(0, 64);
    const double dx = random.uniform(-64, 64);
    const double dy = random.uniform(-64, 64);
    for (const double t : {0.0, 0.5, 1.0}) {
      scene.positions.push_back(scene.at(x0 + t * dx, y0 + t * dy, 0.5, std::exp2(random.uniform(-3, 3))));
    }
    scene.values = {1, 2, 3};
    const TestPlanes planes = render(scene);
    for (size_t pixel = 0; pixel < planes.hits.size(); ++pixel) {
      if (planes.hits[pixel] != 0) {
        ++covered;
        ASSERT_TRUE(planes.smooth[pixel] >= -20 && planes.smooth[pixel] <= 20) << planes.smooth[pixel];
        ASSERT_TRUE(std::isfinite(planes.noperspective[pixel]));
        ASSERT_TRUE(planes.depth[pixel] >= 0 && planes.depth[pixel] <= 1);
      }
    }
  }
  EXPECT_GT(covered, 20U);
}

// A vertex 2^40 times as far away as the others has weights that 1 less the others' could not hold.
TEST(Interpolation, ASmallWeightKeepsItsDigits) {
  const float far = 0x1p40F;
  const std::array<ClipPosition, 3> positions = {{{-far, -far, 0, far}, {1, -1, 0, 1}, {-1, 1, 0, 1}}};
  const PrimitiveInterpolation interpolation = make_interpolation(kViewport, {}, positions, 32, 32);
  // The window barycentric coordinates at the centre of pixel (16, 16), and from them the weight of vertex 0.
  const double b1 = 16.5 / 64;
  const double b0 = 1 - 2 * b1;
  const double expected = b0 / double{far} / (b0 / double{far} + 2 * b1);
  EXPECT_NEAR(interpolation.weights_at(16, 16).smooth[0] / expected, 1, 1e-14);
}

TEST(Interpolation, FiniteValuesNeverBecomeInfinite) {
  const float huge = std::numeric_limits<float>::max();
  EXPECT_EQ(interpolate(huge, huge, -huge, {0.25, 1, -0.25}), huge);
  EXPECT_EQ(interpolate(-huge, huge, huge, {2, -0.5, -0.5}), -huge);
}

}  // namespace
}  // namespace fillrule::renderer
