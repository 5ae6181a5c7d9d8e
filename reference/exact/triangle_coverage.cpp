// What a triangle covers: samples, blocks of them, and the parts of the window it reaches.
#include <algorithm>
#include <cmath>
#include <optional>

#include "reference/exact/rational_triangle.h"
#include "reference/exact/triangle.h"

namespace fillrule::exact {
namespace {

// Rounds only where the centre is no short number.
double offset(double position, double centre) {
  return position - centre;
}

// The part of a convex polygon where the form, plus `reach`, is not negative.
std::vector<Position> clipped(const std::vector<Position>& polygon, const LinearForm& form, double reach) {
  std::vector<Position> result;
  const auto value = [&](const Position& p) { return form.at(p.x, p.y) + reach; };
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Position& a = polygon[i];
    const Position& b = polygon[(i + 1) % polygon.size()];
    const double at_a = value(a);
    const double at_b = value(b);
    if (at_a >= 0) result.push_back(a);
    if ((at_a < 0) == (at_b < 0)) continue;
    const double t = at_a / (at_a - at_b);
    result.push_back({.x = a.x + t * (b.x - a.x), .y = a.y + t * (b.y - a.y)});
  }
  return result;
}

}  // namespace

Coverage Triangle::classify_against(const LinearForm& form, double dx, double dy, const Latitude& latitude,
                                    int exact_form) const {
  const double value = form.at(dx, dy);
  const double reach = form.reach(latitude.x, latitude.y);
  // The last term: dx and dy round where the viewport's centre is no short number.
  const double slack =
      form.error_at(dx, dy) + form.reach_error(latitude.x, latitude.y) +
      form.reach(0x1p-52 * (std::abs(dx) + std::abs(centre_x_)), 0x1p-52 * (std::abs(dy) + std::abs(centre_y_)));
  if (const std::optional<Coverage> coverage = decided(value, reach, slack)) return *coverage;
  return exact_classification(*this, exact_form, dx + centre_x_, dy + centre_y_, latitude);
}

// The distance's sign is found by interpolating it at the sample, or the cut's end points by interpolating along the
// edges: either way it is judged like a value, which rounding moves by u C.
double Triangle::clip_reach(const ClipPlane& plane, double dx, double dy, const Latitude& latitude) const {
  return plane.form.reach(latitude.x, latitude.y) + determinant_ * kUnitRoundoff * plane.quantity.condition(dx, dy) +
         plane.form.error_at(dx, dy);
}

Coverage Triangle::classify_against(const ClipPlane& plane, double dx, double dy, const Latitude& latitude) const {
  const double value = plane.form.at(dx, dy);
  const double reach = clip_reach(plane, dx, dy, latitude);
  if (value > reach) return Coverage::kMust;
  return value < -reach ? Coverage::kMustNot : Coverage::kMay;
}

Coverage Triangle::classify_viewport(double x, double y, const Latitude& latitude) const {
  const double dx = std::abs(offset(x, centre_x_));
  const double dy = std::abs(offset(y, centre_y_));
  const double inside_x = double{viewport_.width} / 2 - dx;
  const double inside_y = std::abs(double{viewport_.height}) / 2 - dy;
  const double slack = 0x1p-50 * (std::abs(x) + std::abs(y) + std::abs(centre_x_) + std::abs(centre_y_) +
                                  double{viewport_.width} + std::abs(double{viewport_.height}));
  const std::optional<Coverage> horizontal = decided(inside_x, latitude.x, slack);
  const std::optional<Coverage> vertical = decided(inside_y, latitude.y, slack);
  if (horizontal && vertical) return std::min(*horizontal, *vertical);
  if (horizontal == Coverage::kMustNot || vertical == Coverage::kMustNot) return Coverage::kMustNot;
  return exact_viewport_classification(viewport_, x, y, latitude);
}

bool Triangle::outside_bounds(double x, double y, const Latitude& latitude) const {
  if (!in_front_) return false;
  const double dx = offset(x, centre_x_);
  const double dy = offset(y, centre_y_);
  const double inside = std::min(
      {dx - min_dx_ + latitude.x, max_dx_ - dx + latitude.x, dy - min_dy_ + latitude.y, max_dy_ - dy + latitude.y});
  const double slack =
      0x1p-50 * (std::abs(dx) + std::abs(dy) + std::abs(centre_x_) + std::abs(centre_y_) +
                 std::max(std::abs(min_dx_), std::abs(max_dx_)) + std::max(std::abs(min_dy_), std::abs(max_dy_)));
  if (inside > slack) return false;
  if (inside < -slack) return true;
  return exact_outside_bounds(*this, x, y, latitude);
}

