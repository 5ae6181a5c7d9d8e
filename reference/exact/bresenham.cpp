#include "reference/exact/bresenham.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reference/exact/line.h"

namespace fillrule::exact {
namespace {

// Doubles decide what is further away than this; see line.cpp.
constexpr double kSlack = 0x1p-30;
constexpr double kLargestWidth = 0x1p20;  // pixels; no target is larger

// The columns that a line which ascends through `major` has behind it: all before the pixel's own, and that one too
// if its diamond's far side is. `minor_distance` is how far the point is from the row's centre.
int64_t columns_left(double major, double minor_distance) {
  const double column = std::floor(major);
  const bool exited = major - (column + 0.5) > 0.5 - minor_distance;
  return static_cast<int64_t>(column) + (exited ? 1 : 0);
}

// The least and the largest distance from the row's centre within `reach` of `minor`.
std::array<double, 2> minor_distances(double minor, double reach) {
  const auto distance = [](double position) { return std::abs(position - std::floor(position) - 0.5); };
  const double a = distance(minor - reach);
  const double b = distance(minor + reach);
  const bool over_centre = std::floor(minor - reach - 0.5) != std::floor(minor + reach - 0.5);
  const bool over_border = std::floor(minor - reach) != std::floor(minor + reach);
  return {over_centre ? 0 : std::min(a, b), over_border ? 0.5 : std::max(a, b)};
}

CountRange columns_left_range(double major, double minor, double reach_major, double reach_minor) {
  const auto [least, most] = minor_distances(minor, reach_minor);
  return {.least = columns_left(major - reach_major, least), .most = columns_left(major + reach_major, most)};
}

int64_t floor_div(int64_t a, int64_t b) {
  return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}

// The exact rule, in units of half a subpixel step so that pixel centres are integers. Ties are resolved by the
// perturbation that the specification prescribes: both ends move by (-e, -e^2), e small.
struct GridLine {
  int64_t unit = 0;  // of a pixel
  int64_t ax = 0, ay = 0, bx = 0, by = 0;

  // Perturbed, a point on the border of two pixels belongs to the one before.
  [[nodiscard]] int64_t pixel(int64_t position) const { return floor_div(position - 1, unit); }
  [[nodiscard]] int64_t centre(int64_t pixel) const { return pixel * unit + unit / 2; }

  // Whether the point is on the far side of its pixel's diamond, in the direction (sign) of the major axis.
  [[nodiscard]] bool exited(int64_t x, int64_t y, bool x_major, int sign) const {
    const int64_t dx = x - centre(pixel(x));
    const int64_t dy = y - centre(pixel(y));
    const int64_t excess = std::abs(dx) + std::abs(dy) - unit / 2;
    const int64_t major = x_major ? dx : dy;
    // Moving by -e takes a point on the centre line to its lower side.
    const bool beyond_centre = sign > 0 ? major > 0 : major <= 0;
    // On the diamond's edge the first-order move decides: towards smaller x, into the diamond from the right.
    return beyond_centre && (excess > 0 || (excess == 0 && dx <= 0));
  }

