// Meshes whose triangles share their vertices: every sample that the mesh covers is hit exactly once, whatever
// happens to the triangles on the way.
#include <numbers>

#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

// The hits of a target in which every pixel is hit once.
std::vector<uint32_t> all_hit_once(size_t width, size_t height) {
  std::vector<uint32_t> hits(width * height, 1);
  return hits;
}

// Two triangles a cell over a grid of columns x rows cells; position(s, t) places the vertex at s, t in [0, 1].
template <typename Position>
void add_grid(TestScene& scene, uint32_t columns, uint32_t rows, const Position& position) {
  for (uint32_t row = 0; row <= rows; ++row) {
    for (uint32_t column = 0; column <= columns; ++column) {
      scene.positions.push_back(position(static_cast<double>(column) / columns, static_cast<double>(row) / rows));
    }
  }
  scene.indices.emplace();
  for (uint32_t row = 0; row < rows; ++row) {
    for (uint32_t column = 0; column < columns; ++column) {
      const uint32_t a = row * (columns + 1) + column;
      const uint32_t c = a + columns + 1;
      // The diagonals alternate, so that edges of every direction meet.
      if ((row + column) % 2 == 0) {
        scene.indices->insert(scene.indices->end(), {a, a + 1, c, a + 1, c + 1, c});
      } else {
        scene.indices->insert(scene.indices->end(), {a, a + 1, c + 1, a, c + 1, c});
      }
    }
  }
}

TEST(Watertight, FullTargetQuad) {
  for (const uint32_t size : {1U, 7U, 64U, 200U}) {
    TestScene scene(size, size + 3);
    scene.positions = {{-1, -1, 0, 1}, {1, -1, 0, 1}, {-1, 1, 0, 1}, {1, -1, 0, 1}, {1, 1, 0, 1}, {-1, 1, 0, 1}};
    EXPECT_EQ(render(scene).hits, all_hit_once(size, size + 3));
  }
}

TEST(Watertight, JitteredGridOnEveryNumberOfSubpixelBits) {
  SeededRandom random;
  for (uint32_t bits = kMinSubpixelBits; bits <= kMaxSubpixelBits; ++bits) {
    for (const uint32_t cells : {3U, 40U, 128U}) {
      TestScene scene(256, 128);
      // Beyond the target's border, where vertices take the other way to their snapped positions. A third of the
      // vertices keeps to pixel centres, where ties are.
      add_grid(scene, cells, cells, [&](double s, double t) {
        const double cell_x = 280.0 / cells;
        const double cell_y = 150.0 / cells;
        // By less than a quarter of a cell no triangle turns over.
        double x = s * 280 - 12 + random.uniform(-0.2, 0.2) * cell_x;
        double y = t * 150 - 11 + random.uniform(-0.2, 0.2) * cell_y;
        if (random.bits() % 3 == 0 && cell_x > 4 && cell_y > 4) {
          x = std::floor(x) + 0.5;
          y = std::floor(y) + 0.5;
        }
        if (cells == 3 && (s == 0 || s == 1 || t == 0 || t == 1)) {
          x = s * 500 - 100;
          y = t * 400 - 100;
        }
        return scene.at(x, y, 0.5, std::exp2(random.uniform(-4, 4)));
      });
      const TestPlanes planes = render(scene, {.subpixel_bits = bits});
      EXPECT_EQ(planes.hits, all_hit_once(256, 128)) << bits << " bits, " << cells << " cells";
    }
  }
}

TEST(Watertight, FanAroundAPixelCentre) {
  SeededRandom random;
  for (const uint32_t spokes : {3U, 4U, 8U, 17U, 100U}) {
    TestScene scene(64, 64);
    scene.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN;
    scene.positions.push_back(scene.at(32.5, 32.5));
    const double start = spokes == 8 ? 0 : random.uniform(0, 6.28);
    for (uint32_t i = 0; i <= spokes; ++i) {
      const double angle = start + 2 * std::numbers::pi * (i % spokes) / spokes;
      scene.positions.push_back(scene.at(32.5 + 200 * std::cos(angle), 32.5 + 200 * std::sin(angle)));
    }
    EXPECT_EQ(render(scene).hits, all_hit_once(64, 64)) << spokes;
  }
}

// A plane seen at an angle, w = 1 + 0.5 y + 0.3 x: it fills the viewport, goes on beyond it, through w = 0 and behind
// the eye. z is a function of w.
template <typename Depth>
TestScene tilted_plane(SeededRandom& random, uint32_t cells, const Depth& depth_of) {
  TestScene scene(128, 128);
  const double jitter = 5.0 / cells;
  add_grid(scene, cells, cells, [&](double s, double t) {
    const double x = -12 + 24 * s + random.uniform(-jitter, jitter);
    const double y = -12 + 24 * t + random.uniform(-jitter, jitter);
    const double w = 1 + 0.5 * y + 0.3 * x;
    return ClipPosition{static_cast<float>(x), static_cast<float>(y), static_cast<float>(depth_of(w)),
                        static_cast<float>(w)};
  });
  return scene;
}

double w_at(uint32_t x, uint32_t y) {
  return 1 / (1 - 0.5 * ((y + 0.5) / 64 - 1) - 0.3 * ((x + 0.5) / 64 - 1));
}

TEST(Watertight, MeshThroughTheEye) {
  SeededRandom random;
  for (const uint32_t cells : {1U, 5U, 40U, 150U}) {
    const TestScene scene = tilted_plane(random, cells, [](double w) { return w / 2; });
    EXPECT_EQ(render(scene).hits, all_hit_once(128, 128)) << cells;
  }
}

