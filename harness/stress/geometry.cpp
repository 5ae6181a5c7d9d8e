#include "harness/stress/geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fillrule::stress {
namespace {

using Vertices = std::array<ClipPosition, 3>;

constexpr double kSubpixel = 1.0 / 256;  // px, of the finest grid among the parties

struct Point {
  double x = 0;
  double y = 0;
};

// Places vertices in the framebuffer of a viewport.
class Placer {
 public:
  Placer(const VkViewport& viewport, Random& random) : viewport_(viewport), random_(random) {}

  // The vertex that is projected to the point, with the depth z in normalized device coordinates.
  [[nodiscard]] ClipPosition at(Point point, double z, double w) const {
    const double half_width = double{viewport_.width} / 2;
    const double half_height = double{viewport_.height} / 2;
    return {static_cast<float>(((point.x - double{viewport_.x}) / half_width - 1) * w),
            static_cast<float>(((point.y - double{viewport_.y}) / half_height - 1) * w), static_cast<float>(z * w),
            static_cast<float>(w)};
  }

  // Anywhere in the viewport, grown by `margin` times its size on each side.
  [[nodiscard]] Point point(double margin = 0) const {
    const double x = random_.uniform(-margin, 1 + margin);
    const double y = random_.uniform(-margin, 1 + margin);
    return {.x = double{viewport_.x} + x * double{viewport_.width},
            .y = double{viewport_.y} + y * double{viewport_.height}};
  }

  [[nodiscard]] Point near(Point centre, double radius) const {
    return {.x = centre.x + random_.uniform(-radius, radius), .y = centre.y + random_.uniform(-radius, radius)};
  }

  [[nodiscard]] double size() const { return std::max(double{viewport_.width}, std::abs(double{viewport_.height})); }
  [[nodiscard]] double depth() const { return random_.uniform(0, 1); }