  [[nodiscard]] bool makes(int64_t px, int64_t py, bool x_major) const {
    const int64_t major_a = x_major ? ax : ay;
    const int64_t major_b = x_major ? bx : by;
    const int64_t minor_a = x_major ? ay : ax;
    const int64_t minor_b = x_major ? by : bx;
    const int sign = major_b > major_a ? 1 : -1;
    const int64_t column = x_major ? px : py;
    const int64_t first = pixel(major_a) + (exited(ax, ay, x_major, sign) ? sign : 0);
    const int64_t last = pixel(major_b) + (exited(bx, by, x_major, sign) ? sign : 0);  // not drawn any more
    if (sign > 0 ? column < first || column >= last : column > first || column <= last) return false;
    // The row where the line crosses the column's centre: minor_a + slope (centre - major_a).
    const int64_t run = sign * (major_b - major_a);
    const int64_t rise = sign * (minor_b - minor_a);
    const int64_t crossing = minor_a * run + rise * (centre(column) - major_a);
    // Perturbed, an x-major line on a row border goes to the row before unless it climbs towards larger y: it is
    // moved by slope e - e^2; a y-major one by -e.
    const bool to_next = x_major && rise > 0;
    const int64_t row = to_next ? floor_div(crossing, run * unit) : floor_div(crossing - 1, run * unit);
    return row == (x_major ? py : px);
  }
};

// The grid that owns() computes on is finer than any subpixel grid that on_grid() is asked about: 2^-13 px, in a
// framebuffer of up to 2^15 px, which keeps all products within 60 bits.
constexpr uint32_t kFinestBits = 12;
constexpr double kLargestPosition = 0x1p15;

// The position, if it is a double at all.
std::optional<double> exact_position(double homogeneous, double w, double centre) {
  const double from_centre = homogeneous / w;
  if (std::fma(from_centre, w, -homogeneous) != 0 || !sum_is_exact(from_centre, centre)) return std::nullopt;
  return from_centre + centre;
}

int64_t grid_units(double homogeneous, double w, double centre) {
  return static_cast<int64_t>(std::ldexp(homogeneous / w + centre, kFinestBits + 1));
}

}  // namespace

BresenhamLine::BresenhamLine(const Segment& segment, float width) : segment_(segment) {
  undefined_width_ = !(width > 0);
  if (!undefined_width_) {
    const double exact = std::min(double{width}, kLargestWidth);
    width_least_ = std::max<int64_t>(1, static_cast<int64_t>(std::ceil(exact - 0.5)));
    width_most_ = std::max<int64_t>(1, static_cast<int64_t>(std::floor(exact + 0.5)));
  }
  if (segment.undefined() || !segment.unbounded()) return;
  const SegmentPart& part = *segment.unbounded();
  bounded_ = std::isfinite(part.length());
  slop_ = std::max(part.begin.slop, part.end.slop) + part.begin.error + part.end.error;
  begin_ = {.x = part.begin.x + segment.centre_x(), .y = part.begin.y + segment.centre_y()};
  end_ = {.x = part.end.x + segment.centre_x(), .y = part.end.y + segment.centre_y()};
  x_major_ = std::abs(segment.direction_x()) >= std::abs(segment.direction_y());
  ascending_ = (x_major_ ? segment.direction_x() : segment.direction_y()) > 0;
}

// Rounding the ends changes both extents by twice the latitude at most.
bool BresenhamLine::maybe_major(bool x_major, const Latitude& latitude) const {
  const SegmentPart& part = segment_.clipped() ? *segment_.clipped() : *segment_.unbounded();
  const double excess = (std::abs(segment_.direction_x()) - std::abs(segment_.direction_y())) * part.length();
  return (x_major ? excess : -excess) >= -2 * (latitude.x + latitude.y + slop_) - kSlack;
}

bool BresenhamLine::has_rules(const Latitude& latitude) const {
  return !undefined() && inside_volume() && width_least_ == width_most_ &&
         maybe_major(true, latitude) != maybe_major(false, latitude);
}

// Every fragment is in a column that the segment reaches, in the row of its crossing with the column's centre (a
// segment that begins beyond the centre, inside of a diamond, would have crossed it in the same row).
bool BresenhamLine::near_fragment(bool x_major, double x, double y, const Latitude& latitude) const {
  const double pixel_major = std::floor(x_major ? x : y);
  const double pixel_minor = std::floor(x_major ? y : x);
  const double reach_major = (x_major ? latitude.x : latitude.y) + slop_ + kSlack;
  const double reach_minor = (x_major ? latitude.y : latitude.x) + slop_ + kSlack;
  const double begin = x_major ? begin_.x : begin_.y;
  const double end = x_major ? end_.x : end_.y;
  const double first = std::floor(std::min(begin, end) - reach_major);
  const double last = std::floor(std::max(begin, end) + reach_major);
  const double centre_major = x_major ? segment_.centre_x() : segment_.centre_y();
  const double centre_minor = x_major ? segment_.centre_y() : segment_.centre_x();
  const double d_major = x_major ? segment_.direction_x() : segment_.direction_y();
  const double d_minor = x_major ? segment_.direction_y() : segment_.direction_x();
  const double slope = d_minor / d_major;
  // At most half a pixel beyond an end, which moves by so much more than the end itself.
  const double length = std::abs(end - begin);
  const double moved = (reach_minor + std::min(std::abs(slope), 2.0) * reach_major) * (1 + 2 / std::max(length, 1.0));
  for (const double column : {pixel_major - 1, pixel_major, pixel_major + 1}) {
    if (column < first || column > last) continue;
    const double at = column + 0.5 - centre_major;
    // The point of the line whose major coordinate is `at`: distance() is linear.
    const double off = x_major ? segment_.distance(at, 0) : segment_.distance(0, at);
    const double crossing = centre_minor + (x_major ? -off : off) / d_major;
    const double low = std::floor(crossing - static_cast<double>(width_most_ - 1) / 2 - moved) - 1;
    const double high = std::floor(crossing - static_cast<double>(width_least_ - 1) / 2 + moved) + 1 +
                        static_cast<double>(width_most_ - 1);
    if (pixel_minor >= low && pixel_minor <= high) return true;
  }
  return false;
}

Classification BresenhamLine::classify(double x, double y, const Latitude& latitude, DoubtBits /*undecided*/) const {
  constexpr Classification kMaybe{.coverage = Coverage::kMay, .doubt = kDoubtShape};
  const double column = std::floor(x) + 0.5;
  const double row = std::floor(y) + 0.5;
  if (undefined()) {
    const bool outside = classify_viewport(segment_.viewport(), column, row, latitude) == Coverage::kMustNot;
    return outside ? Classification{} : kMaybe;
  }
  if (!segment_.unbounded()) return {};
  // A fragment may deviate by one pixel; across the window's borders as anywhere. A wide line's others may be outside
  // if their line is inside.
  const bool may_stick_out = width_most_ > 1 && segment_.clipped();
  const Latitude pixel{.x = 1, .y = 1};
  if (!may_stick_out && classify_viewport(segment_.viewport(), column, row, pixel) == Coverage::kMustNot) return {};
  if (segment_.is_point() || !bounded_) {
    // Without length any direction, without end no place: the box around it.
    const std::array<double, 4> box = bounds(latitude);
    return column > box[0] && row > box[1] && column < box[2] && row < box[3] ? kMaybe : Classification{};
  }
  for (const bool x_major : {true, false}) {
    if (maybe_major(x_major, latitude) && near_fragment(x_major, column, row, latitude)) return kMaybe;
  }
  return {};
}

BlockClassification BresenhamLine::classify_block(const Block& block, const Latitude& latitude,
                                                  DoubtBits /*undecided*/) const {
  if (undefined() || segment_.is_point() || !bounded_) return {};
  if (!segment_.unbounded()) return {.coverage = Coverage::kMustNot};
  const double distance = std::abs(segment_.distance(block.x - segment_.centre_x(), block.y - segment_.centre_y()));
  // Three pixels: to the fragment, to the one that it may deviate to, and to spare.
  const double reach =
      block.half_width + block.half_height + static_cast<double>(width_most_) + 3 + latitude.x + latitude.y + slop_;
  return {.coverage = distance > reach ? Coverage::kMustNot : Coverage::kMay};
}

std::array<double, 4> BresenhamLine::bounds(const Latitude& latitude) const {
  const VkViewport& viewport = segment_.viewport();
  const double reach = static_cast<double>(width_most_) / 2 + 2 + latitude.x + latitude.y + std::min(slop_, 1e6);
  const auto left = double{viewport.x};
  const double top = std::min(double{viewport.y}, double{viewport.y} + double{viewport.height});
  std::array<double, 4> box{left - reach, top - reach, left + double{viewport.width} + reach,
                            top + std::abs(double{viewport.height}) + reach};
  if (bounded_) {
    box = {std::max(box[0], std::min(begin_.x, end_.x) - reach), std::max(box[1], std::min(begin_.y, end_.y) - reach),
           std::min(box[2], std::max(begin_.x, end_.x) + reach),
           std::min(box[3], std::max(begin_.y, end_.y) + reach)};
  }
  return box;
}

CountRange BresenhamLine::columns(const Latitude& latitude) const {
  const auto left_behind = [&](const End& end) {
    const double shift = static_cast<double>(width_most_ - 1) / 2;
    const double major = x_major_ ? end.x : end.y;
    const double minor = (x_major_ ? end.y : end.x) - shift;
    const double reach_major = (x_major_ ? latitude.x : latitude.y) + slop_ + kSlack;
    const double reach_minor = (x_major_ ? latitude.y : latitude.x) + slop_ + kSlack;
    // A line that descends does as its mirror image ascending.
    return columns_left_range(ascending_ ? major : -major, minor, reach_major, reach_minor);
  };
  const CountRange before_begin = left_behind(begin_);
  const CountRange before_end = left_behind(end_);
  return {.least = std::max<int64_t>(0, before_end.least - before_begin.most),
          .most = std::max<int64_t>(0, before_end.most - before_begin.least)};
}

bool BresenhamLine::on_grid(uint32_t subpixel_bits) const {
  if (undefined() || !inside_volume() || subpixel_bits > kFinestBits) return false;
  for (size_t i = 0; i < 2; ++i) {
    const auto x = exact_position(segment_.u(i), segment_.w(i), segment_.centre_x());
    const auto y = exact_position(segment_.v(i), segment_.w(i), segment_.centre_y());
    for (const std::optional<double>& position : {x, y}) {
      if (!position || std::abs(*position) > kLargestPosition) return false;
      const double steps = std::ldexp(*position, static_cast<int>(subpixel_bits));
      if (steps != std::nearbyint(steps)) return false;
    }
  }
  return true;
}

bool BresenhamLine::owns(double x, double y) const {
  if (segment_.is_point()) return false;
  GridLine line{.unit = int64_t{1} << (kFinestBits + 1),
                .ax = grid_units(segment_.u(0), segment_.w(0), segment_.centre_x()),
                .ay = grid_units(segment_.v(0), segment_.w(0), segment_.centre_y()),
                .bx = grid_units(segment_.u(1), segment_.w(1), segment_.centre_x()),
                .by = grid_units(segment_.v(1), segment_.w(1), segment_.centre_y())};
  const bool x_major = std::abs(line.bx - line.ax) >= std::abs(line.by - line.ay);
  const int64_t shift = (width_most_ - 1) * line.unit / 2;
  (x_major ? line.ay : line.ax) -= shift;
  (x_major ? line.by : line.bx) -= shift;
  const auto column = static_cast<int64_t>(std::floor(x));
  const auto row = static_cast<int64_t>(std::floor(y));
  for (int64_t i = 0; i < width_most_; ++i) {
    if (line.makes(column - (x_major ? 0 : i), row - (x_major ? i : 0), x_major)) return true;
  }
  return false;
}

}  // namespace fillrule::exact
