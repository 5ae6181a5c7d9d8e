#include "reference/exact/rational_triangle.h"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>

namespace fillrule::exact {
namespace {

using Rational = boost::multiprecision::cpp_rational;

struct Vector {
  Rational x, y, w;
};

struct RationalForm {
  Rational a, b, c;
  [[nodiscard]] Rational at(const Rational& x, const Rational& y) const { return a * x + b * y + c; }
};

// Homogeneous framebuffer coordinates, absolute: x = (px / 2) X + (x0 + px / 2) W.
Vector framebuffer_from_clip(const ClipPosition& clip, const VkViewport& viewport) {
  const Rational half_width = Rational(viewport.width) / 2;
  const Rational half_height = Rational(viewport.height) / 2;
  const Rational w(clip[3]);
  return {.x = half_width * Rational(clip[0]) + (Rational(viewport.x) + half_width) * w,
          .y = half_height * Rational(clip[1]) + (Rational(viewport.y) + half_height) * w,
          .w = w};
}

std::array<Vector, 3> framebuffer_from_clip(const std::array<ClipPosition, 3>& vertices, const VkViewport& viewport) {
  return {framebuffer_from_clip(vertices[0], viewport), framebuffer_from_clip(vertices[1], viewport),
          framebuffer_from_clip(vertices[2], viewport)};
}

RationalForm cross(const Vector& p, const Vector& q) {
  return {.a = p.y * q.w - p.w * q.y, .b = p.w * q.x - p.x * q.w, .c = p.x * q.y - p.y * q.x};
}

Rational determinant(const std::array<Vector, 3>& v) {
  const RationalForm edge = cross(v[1], v[2]);
  return edge.a * v[0].x + edge.b * v[0].y + edge.c * v[0].w;
}

std::array<RationalForm, 3> edges(const std::array<Vector, 3>& v) {
  return {cross(v[1], v[2]), cross(v[2], v[0]), cross(v[0], v[1])};
}

// sum q_i E_i
RationalForm combination(const std::array<RationalForm, 3>& edges, const std::array<Rational, 3>& q) {
  RationalForm sum;
  for (size_t i = 0; i < 3; ++i) {
    sum.a += q[i] * edges[i].a;
    sum.b += q[i] * edges[i].b;
    sum.c += q[i] * edges[i].c;
  }
  return sum;
}

// The boundary's function, positive inside; with no area the sign of an edge is arbitrary.
RationalForm boundary_form(const Triangle& triangle, int boundary) {
  const auto& clip = triangle.vertices();
  const auto edge = edges(framebuffer_from_clip(clip, triangle.viewport()));
  RationalForm form;
  if (boundary <= kEdge2) {
    form = edge[static_cast<size_t>(boundary)];
  } else {
    std::array<Rational, 3> q;
    for (size_t i = 0; i < 3; ++i) {
      const Rational z(clip[i][2]);
      const Rational w(clip[i][3]);
      q[i] = boundary == kFar ? w - z : triangle.volume().negative_one_to_one ? Rational(z + w) : z;
    }
    form = combination(edge, q);
  }
  if (triangle.orientation() < 0) form = {.a = -form.a, .b = -form.b, .c = -form.c};
  return form;
}

Coverage classify(const Rational& value, const Rational& reach) {
  if (value > reach) return Coverage::kMust;
  return value < -reach ? Coverage::kMustNot : Coverage::kMay;
}

// The nearest double: the quotient of two integers of any size.
double nearest_double(const Rational& value) {
  using Float = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<240>>;
  return static_cast<double>(static_cast<Float>(numerator(value)) / static_cast<Float>(denominator(value)));
}

bool multiple_of(const Rational& value, const Rational& step) {
  return denominator(Rational(value / step)) == 1;
}

}  // namespace

int exact_orientation(const std::array<ClipPosition, 3>& vertices, const VkViewport& viewport) {
  return determinant(framebuffer_from_clip(vertices, viewport)).sign();
}

double exact_determinant(const std::array<ClipPosition, 3>& vertices, const VkViewport& viewport) {
  return nearest_double(abs(determinant(framebuffer_from_clip(vertices, viewport))));
}

int exact_side(const Triangle& triangle, int boundary, double x, double y) {
  return boundary_form(triangle, boundary).at(Rational(x), Rational(y)).sign();
}

Coverage exact_classification(const Triangle& triangle, int boundary, double x, double y, const Latitude& latitude) {
  const RationalForm form = boundary_form(triangle, boundary);
  const Rational value = form.at(Rational(x), Rational(y));
  return classify(value, abs(form.a) * Rational(latitude.x) + abs(form.b) * Rational(latitude.y));
}

Coverage exact_viewport_classification(const VkViewport& viewport, double x, double y, const Latitude& latitude) {
  const Rational left(viewport.x);
  const Rational top(viewport.y);
  const Rational right = left + Rational(viewport.width);
  const Rational bottom = top + Rational(viewport.height);
  const Rational px(x);
  const Rational py(y);
  const Coverage horizontal = classify(std::min<Rational>(px - left, right - px), Rational(latitude.x));
  const Coverage vertical =
      classify(std::min<Rational>(py - std::min(top, bottom), std::max(top, bottom) - py), Rational(latitude.y));
  return std::min(horizontal, vertical);
}

bool exact_outside_bounds(const Triangle& triangle, double x, double y, const Latitude& latitude) {
  const auto v = framebuffer_from_clip(triangle.vertices(), triangle.viewport());
  std::array<Rational, 3> xs;
  std::array<Rational, 3> ys;
  for (size_t i = 0; i < 3; ++i) {
    xs[i] = v[i].x / v[i].w;
    ys[i] = v[i].y / v[i].w;
  }
  const auto [min_x, max_x] = std::minmax_element(xs.begin(), xs.end());
  const auto [min_y, max_y] = std::minmax_element(ys.begin(), ys.end());
  const Rational px(x);
  const Rational py(y);
  const Rational tx(latitude.x);
  const Rational ty(latitude.y);
  return px < *min_x - tx || px > *max_x + tx || py < *min_y - ty || py > *max_y + ty;
}

double exact_depth(const Triangle& triangle, double x, double y) {
  const auto& clip = triangle.vertices();
  const VkViewport& viewport = triangle.viewport();
  const auto v = framebuffer_from_clip(clip, viewport);
  const std::array<Rational, 3> z{Rational(clip[0][2]), Rational(clip[1][2]), Rational(clip[2][2])};
  const Rational z_ndc = combination(edges(v), z).at(Rational(x), Rational(y)) / determinant(v);
  const Rational min_depth(viewport.minDepth);
  const Rational max_depth(viewport.maxDepth);
  if (triangle.volume().negative_one_to_one) {
    return nearest_double((z_ndc * (max_depth - min_depth) + max_depth + min_depth) / 2);
  }
  return nearest_double(z_ndc * (max_depth - min_depth) + min_depth);
}

double exact_reciprocal_w(const Triangle& triangle, double x, double y) {
  const auto v = framebuffer_from_clip(triangle.vertices(), triangle.viewport());
  const std::array<Rational, 3> ones{1, 1, 1};
  return nearest_double(combination(edges(v), ones).at(Rational(x), Rational(y)) / determinant(v));
}

double exact_smooth(const Triangle& triangle, std::array<float, 3> q, double x, double y) {
  const auto edge = edges(framebuffer_from_clip(triangle.vertices(), triangle.viewport()));
  const std::array<Rational, 3> values{Rational(q[0]), Rational(q[1]), Rational(q[2])};
  const std::array<Rational, 3> ones{1, 1, 1};
  const Rational px(x);
  const Rational py(y);
  return nearest_double(combination(edge, values).at(px, py) / combination(edge, ones).at(px, py));
}

double exact_noperspective(const Triangle& triangle, std::array<float, 3> q, double x, double y) {
  const auto v = framebuffer_from_clip(triangle.vertices(), triangle.viewport());
  std::array<Rational, 3> values;
  for (size_t i = 0; i < 3; ++i) values[i] = Rational(q[i]) * v[i].w;
  return nearest_double(combination(edges(v), values).at(Rational(x), Rational(y)) / determinant(v));
}

bool exactly_on_grid(const Triangle& triangle, uint32_t subpixel_bits) {
  const auto v = framebuffer_from_clip(triangle.vertices(), triangle.viewport());
  const Rational step = Rational(1) / (1U << subpixel_bits);
  return std::all_of(v.begin(), v.end(),
                     [&](const Vector& p) { return multiple_of(p.x / p.w, step) && multiple_of(p.y / p.w, step); });
}

}  // namespace fillrule::exact