 private:
  const VkViewport& viewport_;
  Random& random_;
};

Point rounded(Point point, double step) {
  return {.x = std::round(point.x / step) * step, .y = std::round(point.y / step) * step};
}

Point moved(Point point, double angle, double distance) {
  return {.x = point.x + distance * std::cos(angle), .y = point.y + distance * std::sin(angle)};
}

Vertices small(const Placer& place, Random& random) {
  const Point centre = place.point();
  const double radius = random.power_of_two(-3, 3);
  Vertices vertices{};
  for (ClipPosition& vertex : vertices) vertex = place.at(place.near(centre, radius), place.depth(), 1);
  return vertices;
}

Vertices big(const Placer& place, Random& random) {
  const double margin = random.power_of_two(-1, 5);
  Vertices vertices{};
  for (ClipPosition& vertex : vertices) vertex = place.at(place.point(margin), place.depth(), 1);
  return vertices;
}

// Along a line in any direction, or in one of the axes' and diagonals', at most `width` off.
Vertices along_line(const Placer& place, Random& random, double width) {
  const Point origin = random.chance(0.5) ? place.point() : rounded(place.point(), 0.5);
  const bool regular = random.chance(0.5);
  const double angle = regular ? random.below(8) * std::numbers::pi / 4 : random.uniform(0, 2 * std::numbers::pi);
  Vertices vertices{};
  for (ClipPosition& vertex : vertices) {
    const double along = random.uniform(-0.5, 0.5) * place.size();
    const Point on_line = regular ? rounded(moved(origin, angle, along), kSubpixel) : moved(origin, angle, along);
    vertex = place.at(moved(on_line, angle + std::numbers::pi / 2, width * random.uniform(-1, 1)), place.depth(), 1);
  }
  return vertices;
}

Vertices collinear(const Placer& place, Random& random) {
  Vertices vertices = along_line(place, random, 0);
  switch (random.below(4)) {
    case 0:
      vertices[2] = vertices[random.below(2)];  // two vertices are one
      break;
    case 1:
      vertices[1] = vertices[2] = vertices[0];
      break;
    default:
      break;
  }
  return vertices;
}

Vertices on_grid(const Placer& place, Random& random, double step) {
  const Point centre = place.point();
  const double radius = random.power_of_two(0, 5);
  Vertices vertices{};
  for (ClipPosition& vertex : vertices) {
    vertex = place.at(rounded(place.near(centre, radius), step), place.depth(), 1);
  }
  return vertices;
}

// Exactly where rounding to the grid, or the top-left rule, has to decide.
Vertices ties(const Placer& place, Random& random) {
  switch (random.below(3)) {
    case 0: {
      Vertices vertices{};
      const Point centre = place.point();
      for (ClipPosition& vertex : vertices) {
        const Point corner = rounded(place.near(centre, 12), kSubpixel);
        vertex = place.at({.x = corner.x + kSubpixel / 2, .y = corner.y + kSubpixel / 2}, place.depth(), 1);
      }
      return vertices;
    }
    case 1:
      return on_grid(place, random, 0.5);
    default: {
      // Two vertices mirrored in a pixel centre.
      const Point whole = rounded(place.point(), 1);
      const Point centre{.x = whole.x + 0.5, .y = whole.y + 0.5};
      const Point one = rounded(place.near(centre, 16), kSubpixel);
      const Point mirrored{.x = 2 * centre.x - one.x, .y = 2 * centre.y - one.y};
      return {place.at(one, place.depth(), 1), place.at(mirrored, place.depth(), 1),
              place.at(rounded(place.near(centre, 16), kSubpixel), place.depth(), 1)};
    }
  }
}

Vertices with_w(const Placer& place, Random& random, double highest_exponent) {
  const double scale = random.power_of_two(-10, 10);
  Vertices vertices{};
  for (ClipPosition& vertex : vertices) {
    vertex = place.at(place.point(0.5), place.depth(), scale * random.power_of_two(0, highest_exponent));
  }
  return vertices;
}

// Depths from low to high in normalized device coordinates, one vertex at each end at least.
Vertices across_depth(const Placer& place, Random& random, double low, double high) {
  const bool in_perspective = random.chance(0.5);
  Vertices vertices{};
  for (size_t i = 0; i < 3; ++i) {
    double z = random.uniform(low, high);
    if (i == 0 && low < 0) z = random.uniform(low, 0);
    if (i == 1 && high > 1) z = random.uniform(1, high);
    vertices[i] = place.at(place.point(0.5), z, in_perspective ? random.power_of_two(-3, 3) : 1);
  }
  return vertices;
}

// One or two vertices behind the eye.
Vertices mixed_w(const Placer& place, Random& random) {
  const uint32_t behind = 1 + random.below(2);
  Vertices vertices{};
  for (uint32_t i = 0; i < 3; ++i) {
    const double w = random.power_of_two(-4, 4) * (i < behind ? -1 : 1);
    vertices[i] = place.at(place.point(0.5), place.depth(), w);
    if (random.chance(0.7)) vertices[i][2] = static_cast<float>(random.uniform(-1, 1) * w);
  }
  return vertices;
}

Vertices zero_w(const Placer& place, Random& random) {
  const uint32_t zeros = 1 + random.below(2);
  Vertices vertices{};
  for (uint32_t i = 0; i < 3; ++i) {
    vertices[i] = place.at(place.point(0.5), place.depth(), random.power_of_two(-4, 4));
    if (i >= zeros) continue;
    const double z = random.chance(0.5) ? 0 : random.uniform(-1, 1);
    vertices[i] = {static_cast<float>(random.uniform(-1, 1)), static_cast<float>(random.uniform(-1, 1)),
                   static_cast<float>(z), random.chance(0.5) ? 0.0F : -0.0F};
  }
  return vertices;
}

// Vertices on both ends of a line that crosses the viewport, so that edges cross it too.
Vertices far_away(const Placer& place, Random& random, double highest_exponent) {
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  const double turn = random.uniform(-2, 2);
  Vertices vertices{};
  for (size_t i = 0; i < 3; ++i) {
    const double distance = random.power_of_two(4, highest_exponent) * (i == 0 ? -1 : 1);
    vertices[i] = place.at(moved(place.point(), angle + (i == 2 ? turn : 0), distance), place.depth(), 1);
  }
  return vertices;
}

Vertices huge(const Placer& place, Random& random) {
  switch (random.below(4)) {
    case 0:
      return far_away(place, random, 23);
    case 1:
      return far_away(place, random, 90);
    case 2: {
      // Every coordinate of the same extreme magnitude.
      const auto scale = static_cast<float>(std::exp2(static_cast<double>(random.below(200)) - 100));
      Vertices vertices = with_w(place, random, 4);
      for (ClipPosition& vertex : vertices) {
        for (float& coordinate : vertex) coordinate *= scale;
      }
      return vertices;
    }
    default: {
      Vertices vertices = big(place, random);
      vertices[random.below(3)][random.below(3)] =
          static_cast<float>(random.sign() * random.power_of_two(-149, -120));
      return vertices;
    }
  }
}

// Anything tame: the family is about the viewport.
Vertices for_viewport(const Placer& place, Random& random) {
  const double w = random.chance(0.5) ? 1 : random.power_of_two(-2, 6);
  Vertices vertices{};
  for (ClipPosition& vertex : vertices) {
    vertex = place.at(place.point(0.3), random.uniform(-0.2, 1.2), random.chance(0.5) ? w : 1);
  }
  return vertices;
}

// The middle, then points around it in order of their angle.
std::vector<Point> around(const Placer& place, uint32_t count, Random& random) {
  const Point middle = random.chance(0.5) ? place.point() : rounded(place.point(), 0.5);
  const double radius = random.power_of_two(1, 6);
  std::vector<Point> points{middle};
  for (uint32_t i = 0; i < count; ++i) {
    const double angle = (i + random.uniform(0, 0.8)) * 2 * std::numbers::pi / count;
    points.push_back(moved(middle, angle, radius * random.uniform(0.3, 1)));
  }
  return points;
}

// A zigzag across the viewport.
std::vector<Point> zigzag(const Placer& place, uint32_t count, Random& random) {
  const Point start = place.point();
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  const double step = random.power_of_two(0, 4);
  const double width = random.power_of_two(0, 4);
  std::vector<Point> points;
  for (uint32_t i = 0; i < count; ++i) {
    const Point along = moved(start, angle, step * (i + random.uniform(-0.3, 0.3)));
    points.push_back(moved(along, angle + std::numbers::pi / 2, i % 2 == 0 ? width : -width));
  }
  return points;
}

}  // namespace

