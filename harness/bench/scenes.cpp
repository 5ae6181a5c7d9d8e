#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/bench/workloads.h"
#include "harness/stress/random.h"

namespace fillrule::bench {
namespace {

using stress::Random;

constexpr double kTurn = 2 * std::numbers::pi;

Attribute random_color(Random& random) {
  const auto channel = [&] { return static_cast<float>(random.uniform(0, 1)); };
  const float red = channel();
  const float green = channel();
  const float blue = channel();
  return {red, green, blue, 1.0F};
}

// Made in braces, which compilers evaluate in this order, so that random numbers fall to the same fields everywhere.
struct Corner {
  double x_framebuffer = 0;  // pixels
  double y_framebuffer = 0;
  double depth = 0;
  double w = 1;
  Attribute color{};
};

void add_vertex(Scene& scene, const Corner& corner) {
  const double half = scene.target_size / 2.0;
  const auto clip = [w = corner.w](double ndc) { return static_cast<float>(ndc * w); };
  scene.positions_clip.push_back({clip(corner.x_framebuffer / half - 1), clip(corner.y_framebuffer / half - 1),
                                  clip(corner.depth), static_cast<float>(corner.w)});
  scene.attributes.push_back(corner.color);
}

void number_vertices(Scene& scene) {
  scene.indices.resize(scene.positions_clip.size());
  for (uint32_t i = 0; i < scene.indices.size(); ++i) scene.indices[i] = i;
}

// The triangles of a grid of columns x rows quads, whose vertices lie row by row.
void index_grid(Scene& scene, uint32_t columns, uint32_t rows) {
  for (uint32_t row = 0; row < rows; ++row) {
    for (uint32_t column = 0; column < columns; ++column) {
      const uint32_t a = row * (columns + 1) + column;
      const uint32_t b = a + columns + 1;
      for (const uint32_t index : {a, b, a + 1, a + 1, b, b + 1}) scene.indices.push_back(index);
    }
  }
}

struct Vector {
  double x = 0;
  double y = 0;
  double z = 0;
};

// A perspective camera at the origin that looks along +z: 90 degrees, near plane at 0.1, far plane at 100.
ClipPosition project(const Vector& eye) {
  constexpr double kNear = 0.1;
  constexpr double kFar = 100;
  const double z_clip = (eye.z - kNear) * kFar / (kFar - kNear);
  return {static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(z_clip),
          static_cast<float>(eye.z)};
}

}  // namespace

Scene fill_scene(uint32_t quads, uint32_t target_size) {
  Scene scene{.target_size = target_size};
  Random random(0, 1, 0);
  const double size = target_size;
  for (uint32_t quad = 0; quad < quads; ++quad) {
    const double depth = 1 - (quad + 1.0) / (quads + 1);
    const std::array<std::array<double, 2>, 4> corners{{{0, 0}, {0, size}, {size, 0}, {size, size}}};
    const auto first = static_cast<uint32_t>(scene.positions_clip.size());
    for (const auto& [x, y] : corners) add_vertex(scene, {x, y, depth, random.uniform(1, 4), random_color(random)});
    for (const uint32_t i : {0U, 1U, 2U, 2U, 1U, 3U}) scene.indices.push_back(first + i);
  }
  return scene;
}

Scene random_triangles_scene(uint32_t triangles, double area_pixels, uint32_t target_size) {
  Scene scene{.target_size = target_size};
  Random random(0, 2, 0);
  // Of an equilateral triangle: area = 3 * sqrt(3) / 4 * radius^2.
  const double radius = std::sqrt(area_pixels * 4 / (3 * std::numbers::sqrt3));
  // All are whole in the target. What a border cuts may be covered or not where rounding decides, and measure() asks
  // for equal pictures.
  for (uint32_t triangle = 0; triangle < triangles; ++triangle) {
    const double x = random.uniform(radius + 1, target_size - radius - 1);
    const double y = random.uniform(radius + 1, target_size - radius - 1);
    const double depth = random.uniform(0.1, 0.9);
    const double angle = random.uniform(0, kTurn);
    for (uint32_t corner = 0; corner < 3; ++corner) {
      const double direction = angle + corner * kTurn / 3;
      add_vertex(scene, {x + radius * std::cos(direction), y + radius * std::sin(direction),
                         depth + random.uniform(-0.1, 0.1), random.uniform(1, 4), random_color(random)});
    }
  }
  number_vertices(scene);
  return scene;
}

Scene grid_scene(uint32_t triangles, uint32_t target_size) {
  Scene scene{.target_size = target_size};
  Random random(0, 3, 0);
  const auto side = static_cast<uint32_t>(std::max(1.0, std::round(std::sqrt(triangles / 2.0))));
  const double step = static_cast<double>(target_size) / side;
  constexpr double kJitter = 0.3;
  for (uint32_t row = 0; row <= side; ++row) {
    for (uint32_t column = 0; column <= side; ++column) {
      const auto jitter = [&](uint32_t at) {
        const double offset = random.uniform(-kJitter, kJitter);
        return (at == 0 || at == side ? at : at + offset) * step;
      };
      const double x = jitter(column);
      const double y = jitter(row);
      add_vertex(scene, {x, y, random.uniform(0.2, 0.8), random.uniform(1, 4), random_color(random)});
    }
  }
  index_grid(scene, side, side);
  return scene;
}

Scene lines_scene(uint32_t lines, double length_pixels, uint32_t target_size) {
  Scene scene{.target_size = target_size, .topology = VK_PRIMITIVE_TOPOLOGY_LINE_LIST};
  Random random(0, 4, 0);
  for (uint32_t line = 0; line < lines; ++line) {
    const double x = random.uniform(0, target_size);
    const double y = random.uniform(0, target_size);
    const double depth = random.uniform(0.1, 0.9);
    const double angle = random.uniform(0, kTurn);
    const double half_x = length_pixels / 2 * std::cos(angle);
    const double half_y = length_pixels / 2 * std::sin(angle);
    for (const double sign : {-1.0, 1.0}) {
      add_vertex(scene, {x + sign * half_x, y + sign * half_y, depth + sign * 0.05, random.uniform(1, 4),
                         random_color(random)});
    }
  }
  number_vertices(scene);
  return scene;
}

Scene mesh_scene(uint32_t target_size) {
  Scene scene{.target_size = target_size, .cull_mode = VK_CULL_MODE_BACK_BIT};
  constexpr uint32_t kAround = 400;  // the hole
  constexpr uint32_t kAcross = 100;  // the tube
  for (uint32_t row = 0; row <= kAcross; ++row) {
    for (uint32_t column = 0; column <= kAround; ++column) {
      const double u = kTurn * column / kAround;
      const double v = kTurn * row / kAcross;
      const double radius = 0.45 + 0.05 * std::sin(9 * u) * std::cos(7 * v);
      const Vector model{(1 + radius * std::cos(v)) * std::cos(u), radius * std::sin(v),
                         (1 + radius * std::cos(v)) * std::sin(u)};
      // Tilted by 45 degrees, two units away.
      const double tilt = std::numbers::sqrt2 / 2;
      const Vector eye{model.x, tilt * (model.y - model.z), tilt * (model.y + model.z) + 2};
      scene.positions_clip.push_back(project(eye));
      const auto color = [](double angle) { return static_cast<float>(0.5 + 0.5 * std::sin(angle)); };
      scene.attributes.push_back({color(u), color(v), color(3 * u + v), 1.0F});
    }
  }
  index_grid(scene, kAround, kAcross);
  return scene;
}

Scene clip_scene(uint32_t triangles, uint32_t target_size) {
  Scene scene{.target_size = target_size};
  Random random(0, 5, 0);
  const auto vertex = [&](const Vector& centre, double reach) {
    const auto near = [&](double at) { return at + random.uniform(-reach, reach); };
    const double x = near(centre.x);
    const double y = near(centre.y);
    scene.positions_clip.push_back(project({x, y, near(centre.z)}));
    scene.attributes.push_back(random_color(random));
  };
  for (uint32_t triangle = 0; triangle < triangles; ++triangle) {
    const double x = random.uniform(-8, 8);
    const double y = random.uniform(-8, 8);
    const Vector centre{x, y, random.uniform(-1, 3)};
    for (uint32_t corner = 0; corner < 3; ++corner) vertex(centre, 2);
  }
  number_vertices(scene);
  return scene;
}

}  // namespace fillrule::bench