Classification Triangle::classify(double x, double y, const Latitude& latitude, DoubtBits undecided) const {
  Classification result{.coverage = Coverage::kMust};
  const auto meet = [&result](Coverage coverage, unsigned doubt) {
    result.coverage = std::min(result.coverage, coverage);
    if (coverage == Coverage::kMay) result.doubt = static_cast<DoubtBits>(result.doubt | doubt);
    return coverage != Coverage::kMustNot;
  };
  constexpr Classification kOutside;
  if ((undecided & kDoubtViewport) != 0 && !meet(classify_viewport(x, y, latitude), kDoubtViewport)) return kOutside;
  if (undefined_) return {.coverage = Coverage::kMay, .doubt = kDoubtViewport};
  if (outside_) return kOutside;
  if (orientation_ == 0) return classify_without_area(x, y, latitude);
  const double dx = offset(x, centre_x_);
  const double dy = offset(y, centre_y_);
  for (unsigned i = 0; i < 3; ++i) {
    if ((undecided & (1U << i)) == 0) continue;
    if (!meet(classify_against(edges_[i], dx, dy, latitude, static_cast<int>(i)), 1U << i)) return kOutside;
  }
  const bool ask_near = needs_near_ && (undecided & kDoubtNear) != 0;
  const bool ask_far = needs_far_ && (undecided & kDoubtFar) != 0;
  if (ask_near && !meet(classify_against(near_, dx, dy, latitude, kNear), kDoubtNear)) return kOutside;
  if (ask_far && !meet(classify_against(far_, dx, dy, latitude, kFar), kDoubtFar)) return kOutside;
  for (const ClipPlane& plane : clip_planes_) {
    const unsigned boundary = unsigned{kDoubtClipPlane0} << plane.number;
    if ((undecided & boundary) == 0) continue;
    if (!meet(classify_against(plane, dx, dy, latitude), boundary)) return kOutside;
  }
  if (result.coverage == Coverage::kMay && outside_bounds(x, y, latitude)) return kOutside;
  return result;
}

// With no area the triangle is a segment, which rounding may open into a sliver: samples within the latitude of it,
// hence within the latitude of all three edges' lines and of its bounding box, may be covered.
Classification Triangle::classify_without_area(double x, double y, const Latitude& latitude) const {
  const double dx = offset(x, centre_x_);
  const double dy = offset(y, centre_y_);
  for (int i = 0; i < 3; ++i) {
    const Coverage side = classify_against(edges_[static_cast<size_t>(i)], dx, dy, latitude, i);
    if (side != Coverage::kMay) return {};
  }
  return outside_bounds(x, y, latitude) ? Classification{}
                                        : Classification{.coverage = Coverage::kMay, .doubt = kDoubtEdges};
}

BlockClassification Triangle::classify_block(const Block& block, const Latitude& latitude,
                                             DoubtBits undecided) const {
  if (undefined_ || orientation_ == 0) return {};
  if (outside_) return {.coverage = Coverage::kMustNot};
  const double dx = offset(block.x, centre_x_);
  const double dy = offset(block.y, centre_y_);
  const double far_dx = std::abs(dx) + block.half_width;
  const double far_dy = std::abs(dy) + block.half_height;
  unsigned open = 0;
  // A millionth of a pixel covers the rounding of these few operations on coordinates within the viewport.
  const bool inside_viewport = double{viewport_.width} / 2 - far_dx > latitude.x + 0x1p-20 &&
                               std::abs(double{viewport_.height}) / 2 - far_dy > latitude.y + 0x1p-20;
  if (!inside_viewport) open |= undecided & kDoubtViewport;
  // False if the whole block is outside.
  const auto meet = [&](const LinearForm& form, unsigned boundary) {
    if ((undecided & boundary) == 0) return true;
    const double value = form.at(dx, dy);
    const double radius = form.reach(block.half_width + latitude.x, block.half_height + latitude.y);
    const double slack =
        form.error_at(far_dx, far_dy) * 2 + 0x1p-48 * radius +
        form.reach(0x1p-51 * (far_dx + std::abs(centre_x_)), 0x1p-51 * (far_dy + std::abs(centre_y_)));
    if (!(value > radius + slack)) open |= boundary;
    return value >= -radius - slack;
  };
  constexpr BlockClassification kOutside{.coverage = Coverage::kMustNot};
  for (unsigned i = 0; i < 3; ++i) {
    if (!meet(edges_[i], 1U << i)) return kOutside;
  }
  if (needs_near_ && !meet(near_, kDoubtNear)) return kOutside;
  if (needs_far_ && !meet(far_, kDoubtFar)) return kOutside;
  for (const ClipPlane& plane : clip_planes_) {
    const unsigned boundary = unsigned{kDoubtClipPlane0} << plane.number;
    if ((undecided & boundary) == 0) continue;
    // The reach is a convex function of the position: largest at a corner.
    double reach = 0;
    for (const double x : {dx - block.half_width, dx + block.half_width}) {
      for (const double y : {dy - block.half_height, dy + block.half_height}) {
        reach = std::max(reach, clip_reach(plane, x, y, latitude));
      }
    }
    reach += plane.form.reach(block.half_width, block.half_height) * (1 + 0x1p-48);
    const double value = plane.form.at(dx, dy);
    if (value < -reach) return kOutside;
    if (!(value > reach)) open |= boundary;
  }
  return {.coverage = open == 0 ? Coverage::kMust : Coverage::kMay, .undecided = static_cast<DoubtBits>(open)};
}

