#include "renderer/bresenham_line.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdlib>

#include "renderer/row_masks.h"
#include "renderer/stepped_quotient.h"

namespace fillrule::renderer {
namespace {

// value + e * first + e^2 * second for an e so small that any difference in `value` outweighs `first`, and so on.
struct Perturbed {
  int64_t value;
  int64_t first;
  int64_t second;

  friend Perturbed operator+(const Perturbed& a, const Perturbed& b) {
    return {a.value + b.value, a.first + b.first, a.second + b.second};
  }
  friend Perturbed operator-(const Perturbed& a, const Perturbed& b) {
    return {a.value - b.value, a.first - b.first, a.second - b.second};
  }
  auto operator<=>(const Perturbed&) const = default;  // NOLINT(modernize-use-nullptr): mistakes the 0 within
};

Perturbed exactly(int64_t value) {
  return {value, 0, 0};
}

int64_t half_pixel(uint32_t subpixel_bits) {
  return pixel_centre_fixed(subpixel_bits).x_fixed;
}

struct PerturbedPosition {
  Perturbed major;
  Perturbed minor;
};

// The segment with its major direction first, moved to where the first pixel of each row or column is.
struct Segment {
  PerturbedPosition a;
  PerturbedPosition b;
};

Segment segment_of(const BresenhamLine& line, uint32_t subpixel_bits) {
  const int64_t offset = int64_t{line.width - 1} * half_pixel(subpixel_bits);
  const bool x_major = is_x_major(line);
  const auto moved = [&](const FixedPosition& end) -> PerturbedPosition {
    const Perturbed x{end.x_fixed, -1, 0};
    const Perturbed y{end.y_fixed, 0, -1};
    return x_major ? PerturbedPosition{x, y - exactly(offset)} : PerturbedPosition{y, x - exactly(offset)};
  };
  return {moved(line.a), moved(line.b)};
}

// floor(coordinate / pixel): an infinitely small bit less than a border is the pixel before it.
int64_t pixel_of(const Perturbed& coordinate, uint32_t subpixel_bits) {
  const bool is_below = coordinate < exactly(coordinate.value);
  return (coordinate.value - (is_below ? 1 : 0)) >> subpixel_bits;
}

// The ends as seen from a pixel's centre, along the two diagonals: there the diamond is the square |s|, |d| < half.
bool meets_diamond(const Segment& segment, int64_t major, int64_t minor, uint32_t subpixel_bits) {
  const int64_t half = half_pixel(subpixel_bits);
  const Perturbed centre_major = exactly((major << subpixel_bits) + half);
  const Perturbed centre_minor = exactly((minor << subpixel_bits) + half);
  const Perturbed inside = exactly(half);
  const Perturbed minus_inside = exactly(-half);
  const auto sum = [&](const PerturbedPosition& end) {
    return end.major - centre_major + (end.minor - centre_minor);
  };
  const auto difference = [&](const PerturbedPosition& end) {
    return end.major - centre_major - (end.minor - centre_minor);
  };
  const auto reaches = [&](const Perturbed& from, const Perturbed& to) {
    return std::max(from, to) > minus_inside && std::min(from, to) < inside;
  };
  const auto is_within = [&](const Perturbed& value) { return value > minus_inside && value < inside; };
  // The line itself crosses the diamond's middle; so only the ends can keep the segment from meeting it.
  const bool meets = reaches(sum(segment.a), sum(segment.b)) && reaches(difference(segment.a), difference(segment.b));
  return meets && !(is_within(sum(segment.b)) && is_within(difference(segment.b)));
}

// From `major` on, the pixel in the minor direction where the line crosses the middle of the pixels with that major
// coordinate:
//   minor = floor(N / (d_major * P)),  N = a.minor * d_major + (major * P + P/2 - a.major) * d_minor,  d_major > 0
// N steps by d_minor * P, hence floor(floor(N / P) / d_major) is the same. The infinitely small parts of N decide
// only where N / P / d_major is whole: then a negative one means the pixel before.
SteppedQuotient crossings(const Segment& segment, int64_t major, uint32_t subpixel_bits) {
  const int64_t sign = segment.b.major.value < segment.a.major.value ? -1 : 1;
  const int64_t d_major = sign * (segment.b.major.value - segment.a.major.value);
  const int64_t d_minor = sign * (segment.b.minor.value - segment.a.minor.value);
  const auto weighted = [&](int64_t from_major, int64_t from_minor) {
    return from_minor * d_major - from_major * d_minor;
  };
  const int64_t from_middle = segment.a.major.value - (major << subpixel_bits) - half_pixel(subpixel_bits);
  const Perturbed numerator{weighted(from_middle, segment.a.minor.value),
                            weighted(segment.a.major.first, segment.a.minor.first),
                            weighted(segment.a.major.second, segment.a.minor.second)};
  return {pixel_of(numerator, subpixel_bits), d_minor, d_major};
}

// Calls visit(major, first minor) for each of the line's pixels from major `begin` to before `end`.
template <typename Visit>
void for_each_pixel(const Segment& segment, uint32_t subpixel_bits, int64_t begin, int64_t end, const Visit& visit) {
  if (segment.a.major.value == segment.b.major.value) {
    return;  // a line without length exits no diamond
  }
  const auto [low, high] = std::minmax(segment.a.major, segment.b.major);
  const int64_t first = pixel_of(low, subpixel_bits);
  const int64_t last = pixel_of(high, subpixel_bits);
  begin = std::max(begin, first);
  end = std::min(end, last + 1);
  if (begin >= end) {
    return;
  }
  SteppedQuotient minor = crossings(segment, begin, subpixel_bits);
  for (int64_t major = begin; major < end; ++major) {
    const bool is_at_end = major == first || major == last;
    if (!is_at_end || meets_diamond(segment, major, minor.value(), subpixel_bits)) {
      visit(major, minor.value());
    }
    minor.step();
  }
}

}  // namespace

uint32_t bresenham_width(float line_width) {
  return static_cast<uint32_t>(std::max(1.0F, std::floor(line_width + 0.5F)));
}

bool is_x_major(const BresenhamLine& line) {
  return std::abs(int64_t{line.b.x_fixed} - line.a.x_fixed) >= std::abs(int64_t{line.b.y_fixed} - line.a.y_fixed);
}

PixelRect bounding_pixels(const BresenhamLine& line, uint32_t subpixel_bits) {
  const auto extent = static_cast<int32_t>(line.width / 2 + 1);
  const auto [x_min, x_max] = std::minmax(line.a.x_fixed, line.b.x_fixed);
  const auto [y_min, y_max] = std::minmax(line.a.y_fixed, line.b.y_fixed);
  return {(x_min >> subpixel_bits) - extent, (y_min >> subpixel_bits) - extent, (x_max >> subpixel_bits) + extent + 1,
          (y_max >> subpixel_bits) + extent + 1};
}

void cover_by_diamond_exit(const BresenhamLine& line, uint32_t subpixel_bits, const PixelRect& rect,
                           TileCoverage& coverage) {
  const Segment segment = segment_of(line, subpixel_bits);
  RowMasks masks(rect);
  if (is_x_major(line)) {
    for_each_pixel(segment, subpixel_bits, rect.left, rect.right, [&](int64_t x, int64_t y) {
      const int64_t end = std::min<int64_t>(y + line.width, rect.bottom);
      for (int64_t row = std::max<int64_t>(y, rect.top); row < end; ++row) {
        masks.set(static_cast<int32_t>(row), x, x + 1);
      }
    });
  } else {
    for_each_pixel(segment, subpixel_bits, rect.top, rect.bottom,
                   [&](int64_t y, int64_t x) { masks.set(static_cast<int32_t>(y), x, x + line.width); });
  }
  masks.to_blocks(coverage);
}

}  // namespace fillrule::renderer
