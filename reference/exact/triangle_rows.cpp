#include "reference/exact/triangle_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/exact/rational_triangle.h"

namespace fillrule::exact {
namespace {

// The number of the first of `count` samples at or behind a guessed place.
uint32_t at_or_behind(double place, uint32_t count) {
  if (!(place > 0)) return 0;
  return place < count ? static_cast<uint32_t>(std::ceil(place)) : count;
}

// The first of the samples [begin, end) at which the coverage is `least` or more, by which they are sorted; `end` if
// there is none.
template <typename CoverageAt>
uint32_t first_of(Coverage least, uint32_t guess, uint32_t begin, uint32_t end, const CoverageAt& coverage_at) {
  uint32_t first = std::clamp(guess, begin, end);
  while (first > begin && coverage_at(first - 1) >= least) --first;
  while (first < end && coverage_at(first) < least) ++first;
  return first;
}

}  // namespace

TriangleRows::TriangleRows(const Triangle& triangle, const Latitude& latitude, const Block& samples,
                           DoubtBits undecided)
    : triangle_(&triangle), latitude_(latitude), asks_viewport_((undecided & kDoubtViewport) != 0) {
  for (unsigned i = 0; i < 3; ++i) {
    if ((undecided & (1U << i)) != 0) add(triangle.edge(i), static_cast<int>(i), samples);
  }
  const LinearForm* const near = triangle.near_plane();
  const LinearForm* const far = triangle.far_plane();
  if (near != nullptr && (undecided & kDoubtNear) != 0) add(*near, kNear, samples);
  if (far != nullptr && (undecided & kDoubtFar) != 0) add(*far, kFar, samples);
}

void TriangleRows::add(const LinearForm& form, int number, const Block& samples) {
  Boundary& boundary = boundaries_[count_++];
  boundary = {.form = form, .number = number, .reach = form.reach(latitude_.x, latitude_.y), .falls = form.a < 0};
  const double centre_x = std::abs(triangle_->centre_x());
  const double centre_y = std::abs(triangle_->centre_y());
  const double far_dx = std::abs(samples.x - triangle_->centre_x()) + samples.half_width;
  const double far_dy = std::abs(samples.y - triangle_->centre_y()) + samples.half_height;
  // As of a single sample (Triangle::classify()), of the one that errs most; the factor is for far_dx and far_dy.
  boundary.slack = (form.error_at(far_dx, far_dy) + form.reach_error(latitude_.x, latitude_.y) +
                    form.reach(0x1p-52 * (far_dx + centre_x), 0x1p-52 * (far_dy + centre_y))) *
                   (1 + 0x1p-48);
  const bool is_level = form.a == 0 && form.error_a == 0;
  is_certain_ = is_certain_ && (is_level || std::abs(form.a) > form.error_a);
  boundary.pixels = is_level ? std::numeric_limits<double>::infinity() : 1 / std::abs(form.a);
}

RowCoverage TriangleRows::at(double x, double y, uint32_t count) const {
  RowCoverage row{.may_end = count, .must_end = count};
  if (!is_certain_) return {.may_end = count};
  for (const Boundary& boundary : boundaries()) {
    meet(boundary, x, y, count, row);
    if (row.may_begin == row.may_end) return {};
  }
  if (asks_viewport_) meet_viewport(x, y, row);
  return row;
}

Coverage TriangleRows::coverage_at(const Boundary& boundary, double x, double y) const {
  const double dx = x - triangle_->centre_x();
  const double dy = y - triangle_->centre_y();
  if (const auto coverage = decided(boundary.form.at(dx, dy), boundary.reach, boundary.slack)) return *coverage;
  return exact_classification(*triangle_, boundary.number, x, y, latitude_);
}

void TriangleRows::meet(const Boundary& boundary, double x, double y, uint32_t count, RowCoverage& row) const {
  // Counted in the direction in which the distance rises.
  const bool falls = boundary.falls;
  const auto x_of = [&](uint32_t i) { return x + (falls ? count - 1 - i : i); };
  const auto coverage = [&](uint32_t i) { return coverage_at(boundary, x_of(i), y); };
  const double first = boundary.form.at(x_of(0) - triangle_->centre_x(), y - triangle_->centre_y());
  const auto guess = [&](double distance) { return at_or_behind((distance - first) * boundary.pixels, count); };
  const uint32_t begin = falls ? count - row.may_end : row.may_begin;
  const uint32_t end = falls ? count - row.may_begin : row.may_end;
  const uint32_t may = first_of(Coverage::kMay, guess(-boundary.reach), begin, end, coverage);
  const uint32_t must = first_of(Coverage::kMust, guess(boundary.reach), may, end, coverage);
  if (falls) {
    row.may_end = count - may;
    row.must_end = std::min(row.must_end, count - must);
  } else {
    row.may_begin = may;
    row.must_begin = std::max(row.must_begin, must);
  }
  row.must_begin = std::clamp(row.must_begin, row.may_begin, row.may_end);
  row.must_end = std::clamp(row.must_end, row.must_begin, row.may_end);
}

// The viewport is convex, and there is nearly nothing of the row outside of it. Samples in doubt about it that are
// beyond the triangle's own bounds are outside of both.
void TriangleRows::meet_viewport(double x, double y, RowCoverage& row) const {
  const auto coverage = [&](uint32_t i) { return triangle_->classify(x + i, y, latitude_, kDoubtViewport).coverage; };
  while (row.may_begin < row.may_end && coverage(row.may_begin) == Coverage::kMustNot) ++row.may_begin;
  while (row.may_begin < row.may_end && coverage(row.may_end - 1) == Coverage::kMustNot) --row.may_end;
  row.must_begin = std::clamp(row.must_begin, row.may_begin, row.may_end);
  row.must_end = std::clamp(row.must_end, row.must_begin, row.may_end);
  while (row.must_begin < row.must_end && coverage(row.must_begin) != Coverage::kMust) ++row.must_begin;
  while (row.must_begin < row.must_end && coverage(row.must_end - 1) != Coverage::kMust) --row.must_end;
}

}  // namespace fillrule::exact
