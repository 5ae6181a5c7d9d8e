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
  projection.set_anchors();
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
