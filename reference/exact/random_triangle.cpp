#include "reference/exact/random_triangle.h"

#include <cmath>

namespace fillrule::exact {
namespace {

constexpr double kSize = 64;  // pixels, width and height of the viewport

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// A vertex at a position of the framebuffer.
ClipPosition vertex_at(double x, double y, double z, double w) {
  return {static_cast<float>((x / (kSize / 2) - 1) * w), static_cast<float>((y / (kSize / 2) - 1) * w),
          static_cast<float>(z * w), static_cast<float>(w)};
}

double rounded(double value, double step) {
  return std::round(value / step) * step;
}

std::array<ClipPosition, 3> around(std::mt19937_64& random, double radius, double step) {
  const double x = uniform(random, 4, kSize - 4);
  const double y = uniform(random, 4, kSize - 4);
  std::array<ClipPosition, 3> vertices{};
  for (ClipPosition& vertex : vertices) {
    double vx = x + uniform(random, -radius, radius);
    double vy = y + uniform(random, -radius, radius);
    if (step > 0) {
      vx = rounded(vx, step);
      vy = rounded(vy, step);
    }
    vertex = vertex_at(vx, vy, uniform(random, 0, 1), 1);
  }
  return vertices;
}

std::array<ClipPosition, 3> along_a_line(std::mt19937_64& random, double width) {
  const double x = uniform(random, 0, kSize);
  const double y = uniform(random, 0, kSize);
  const double angle = uniform(random, 0, 6.2831853);
  std::array<ClipPosition, 3> vertices{};
  for (ClipPosition& vertex : vertices) {
    const double t = rounded(uniform(random, -40, 40), 1.0 / 16);
    const double off = width * uniform(random, -1, 1);
    vertex = vertex_at(x + t * std::cos(angle) - off * std::sin(angle),
                       y + t * std::sin(angle) + off * std::cos(angle), uniform(random, 0, 1), 1);
  }
  return vertices;
}

std::array<ClipPosition, 3> with_w(std::mt19937_64& random, double low_exponent, double high_exponent, bool mixed) {
  std::array<ClipPosition, 3> vertices{};
  for (ClipPosition& vertex : vertices) {
    double w = std::exp2(uniform(random, low_exponent, high_exponent));
    if (mixed && uniform(random, 0, 1) < 0.5) w = -w;
    vertex = vertex_at(uniform(random, -32, 96), uniform(random, -32, 96), uniform(random, 0, 1), w);
    if (mixed) vertex[2] = static_cast<float>(uniform(random, -1, 1) * w);
  }
  return vertices;
}

std::array<ClipPosition, 3> across_depth(std::mt19937_64& random, double low, double high) {
  std::array<ClipPosition, 3> vertices{};
  for (ClipPosition& vertex : vertices) {
    vertex = vertex_at(uniform(random, -16, 80), uniform(random, -16, 80), uniform(random, low, high), 1);
  }
  return vertices;
}

// Vertices far away, on both ends of a line that crosses the viewport, so that edges cross it too.
std::array<ClipPosition, 3> far_away(std::mt19937_64& random, double high_exponent) {
  std::array<ClipPosition, 3> vertices{};
  const double angle = uniform(random, 0, 6.2831853);
  for (size_t i = 0; i < 3; ++i) {
    const double distance = std::exp2(uniform(random, 4, high_exponent)) * (i == 0 ? -1 : 1);
    const double turned = angle + (i == 2 ? uniform(random, -2, 2) : 0);
    vertices[i] = vertex_at(uniform(random, 0, kSize) + distance * std::cos(turned),
                            uniform(random, 0, kSize) + distance * std::sin(turned), uniform(random, 0, 1), 1);
  }
  return vertices;
}

}  // namespace

RandomTriangle random_triangle(Family family, std::mt19937_64& random) {
  RandomTriangle result{.viewport = {.x = 0, .y = 0, .width = kSize, .height = kSize, .minDepth = 0, .maxDepth = 1}};
  switch (family) {
    case Family::kSmall:
      result.vertices = around(random, 3, 0);
      break;
    case Family::kBig:
      result.vertices = around(random, 300, 0);
      break;
    case Family::kOnGrid:
      result.vertices = around(random, 8, 1.0 / 256);
      break;
    case Family::kOnCentres:
      result.vertices = around(random, 8, 0.5);
      break;
    case Family::kSliver:
      result.vertices = along_a_line(random, 3.0 / 256);
      break;
    case Family::kCollinear:
      result.vertices = along_a_line(random, 0);
      break;
    case Family::kPerspective:
      result.vertices = with_w(random, 0, 10, false);
      break;
    case Family::kMixedW:
      result.vertices = with_w(random, -4, 4, true);
      break;
    case Family::kNear:
      result.vertices = across_depth(random, -1, 1);
      break;
    case Family::kFar:
      result.vertices = across_depth(random, 0, 2);
      break;
    case Family::kHuge:
      result.vertices = far_away(random, 90);
      break;
    case Family::kDenormal:
      result.vertices = around(random, 30, 0);
      result.vertices[random() % 3][random() % 3] = static_cast<float>(std::exp2(uniform(random, -149, -126)));
      break;
  }
  if (family == Family::kBig) {
    result.viewport = {.x = 3.25F, .y = -7.5F, .width = 61.3F, .height = 77.7F, .minDepth = 0.9F, .maxDepth = 0.1F};
  }
  return result;
}

}  // namespace fillrule::exact
