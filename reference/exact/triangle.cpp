#include "reference/exact/triangle.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

#include "reference/exact/clip_position.h"
#include "reference/exact/rational_triangle.h"

namespace fillrule::exact {
namespace {

bool all_of_vertices(const std::array<ClipPosition, 3>& vertices, auto predicate) {
  return std::all_of(vertices.begin(), vertices.end(), predicate);
}

bool any_of_vertices(const std::array<ClipPosition, 3>& vertices, auto predicate) {
  return std::any_of(vertices.begin(), vertices.end(), predicate);
}

// Vulkan lets denormals be flushed to zero, which moves such a triangle onto the plane, where it is drawn.
bool on_plane_by_flushing(const std::array<double, 3>& distances) {
  return std::ranges::all_of(distances, [](double d) { return std::abs(d) < double{FLT_MIN}; }) &&
         std::ranges::any_of(distances, [](double d) { return d < 0; });
}

// Distances of a plane that leave float32 on the way to the cut.
bool distances_leave_float32(const std::array<float, 3>& distances, const std::array<ClipPosition, 3>& vertices) {
  for (size_t i = 0; i < 3; ++i) {
    const double distance{distances[i]};
    const double w = std::abs(double{vertices[i][3]});
    if (!(std::abs(distance) <= double{kLargestCoordinate}) || std::abs(distance) > w * double{FLT_MAX}) return true;
  }
  return on_plane_by_flushing({double{distances[0]}, double{distances[1]}, double{distances[2]}});
}

LinearForm negated(const LinearForm& form) {
  LinearForm result = form;
  result.a = -form.a;
  result.b = -form.b;
  result.c = -form.c;
  return result;
}

// sum q_i edge_i. Each coefficient is a sum of three products of factors that err by 2^-51 (the edge) and 2^-53 (q):
// with the products and two sums rounded it errs by less than 2^-50 of the sum of the absolute terms.
LinearForm combination(const std::array<LinearForm, 3>& edges, std::span<const double, 3> q) {
  LinearForm sum;
  for (size_t i = 0; i < 3; ++i) {
    sum.a += q[i] * edges[i].a;
    sum.b += q[i] * edges[i].b;
    sum.c += q[i] * edges[i].c;
    sum.error_a += std::abs(q[i] * edges[i].a);
    sum.error_b += std::abs(q[i] * edges[i].b);
    sum.error_c += std::abs(q[i] * edges[i].c);
  }
  sum.error_a *= 0x1p-50;
  sum.error_b *= 0x1p-50;
  sum.error_c *= 0x1p-50;
  return sum;
}

// A multiple of 2^-20 px of moderate size: differences from samples and from the subpixel grid are exact.
bool is_short(double position) {
  return std::abs(position) < 0x1p24 && std::nearbyint(position * 0x1p20) == position * 0x1p20;
}

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

Triangle::Triangle(const std::array<ClipPosition, 3>& vertices, const VkViewport& viewport, ClipVolume volume)
    : vertices_(vertices), viewport_(viewport), volume_(std::move(volume)) {
  undefined_ =
      any_of_vertices(vertices, [&](const ClipPosition& p) { return coordinates_leave_float32(p, viewport); }) ||
      (volume_.depth_clip && on_plane_by_flushing({near_distance(0), near_distance(1), near_distance(2)})) ||
      std::ranges::any_of(volume_.distances,
                          [&](const auto& distances) { return distances_leave_float32(distances, vertices_); });
  centre_x_ = double{viewport.x} + double{viewport.width} / 2;
  centre_y_ = double{viewport.y} + double{viewport.height} / 2;
  centre_is_short_ = sum_is_exact(double{viewport.x}, double{viewport.width} / 2) &&
                     sum_is_exact(double{viewport.y}, double{viewport.height} / 2) && is_short(centre_x_) &&
                     is_short(centre_y_);
  in_front_ = all_of_vertices(vertices, [](const ClipPosition& p) { return p[3] > 0; });
  if (undefined_) {
    inside_volume_ = false;
    return;
  }
  set_up_edges();
  set_up_planes();
  set_up_clip_planes();
  if (in_front_) set_up_bounds();
  inside_volume_ = in_front_ && !needs_near_ && !needs_far_ && clip_planes_.empty() &&
                   all_of_vertices(vertices, [](const ClipPosition& p) {
                     return std::abs(p[0]) <= p[3] && std::abs(p[1]) <= p[3];
                   });
}

// Exact in sign; the sum rounds once.
double Triangle::near_distance(size_t vertex) const {
  const auto z = double{vertices_[vertex][2]};
  return volume_.negative_one_to_one ? z + w(vertex) : z;
}

double Triangle::depth_scale() const {
  const double range = double{viewport_.maxDepth} - double{viewport_.minDepth};
  return volume_.negative_one_to_one ? range / 2 : range;
}

double Triangle::depth_offset() const {
  const auto min_depth = double{viewport_.minDepth};
  return volume_.negative_one_to_one ? (double{viewport_.maxDepth} + min_depth) / 2 : min_depth;
}

Projection Triangle::projection() const {
  Projection projection{.centre_x = centre_x_,
                        .centre_y = centre_y_,
                        .width = double{viewport_.width},
                        .height = double{viewport_.height}};
  for (size_t i = 0; i < 3; ++i) {
    projection.x[i] = u_[i] / w(i);
    projection.y[i] = v_[i] / w(i);
  }
  return projection;
}

void Triangle::set_up_edges() {
  for (size_t i = 0; i < 3; ++i) {
    // Products of two float32 numbers: exact in double.
    u_[i] = double{viewport_.width} / 2 * double{vertices_[i][0]};
    v_[i] = double{viewport_.height} / 2 * double{vertices_[i][1]};
  }
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3;
    const size_t k = (i + 2) % 3;
    LinearForm& edge = edges_[i];
    edge.a = difference_of_products(v_[j], w(k), w(j), v_[k]);
    edge.b = difference_of_products(w(j), u_[k], u_[j], w(k));
    edge.c = difference_of_products(u_[j], v_[k], v_[j], u_[k]);
    edge.error_a = difference_error(v_[j], w(k), w(j), v_[k], edge.a);
    edge.error_b = difference_error(w(j), u_[k], u_[j], w(k), edge.b);
    edge.error_c = difference_error(u_[j], v_[k], v_[j], u_[k], edge.c);
  }
  const std::array<double, 3> terms{u_[0] * edges_[0].a, v_[0] * edges_[0].b, w(0) * edges_[0].c};
  const double determinant = terms[0] + terms[1] + terms[2];
  const double error = 0x1p-50 * (std::abs(terms[0]) + std::abs(terms[1]) + std::abs(terms[2]));
  determinant_ = std::abs(determinant);
  orientation_ = determinant > 0 ? 1 : (determinant < 0 ? -1 : 0);
  // On short coordinates nothing was rounded, so that triangles without area need no rationals.
  const LinearForm& edge = edges_[0];
  const bool is_exact = edge.error_a == 0 && edge.error_b == 0 && edge.error_c == 0 &&
                        product_is_exact(u_[0], edge.a) && product_is_exact(v_[0], edge.b) &&
                        product_is_exact(w(0), edge.c) && sum_is_exact(terms[0], terms[1]) &&
                        sum_is_exact(terms[0] + terms[1], terms[2]);
  if (!is_exact && determinant_ <= error) orientation_ = exact_orientation(vertices_, viewport_);
  if (orientation_ == 0) {
    determinant_ = 0;
  } else if (!is_exact && determinant_ * 0x1p-40 <= error) {
    determinant_ = exact_determinant(vertices_, viewport_);
  }
  if (orientation_ < 0) {
    for (LinearForm& edge : edges_) edge = negated(edge);
  }
}

void Triangle::set_up_planes() {
  if (!volume_.depth_clip) return;
  std::array<double, 3> near{};
  std::array<double, 3> far{};
  for (size_t i = 0; i < 3; ++i) {
    near[i] = near_distance(i);
    far[i] = w(i) - double{vertices_[i][2]};
  }
  const auto negative = [](double distance) { return distance < 0; };
  needs_near_ = std::ranges::any_of(near, negative);
  needs_far_ = std::ranges::any_of(far, negative);
  outside_ = std::ranges::all_of(near, [](double distance) { return distance <= -double{FLT_MIN}; }) ||
             std::ranges::all_of(far, negative);
  if (needs_near_) near_ = combination(edges_, near);
  if (needs_far_) far_ = combination(edges_, far);
}

void Triangle::set_up_clip_planes() {
  for (uint32_t number = 0; number < volume_.distances.size(); ++number) {
    const std::array<float, 3>& distances = volume_.distances[number];
    if (std::ranges::none_of(distances, [](float distance) { return distance < 0; })) continue;
    outside_ = outside_ || std::ranges::all_of(distances, [](float distance) { return distance <= -FLT_MIN; });
    std::array<double, 3> d{};
    std::array<double, 3> q{};
    for (size_t i = 0; i < 3; ++i) {
      d[i] = double{distances[i]};
      q[i] = d[i] / w(i);
    }
    if (orientation_ == 0) continue;  // no sample has to be covered anyway
    clip_planes_.push_back(
        {.number = number,
         .form = combination(edges_, d),
         .quantity = WindowLinear(projection(), interpolant(d), q, WindowLinear::Gradient::kFromValues)});
  }
}

void Triangle::set_up_bounds() {
  const std::array<double, 3> dx{u_[0] / w(0), u_[1] / w(1), u_[2] / w(2)};
  const std::array<double, 3> dy{v_[0] / w(0), v_[1] / w(1), v_[2] / w(2)};
  min_dx_ = *std::min_element(dx.begin(), dx.end());
  max_dx_ = *std::max_element(dx.begin(), dx.end());
  min_dy_ = *std::min_element(dy.begin(), dy.end());
  max_dy_ = *std::max_element(dy.begin(), dy.end());
}

bool Triangle::has_equal_vertices() const {
  return vertices_[0] == vertices_[1] || vertices_[1] == vertices_[2] || vertices_[2] == vertices_[0];
}

bool Triangle::orientation_in_doubt(const Latitude& latitude) const {
  if (undefined_ || !in_front_) return true;
  // Vertices of equal bits are rounded alike: without area for certain, unless clipping makes others of them.
  if (orientation_ == 0) return !inside_volume_ || !has_equal_vertices();
  // Twice the area is the sum of cross products of edges; moving the vertices by d_i changes it by at most
  // sum |d_i x e_i| + sum |d_i x d_j|, three terms each, e_i the opposite edge.
  double change = 6 * latitude.x * latitude.y;
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3;
    const size_t k = (i + 2) % 3;
    change += latitude.x * std::abs(v_[k] / w(k) - v_[j] / w(j)) + latitude.y * std::abs(u_[k] / w(k) - u_[j] / w(j));
  }
  return determinant_ / w(0) / w(1) / w(2) <= change * (1 + 0x1p-40);
}