TEST(Watertight, MeshCutByTheNearPlane) {
  SeededRandom random;
  for (const uint32_t cells : {1U, 5U, 40U, 150U}) {
    const TestPlanes planes = render(tilted_plane(random, cells, [](double w) { return w - 0.8; }));
    size_t near_the_cut = 0;
    for (uint32_t y = 0; y < 128; ++y) {
      for (uint32_t x = 0; x < 128; ++x) {
        const double margin = w_at(x, y) - 0.8;
        ASSERT_LE(planes.hits[planes.pixel(x, y)], 1U);
        if (std::abs(margin) > 1e-3) {
          ASSERT_EQ(planes.hits[planes.pixel(x, y)], margin > 0 ? 1U : 0U) << x << ", " << y;
        } else {
          ++near_the_cut;
        }
      }
    }
    EXPECT_LT(near_the_cut, 300U);
    EXPECT_GT(count_of(planes.hits, 0), 1000U);
    EXPECT_GT(count_of(planes.hits, 1), 1000U);
  }
}

TEST(Watertight, MeshCutByTheFarPlane) {
  SeededRandom random;
  for (const uint32_t cells : {1U, 5U, 40U, 150U}) {
    // Beyond w = 1.5 the depth is above w.
    const TestPlanes planes = render(tilted_plane(random, cells, [](double w) { return 2 * w - 1.5; }));
    for (uint32_t y = 0; y < 128; ++y) {
      for (uint32_t x = 0; x < 128; ++x) {
        const double w = w_at(x, y);
        ASSERT_LE(planes.hits[planes.pixel(x, y)], 1U);
        if (std::abs(w - 1.5) > 2e-3 && std::abs(w - 0.75) > 2e-3) {
          ASSERT_EQ(planes.hits[planes.pixel(x, y)], w < 1.5 && w > 0.75 ? 1U : 0U) << x << ", " << y;
        }
      }
    }
    EXPECT_GT(count_of(planes.hits, 0), 1000U);
    EXPECT_GT(count_of(planes.hits, 1), 1000U);
  }
}

TEST(Watertight, FanOutToHugeCoordinates) {
  SeededRandom random;
  for (const double radius : {1e4, 1e6, 1e7, 1e20, 1e36}) {
    for (int repetition = 0; repetition < 10; ++repetition) {
      TestScene scene(64, 64);
      scene.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN;
      const double centre_x = repetition == 0 ? 30.5 : random.uniform(0, 64);
      const double centre_y = repetition == 0 ? 20.5 : random.uniform(0, 64);
      scene.positions.push_back(scene.at(centre_x, centre_y));
      const uint32_t spokes = 3 + random.bits() % 20;
      const double start = random.uniform(0, 6.28);
      for (uint32_t i = 0; i <= spokes; ++i) {
        const double angle = start + 2 * std::numbers::pi * (i % spokes) / spokes;
        scene.positions.push_back(scene.at(centre_x + radius * std::cos(angle), centre_y + radius * std::sin(angle)));
      }
      EXPECT_EQ(render(scene).hits, all_hit_once(64, 64)) << radius << ", " << spokes;
    }
  }
}

// A closed surface around the eye, from every direction: nothing is seen twice, and nothing is left out.
TEST(Watertight, InsideOfASphere) {
  SeededRandom random;
  for (int repetition = 0; repetition < 10; ++repetition) {
    TestScene scene(128, 128);
    const double turn = random.uniform(0, 6.28);
    const double tilt = random.uniform(0, 6.28);
    const auto rings = 3 + random.bits() % 12;
    const auto sectors = 3 + random.bits() % 12;
    add_grid(scene, sectors, rings, [&](double s, double t) {
      // The poles and the seam must be the same vertices to the bit.
      const double longitude = s == 1 ? 0 : 2 * std::numbers::pi * s;
      const double sin_latitude = t == 0 || t == 1 ? 0 : std::sin(std::numbers::pi * t);
      const double cos_latitude = t == 0 ? 1 : (t == 1 ? -1 : std::cos(std::numbers::pi * t));
      const double x = sin_latitude * std::cos(longitude);
      const double y = sin_latitude * std::sin(longitude);
      const double x_turned = x * std::cos(turn) - y * std::sin(turn);
      const double y_turned = x * std::sin(turn) + y * std::cos(turn);
      const double y_tilted = y_turned * std::cos(tilt) - cos_latitude * std::sin(tilt);
      const double w = y_turned * std::sin(tilt) + cos_latitude * std::cos(tilt);
      return ClipPosition{static_cast<float>(x_turned), static_cast<float>(y_tilted), static_cast<float>(w / 2),
                          static_cast<float>(w)};
    });
    EXPECT_EQ(render(scene).hits, all_hit_once(128, 128)) << rings << " x " << sectors;
  }
}

TEST(Watertight, RotatingTheVerticesLeavesCoverageAsItIs) {
  SeededRandom random;
  for (int i = 0; i < 500; ++i) {
    TestScene scene(64, 64);
    for (int k = 0; k < 3; ++k) {
      scene.positions.push_back({static_cast<float>(random.uniform(-3, 3)), static_cast<float>(random.uniform(-3, 3)),
                                 static_cast<float>(random.uniform(-1, 2)),
                                 static_cast<float>(random.uniform(-1, 2))});
    }
    const TestPlanes planes = render(scene);
    for (int rotation = 1; rotation < 3; ++rotation) {
      std::rotate(scene.positions.begin(), scene.positions.begin() + 1, scene.positions.end());
      const TestPlanes rotated = render(scene);
      ASSERT_EQ(rotated.hits, planes.hits);
      ASSERT_EQ(rotated.front_facing, planes.front_facing);
    }
  }
}

}  // namespace
}  // namespace fillrule::renderer