std::array<ClipPosition, 3> random_triangle(Family family, const VkViewport& viewport, Random& random) {
  const Placer place(viewport, random);
  switch (family) {
    case Family::kSmall:
    case Family::kSharedEdges:
      return small(place, random);
    case Family::kBig:
      return big(place, random);
    case Family::kSliver:
      return along_line(place, random, random.power_of_two(-1, 3) * kSubpixel);
    case Family::kOnGrid:
      return on_grid(place, random, kSubpixel);
    case Family::kTies:
      return ties(place, random);
    case Family::kCollinear:
      return collinear(place, random);
    case Family::kPerspective:
      return with_w(place, random, 9.97);
    case Family::kSteep:
      return with_w(place, random, 19.93);
    case Family::kNear:
      return across_depth(place, random, -1, 1);
    case Family::kFar:
      return across_depth(place, random, 0, 2);
    case Family::kNearAndFar:
      return across_depth(place, random, -1, 2);
    case Family::kMixedW:
      return mixed_w(place, random);
    case Family::kZeroW:
      return zero_w(place, random);
    case Family::kHuge:
      return huge(place, random);
    case Family::kViewport:
      return for_viewport(place, random);
  }
  return {};
}

Mesh random_mesh(uint32_t triangles, const VkViewport& viewport, Random& random) {
  const Placer place(viewport, random);
  const uint32_t kind = random.below(3);
  Mesh mesh;
  std::vector<Point> points;
  switch (kind) {
    case 0:  // a closed fan, its middle shared by all
      points = around(place, triangles, random);
      mesh.indices.emplace();
      for (uint32_t i = 0; i < triangles; ++i) {
        for (const uint32_t index : {0U, 1 + i, 1 + (i + 1) % triangles}) mesh.indices->push_back(index);
      }
      break;
    case 1:
      points = around(place, triangles + 1, random);
      mesh.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN;
      break;
    default:
      points = zigzag(place, triangles + 2, random);
      mesh.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  }
  const double step = random.pick(std::array{0.0, 0.0, kSubpixel, 0.5});
  const bool in_perspective = random.chance(0.3);
  for (const Point& point : points) {
    const double w = in_perspective ? random.power_of_two(-2, 2) : 1;
    mesh.positions.push_back(place.at(step > 0 ? rounded(point, step) : point, place.depth(), w));
  }
  return mesh;
}

}  // namespace fillrule::stress