bool Triangle::thinner_than(double width) const {
  if (undefined_ || orientation_ == 0) return true;
  if (!in_front_) return false;
  double longest = 0;
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3;
    longest = std::max(longest, std::hypot(u_[i] / w(i) - u_[j] / w(j), v_[i] / w(i) - v_[j] / w(j)));
  }
  return determinant_ / w(0) / w(1) / w(2) <= width * longest * (1 + 0x1p-40);
}

Coverage Triangle::classify_against(const LinearForm& form, double dx, double dy, const Latitude& latitude,
                                    int exact_form) const {
  const double value = form.at(dx, dy);
  const double reach = form.reach(latitude.x, latitude.y);
  // The last term: dx and dy round where the viewport's centre is no short number.
  const double slack =
      form.error_at(dx, dy) + form.reach_error(latitude.x, latitude.y) +
      form.reach(0x1p-52 * (std::abs(dx) + std::abs(centre_x_)), 0x1p-52 * (std::abs(dy) + std::abs(centre_y_)));
  if (value > reach + slack) return Coverage::kMust;
  if (value < -reach - slack) return Coverage::kMustNot;
  if (std::abs(value) <= reach - slack) return Coverage::kMay;
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
  if (inside_x > latitude.x + slack && inside_y > latitude.y + slack) return Coverage::kMust;
  if (inside_x < -latitude.x - slack || inside_y < -latitude.y - slack) return Coverage::kMustNot;
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

BlockClassification Triangle::classify_block(const Block& block, const Latitude& latitude) const {
  if (undefined_ || orientation_ == 0) return {};
  if (outside_) return {.coverage = Coverage::kMustNot};
  const double dx = offset(block.x, centre_x_);
  const double dy = offset(block.y, centre_y_);
  const double far_dx = std::abs(dx) + block.half_width;
  const double far_dy = std::abs(dy) + block.half_height;
  unsigned undecided = 0;
  // A millionth of a pixel covers the rounding of these few operations on coordinates within the viewport.
  const bool inside_viewport = double{viewport_.width} / 2 - far_dx > latitude.x + 0x1p-20 &&
                               std::abs(double{viewport_.height}) / 2 - far_dy > latitude.y + 0x1p-20;
  if (!inside_viewport) undecided |= kDoubtViewport;
  // False if the whole block is outside.
  const auto meet = [&](const LinearForm& form, unsigned boundary) {
    const double value = form.at(dx, dy);
    const double radius = form.reach(block.half_width + latitude.x, block.half_height + latitude.y);
    const double slack =
        form.error_at(far_dx, far_dy) * 2 + 0x1p-48 * radius +
        form.reach(0x1p-51 * (far_dx + std::abs(centre_x_)), 0x1p-51 * (far_dy + std::abs(centre_y_)));
    if (!(value > radius + slack)) undecided |= boundary;
    return value >= -radius - slack;
  };
  constexpr BlockClassification kOutside{.coverage = Coverage::kMustNot};
  for (unsigned i = 0; i < 3; ++i) {
    if (!meet(edges_[i], 1U << i)) return kOutside;
  }
  if (needs_near_ && !meet(near_, kDoubtNear)) return kOutside;
  if (needs_far_ && !meet(far_, kDoubtFar)) return kOutside;
  for (const ClipPlane& plane : clip_planes_) {
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
    if (!(value > reach)) undecided |= unsigned{kDoubtClipPlane0} << plane.number;
  }
  return {.coverage = undecided == 0 ? Coverage::kMust : Coverage::kMay,
          .undecided = static_cast<DoubtBits>(undecided)};
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

LinearForm Triangle::interpolant(std::span<const double, 3> q) const {
  LinearForm form = combination(edges_, q);
  const double scale = 1 / determinant_;
  form.a *= scale;
  form.b *= scale;
  form.c *= scale;
  // The determinant errs by 2^-40 at most; see set_up_edges().
  form.error_a = form.error_a * scale + std::abs(form.a) * 0x1p-39;
  form.error_b = form.error_b * scale + std::abs(form.b) * 0x1p-39;
  form.error_c = form.error_c * scale + std::abs(form.c) * 0x1p-39;
  return form;
}

}  // namespace fillrule::exact
