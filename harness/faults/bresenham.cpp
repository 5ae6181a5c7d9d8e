#include "harness/faults/bresenham.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace fillrule::faults {
namespace {

// Both ends are moved by (-e, -e^2), with e so small that it decides nothing but ties: a number is n + first e +
// second e^2.
struct Perturbed {
  __int128 number = 0;
  __int128 first = 0;
  __int128 second = 0;

  [[nodiscard]] int sign() const {
    for (const __int128 part : {number, first, second}) {
      if (part != 0) return part > 0 ? 1 : -1;
    }
    return 0;
  }
};

Perturbed operator-(const Perturbed& a, const Perturbed& b) {
  return {.number = a.number - b.number, .first = a.first - b.first, .second = a.second - b.second};
}

struct Diamond {
  int64_t x = 0;
  int64_t y = 0;
  int64_t radius = 0;
};

// x + y and x - y of a perturbed end; the diamond is |x + y| < radius and |x - y| < radius around its centre.
struct Turned {
  Perturbed sum;
  Perturbed difference;
};

Turned turned(const Snapped& end, const Diamond& diamond, int e) {
  return {.sum = {.number = end.x - diamond.x + end.y - diamond.y, .first = -e, .second = -e},
          .difference = {.number = (end.x - diamond.x) - (end.y - diamond.y), .first = -e, .second = e}};
}

bool below(const Perturbed& value, int64_t limit) {
  return (value - Perturbed{.number = limit}).sign() < 0;
}

bool above(const Perturbed& value, int64_t limit) {
  return (value - Perturbed{.number = limit}).sign() > 0;
}

bool overlaps(const Perturbed& a, const Perturbed& b, int64_t radius) {
  return !(above(a, radius) && above(b, radius)) && !(below(a, -radius) && below(b, -radius));
}

bool contains(const Snapped& end, const Diamond& diamond, int e) {
  const auto [sum, difference] = turned(end, diamond, e);
  return below(sum, diamond.radius) && above(sum, -diamond.radius) && below(difference, diamond.radius) &&
         above(difference, -diamond.radius);
}

// On which side of the line the point is, the line being perturbed.
int side(const Snapped& a, const Snapped& b, int64_t x, int64_t y, int e) {
  const __int128 dx = b.x - a.x;
  const __int128 dy = b.y - a.y;
  return Perturbed{.number = dx * (y - a.y) - dy * (x - a.x), .first = -dy * e, .second = dx * e}.sign();
}

// Two convex shapes meet unless a line along a side of one of them keeps them apart.
bool meets(const Snapped& a, const Snapped& b, const Diamond& diamond, int e) {
  const Turned from = turned(a, diamond, e);
  const Turned to = turned(b, diamond, e);
  if (!overlaps(from.sum, to.sum, diamond.radius)) return false;
  if (!overlaps(from.difference, to.difference, diamond.radius)) return false;
  const std::array<int, 4> sides{
      side(a, b, diamond.x - diamond.radius, diamond.y, e), side(a, b, diamond.x + diamond.radius, diamond.y, e),
      side(a, b, diamond.x, diamond.y - diamond.radius, e), side(a, b, diamond.x, diamond.y + diamond.radius, e)};
  return std::ranges::min(sides) < 0 && std::ranges::max(sides) > 0;
}

}  // namespace

DiamondExitLine::DiamondExitLine(const Context& context, const Snapped& a, const Snapped& b)
    : context_(context),
      x_major_(std::abs(b.x - a.x) >= std::abs(b.y - a.y)),
      a_{.x = 2 * a.x, .y = 2 * a.y},
      b_{.x = 2 * b.x, .y = 2 * b.y},
      pixel_(int64_t{2} << context.subpixel_bits) {
  if (!context.has(Fault::kLineWidthIgnored)) {
    width_ = std::max<int64_t>(1, static_cast<int64_t>(std::floor(context.state().line_width + 0.5F)));
  }
  const int64_t shift = (width_ - 1) * pixel_ / 2;
  (x_major_ ? a_.y : a_.x) -= shift;
  (x_major_ ? b_.y : b_.x) -= shift;
}

bool DiamondExitLine::leaves_diamond(int64_t x, int64_t y) const {
  const Diamond diamond{.x = x * pixel_ + pixel_ / 2, .y = y * pixel_ + pixel_ / 2, .radius = pixel_ / 2};
  const int e = context_.has(Fault::kLineTies) ? -1 : 1;
  if (context_.has(Fault::kLineStartMissing) && contains(a_, diamond, e)) return false;
  const bool ends_there = contains(b_, diamond, e) && !context_.has(Fault::kLineEndTwice);
  return meets(a_, b_, diamond, e) && !ends_there;
}

bool DiamondExitLine::produces(int64_t x, int64_t y) const {
  for (int64_t i = 0; i < width_; ++i) {
    if (leaves_diamond(x - (x_major_ ? 0 : i), y - (x_major_ ? i : 0))) return true;
  }
  return false;
}

}  // namespace fillrule::faults