int Triangle::side_of(int edge_number, double dx, double dy) const {
  const LinearForm& edge = edges_[static_cast<size_t>(edge_number)];
  const double value = edge.at(dx, dy);
  const double slack = edge.error_at(dx, dy) + edge.reach(0x1p-52 * (std::abs(dx) + std::abs(centre_x_)),
                                                          0x1p-52 * (std::abs(dy) + std::abs(centre_y_)));
  if (std::abs(value) > slack) return value > 0 ? 1 : -1;
  const bool exact_position = centre_is_short_ && sum_is_exact(dx, centre_x_) && sum_is_exact(dy, centre_y_);
  if (exact_position && evaluates_exactly(edge, dx, dy)) return value > 0 ? 1 : (value < 0 ? -1 : 0);
  return exact_side(*this, edge_number, dx + centre_x_, dy + centre_y_);
}

bool Triangle::owns(double x, double y) const {
  const double dx = offset(x, centre_x_);
  const double dy = offset(y, centre_y_);
  for (int i = 0; i < 3; ++i) {
    const LinearForm& edge = edges_[static_cast<size_t>(i)];
    const int side = side_of(i, dx, dy);
    // (a, b) points inside: a left edge has the inside to its right, a top edge is horizontal with the inside below.
    const bool top_left = edge.a > 0 || (edge.a == 0 && edge.b > 0);
    if (side < 0 || (side == 0 && !top_left)) return false;
  }
  return true;
}

bool Triangle::on_grid(uint32_t subpixel_bits) const {
  if (undefined_ || !in_front_) return false;
  if (!centre_is_short_) return exactly_on_grid(*this, subpixel_bits);
  const double steps = std::ldexp(1.0, static_cast<int>(subpixel_bits));
  const auto is_on_grid = [steps](double homogeneous, double w, double centre) {
    const double position = homogeneous / w;
    // Positions of the grid, less a short centre, are doubles: a quotient that is none is not on the grid.
    if (std::fma(position, w, -homogeneous) != 0 || !sum_is_exact(position, centre)) return false;
    return std::nearbyint((position + centre) * steps) == (position + centre) * steps;
  };
  for (size_t i = 0; i < 3; ++i) {
    if (!is_on_grid(u_[i], w(i), centre_x_) || !is_on_grid(v_[i], w(i), centre_y_)) return false;
  }
  return true;
}

std::array<double, 4> Triangle::bounds(const Latitude& latitude) const {
  const double half_width = double{viewport_.width} / 2;
  const double half_height = std::abs(double{viewport_.height}) / 2;
  std::array<double, 4> box{-half_width, -half_height, half_width, half_height};
  if (!undefined_ && in_front_) {
    box = {std::max(box[0], min_dx_), std::max(box[1], min_dy_), std::min(box[2], max_dx_),
           std::min(box[3], max_dy_)};
  }
  // A thousandth of a pixel covers the rounding of these few operations on coordinates within the viewport.
  const double grow_x = latitude.x + 0x1p-10;
  const double grow_y = latitude.y + 0x1p-10;
  return {box[0] + centre_x_ - grow_x, box[1] + centre_y_ - grow_y, box[2] + centre_x_ + grow_x,
          box[3] + centre_y_ + grow_y};
}

std::vector<Position> Triangle::visible_part(const Latitude& latitude) const {
  const double half_width = double{viewport_.width} / 2;
  const double half_height = std::abs(double{viewport_.height}) / 2;
  std::vector<Position> polygon =
      part_in({.x = centre_x_, .y = centre_y_, .half_width = half_width, .half_height = half_height}, latitude);
  for (Position& corner : polygon) corner = {.x = corner.x - centre_x_, .y = corner.y - centre_y_};
  if (needs_near_) polygon = clipped(polygon, near_, near_.reach(latitude.x, latitude.y));
  if (needs_far_) polygon = clipped(polygon, far_, far_.reach(latitude.x, latitude.y));
  for (const ClipPlane& plane : clip_planes_) {
    polygon = clipped(polygon, plane.form, plane.form.reach(latitude.x, latitude.y));
  }
  for (Position& corner : polygon) corner = {.x = corner.x + centre_x_, .y = corner.y + centre_y_};
  return polygon;
}

std::vector<Position> Triangle::part_in(const Block& block, const Latitude& latitude) const {
  const double left = block.x - centre_x_ - block.half_width;
  const double top = block.y - centre_y_ - block.half_height;
  const double right = left + 2 * block.half_width;
  const double bottom = top + 2 * block.half_height;
  std::vector<Position> polygon{
      {.x = left, .y = top}, {.x = right, .y = top}, {.x = right, .y = bottom}, {.x = left, .y = bottom}};
  if (!undefined_ && orientation_ != 0) {
    for (const LinearForm& edge : edges_) polygon = clipped(polygon, edge, edge.reach(latitude.x, latitude.y));
  }
  for (Position& corner : polygon) corner = {.x = corner.x + centre_x_, .y = corner.y + centre_y_};
  return polygon;
}

}  // namespace fillrule::exact
