// Tests only: the oracle's answers computed once more, the slow and obvious way, in rationals throughout: vertices
// are projected, edges are lines through two points in the plane, values are planes through three points. No filter,
// no homogeneous edge functions, nothing shared with the oracle but the definition of the latitude.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <optional>

#include "cases/model/case.h"
#include "reference/exact/latitude.h"
#include "reference/exact/triangle.h"

namespace fillrule::exact::obvious {

using Rational = boost::multiprecision::cpp_rational;

struct Point {
  Rational x, y;
};

// a x + b y + c
struct Line {
  Rational a, b, c;
  [[nodiscard]] Rational at(const Point& p) const { return a * p.x + b * p.y + c; }
};

class Oracle {
 public:
  // No vertex may have w = 0 or be undefined.
  Oracle(const std::array<ClipPosition, 3>& vertices, const VkViewport& viewport);

  [[nodiscard]] Coverage classify(double x, double y, const Latitude& latitude) const;
  [[nodiscard]] bool has_area() const { return has_area_; }
  [[nodiscard]] Rational depth(double x, double y) const;
  [[nodiscard]] Rational smooth(const std::array<float, 3>& q, double x, double y) const;
  [[nodiscard]] Rational noperspective(const std::array<float, 3>& q, double x, double y) const;

 private:
  [[nodiscard]] std::array<Rational, 3> barycentric(const Point& p) const;

  VkViewport viewport_;
  std::array<Point, 3> position_;  // projected
  std::array<Rational, 3> z_;      // z / w
  std::array<Rational, 3> w_;
  bool all_in_front_ = true;
  bool has_area_ = false;
  bool crosses_near_ = false;
  bool crosses_far_ = false;
  bool all_behind_near_ = true;
  bool all_beyond_far_ = true;
  std::array<Line, 3> edge_;  // opposite of each vertex; positive inside if has_area_
};

}  // namespace fillrule::exact::obvious
