#include "reference/exact/obvious_oracle.h"

#include <algorithm>
#include <cfloat>

namespace fillrule::exact::obvious {
namespace {

Line line_through(const Point& p, const Point& q) {
  return {.a = p.y - q.y, .b = q.x - p.x, .c = p.x * q.y - q.x * p.y};
}

Coverage compare(const Rational& inside_by, const Rational& reach) {
  if (inside_by > reach) return Coverage::kMust;
  return inside_by < -reach ? Coverage::kMustNot : Coverage::kMay;
}

Rational reach_of(const Line& line, const Latitude& latitude) {
  return abs(line.a) * Rational(latitude.x) + abs(line.b) * Rational(latitude.y);
}

// The plane z(x, y) through three points of the window.
Line plane_through(const std::array<Point, 3>& p, const std::array<Rational, 3>& z) {
  const Point e1{.x = p[1].x - p[0].x, .y = p[1].y - p[0].y};
  const Point e2{.x = p[2].x - p[0].x, .y = p[2].y - p[0].y};
  const Rational det = e1.x * e2.y - e2.x * e1.y;
  const Rational d1 = z[1] - z[0];
  const Rational d2 = z[2] - z[0];
  const Rational a = (d1 * e2.y - d2 * e1.y) / det;
  const Rational b = (d2 * e1.x - d1 * e2.x) / det;
  return {.a = a, .b = b, .c = z[0] - a * p[0].x - b * p[0].y};
}

}  // namespace

Oracle::Oracle(const std::array<ClipPosition, 3>& vertices, const VkViewport& viewport) : viewport_(viewport) {
  const Rational half_width = Rational(viewport.width) / 2;
  const Rational half_height = Rational(viewport.height) / 2;
  for (size_t i = 0; i < 3; ++i) {
    const auto& [x, y, z, w] = vertices[i];
    w_[i] = Rational(w);
    position_[i] = {.x = Rational(x) / w_[i] * half_width + half_width + Rational(viewport.x),
                    .y = Rational(y) / w_[i] * half_height + half_height + Rational(viewport.y)};
    z_[i] = Rational(z) / w_[i];
    all_in_front_ = all_in_front_ && w > 0;
    crosses_near_ = crosses_near_ || z < 0;
    crosses_far_ = crosses_far_ || z > w;
    all_behind_near_ = all_behind_near_ && z <= -FLT_MIN;
    all_beyond_far_ = all_beyond_far_ && z > w;
  }
  // A point inside: a combination with positive weights, the vertex of the largest w weighing enough to stay in
  // front.
  const auto front = static_cast<size_t>(std::max_element(w_.begin(), w_.end()) - w_.begin());
  std::array<Rational, 3> weight{1, 1, 1};
  if (w_[front] > 0) weight[front] = 1 + 2 * (abs(w_[0]) + abs(w_[1]) + abs(w_[2])) / w_[front];
  Point inside{.x = 0, .y = 0};
  Rational inside_w = 0;
  for (size_t i = 0; i < 3; ++i) {
    inside.x += weight[i] * position_[i].x * w_[i];
    inside.y += weight[i] * position_[i].y * w_[i];
    inside_w += weight[i] * w_[i];
  }
  if (inside_w != 0) inside = {.x = inside.x / inside_w, .y = inside.y / inside_w};
  for (size_t i = 0; i < 3; ++i) {
    edge_[i] = line_through(position_[(i + 1) % 3], position_[(i + 2) % 3]);
    const Rational side = edge_[i].at(inside);
    has_area_ = edge_[i].at(position_[i]) != 0;
    // Nothing in front of the eye: everything is outside.
    const bool flip = inside_w > 0 ? side < 0 : side > 0;
    if (flip) edge_[i] = {.a = -edge_[i].a, .b = -edge_[i].b, .c = -edge_[i].c};
  }
}

Coverage Oracle::classify(double x, double y, const Latitude& latitude) const {
  const Point p{.x = Rational(x), .y = Rational(y)};
  const Rational tx(latitude.x);
  const Rational ty(latitude.y);
  const Rational left(viewport_.x);
  const Rational top(viewport_.y);
  const Rational right = left + Rational(viewport_.width);
  const Rational bottom = top + Rational(viewport_.height);
  Coverage result = std::min(
      {compare(p.x - left, tx), compare(right - p.x, tx), compare(p.y - top, ty), compare(bottom - p.y, ty)});
  if (all_behind_near_ || all_beyond_far_) return Coverage::kMustNot;
  if (all_in_front_) {
    const auto [min_x, max_x] = std::minmax({position_[0].x, position_[1].x, position_[2].x});
    const auto [min_y, max_y] = std::minmax({position_[0].y, position_[1].y, position_[2].y});
    if (p.x < min_x - tx || p.x > max_x + tx || p.y < min_y - ty || p.y > max_y + ty) return Coverage::kMustNot;
  }
  for (const Line& line : edge_) {
    const Coverage side = compare(line.at(p), reach_of(line, latitude));
    if (!has_area_ && side != Coverage::kMay) return Coverage::kMustNot;
    result = std::min(result, side);
  }
  if (!has_area_) return result;
  const Line depth = plane_through(position_, z_);
  if (crosses_near_) result = std::min(result, compare(depth.at(p), reach_of(depth, latitude)));
  if (crosses_far_) result = std::min(result, compare(1 - depth.at(p), reach_of(depth, latitude)));
  return result;
}

std::array<Rational, 3> Oracle::barycentric(const Point& p) const {
  std::array<Rational, 3> result;
  for (size_t i = 0; i < 3; ++i) result[i] = edge_[i].at(p) / edge_[i].at(position_[i]);
  return result;
}

Rational Oracle::depth(double x, double y) const {
  const Rational z = plane_through(position_, z_).at({.x = Rational(x), .y = Rational(y)});
  const Rational low(viewport_.minDepth);
  return low + z * (Rational(viewport_.maxDepth) - low);
}

Rational Oracle::smooth(const std::array<float, 3>& q, double x, double y) const {
  const auto b = barycentric({.x = Rational(x), .y = Rational(y)});
  Rational numerator = 0;
  Rational denominator = 0;
  for (size_t i = 0; i < 3; ++i) {
    numerator += b[i] * Rational(q[i]) / w_[i];
    denominator += b[i] / w_[i];
  }
  return denominator == 0 ? Rational(0) : numerator / denominator;
}

Rational Oracle::noperspective(const std::array<float, 3>& q, double x, double y) const {
  const auto b = barycentric({.x = Rational(x), .y = Rational(y)});
  Rational value = 0;
  for (size_t i = 0; i < 3; ++i) value += b[i] * Rational(q[i]);
  return value;
}

}  // namespace fillrule::exact::obvious
