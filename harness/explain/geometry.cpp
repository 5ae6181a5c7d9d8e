// What bounds a primitive at a sample; lines and points are in shapes.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/explain/internal.h"
#include "reference/exact/rational_triangle.h"

namespace fillrule::explain {
namespace {

using exact::Piece;

Boundary from_form(const Piece& piece, const exact::LinearForm& form, int number, double x, double y,
                   double subpixels_per_pixel) {
  const exact::Triangle& triangle = *piece.triangle();
  Boundary boundary{.form = {form.a, form.b, form.c}};
  boundary.value = form.at(x - triangle.centre_x(), y - triangle.centre_y());
  // On the line to the last bit, or not: no double can tell.
  if (triangle.orientation() != 0 && exact::exact_side(triangle, number, x, y) == 0) boundary.value = 0;
  const double scale = subpixels_per_pixel / std::hypot(form.a, form.b);
  boundary.distance = boundary.value * scale;
  boundary.latitude = form.reach(piece.latitude.x, piece.latitude.y) * scale;
  boundary.answer = exact::exact_classification(triangle, number, x, y, piece.latitude);
  return boundary;
}

void add_edges(const Piece& piece, double x, double y, double scale, std::vector<Boundary>& boundaries) {
  for (size_t i = 0; i < 3; ++i) {
    const exact::LinearForm& form = piece.triangle()->edge(i);
    if (form.a == 0 && form.b == 0) continue;  // its end points are one
    Boundary edge = from_form(piece, form, static_cast<int>(i), x, y, scale);
    edge.name = fmt::format("edge v{}-v{}", std::min((i + 1) % 3, (i + 2) % 3), std::max((i + 1) % 3, (i + 2) % 3));
    // (a, b) points inside; y points down.
    edge.left = piece.triangle()->orientation() != 0 && form.a > 0;
    edge.top = piece.triangle()->orientation() != 0 && form.a == 0 && form.b > 0;
    boundaries.push_back(std::move(edge));
  }
}

// The near and far planes, where a vertex is outside of them.
void add_depth_planes(const Piece& piece, double x, double y, double scale, std::vector<Boundary>& boundaries) {
  const exact::Triangle& triangle = *piece.triangle();
  if (triangle.orientation() == 0 || !triangle.volume().depth_clip) return;
  std::array<double, 3> near{};
  std::array<double, 3> far{};
  for (size_t i = 0; i < 3; ++i) {
    near[i] = triangle.near_distance(i);
    far[i] = triangle.w(i) - double{triangle.vertices()[i][2]};
  }
  const auto add = [&](const std::array<double, 3>& q, int number, Boundary::Kind kind, const char* name) {
    if (std::ranges::none_of(q, [](double value) { return value < 0; })) return;
    const exact::LinearForm form = triangle.interpolant(q);
    if (form.a == 0 && form.b == 0) return;  // parallel to the picture
    Boundary plane = from_form(piece, form, number, x, y, scale);
    plane.kind = kind;
    plane.name = name;
    boundaries.push_back(std::move(plane));
  };
  add(near, exact::kNear, Boundary::Kind::kNear, "the near plane");
  add(far, exact::kFar, Boundary::Kind::kFar, "the far plane");
}

void add_clip_planes(const Piece& piece, double x, double y, double scale, std::vector<Boundary>& boundaries) {
  const exact::Triangle& triangle = *piece.triangle();
  const double dx = x - triangle.centre_x();
  const double dy = y - triangle.centre_y();
  for (const exact::Triangle::ClipPlane& plane : triangle.clip_planes()) {
    const exact::LinearForm& form = plane.form;
    const double length = std::hypot(form.a, form.b);
    if (length == 0) continue;
    Boundary boundary{.kind = Boundary::Kind::kClipDistance,
                      .name = fmt::format("clip distance {}", plane.number),
                      .form = {form.a, form.b, form.c},
                      .value = form.at(dx, dy)};
    boundary.distance = boundary.value / length * scale;
    boundary.latitude = triangle.clip_reach(plane, dx, dy, piece.latitude) / length * scale;
    boundary.answer = answer_of(boundary.distance, boundary.latitude);
    boundaries.push_back(std::move(boundary));
  }
}

// The side of a rectangle that the sample is furthest out of, or nearest to.
struct Side {
  const char* name = nullptr;
  double distance = 0;  // pixels, positive inside
  bool of_x = true;
  std::array<double, 2> normal{};
};
Side nearest_side(double left, double top, double right, double bottom, double x, double y) {
  const std::array<Side, 4> sides{{{"left side", x - left, true, {1, 0}},
                                   {"right side", right - x, true, {-1, 0}},
                                   {"top", y - top, false, {0, 1}},
                                   {"bottom", bottom - y, false, {0, -1}}}};
  return *std::ranges::min_element(sides, {}, &Side::distance);
}

Boundary viewport_side(const VkViewport& viewport, const exact::Latitude& latitude, double x, double y,
                       double scale) {
  const double one{viewport.y};
  const double other = one + double{viewport.height};
  const double left{viewport.x};
  const Side side =
      nearest_side(left, std::min(one, other), left + double{viewport.width}, std::max(one, other), x, y);
  const double half = side.of_x ? double{viewport.width} / 2 : std::abs(double{viewport.height}) / 2;
  return {.kind = Boundary::Kind::kViewport,
          .name = fmt::format("the viewport's {}", side.name),
          .form = {side.normal[0], side.normal[1], half},
          .value = side.distance,
          .distance = side.distance * scale,
          .latitude = (side.of_x ? latitude.x : latitude.y) * scale,
          .answer = exact::exact_viewport_classification(viewport, x, y, latitude)};
}

// Only where the scissor is less than the target: it is a rectangle of whole pixels, and nothing is rounded.
std::optional<Boundary> scissor_side(const Case& test_case, const Piece& piece, double x, double y, double scale) {
  const VkRect2D& scissor = test_case.draws[piece.draw].state.scissor;
  const double left = scissor.offset.x;
  const double top = scissor.offset.y;
  const double right = left + static_cast<double>(scissor.extent.width);
  const double bottom = top + static_cast<double>(scissor.extent.height);
  if (left <= 0 && top <= 0 && right >= test_case.target.width && bottom >= test_case.target.height) return {};
  const VkViewport& viewport = test_case.draws[piece.draw].state.viewport;
  const Side side = nearest_side(left, top, right, bottom, x, y);
  const double centre =
      side.of_x ? double{viewport.x} + double{viewport.width} / 2 : double{viewport.y} + double{viewport.height} / 2;
  const double from_centre =
      side.distance - (side.normal[0] * x + side.normal[1] * y) + (side.normal[0] + side.normal[1]) * centre;
  return Boundary{.kind = Boundary::Kind::kScissor,
                  .name = fmt::format("the scissor's {}", side.name),
                  .form = {side.normal[0], side.normal[1], from_centre},
                  .value = side.distance,
                  .distance = side.distance * scale,
                  .answer = side.distance > 0 ? exact::Coverage::kMust : exact::Coverage::kMustNot};
}

}  // namespace

exact::Coverage answer_of(double distance, double latitude) {
  if (distance > latitude) return exact::Coverage::kMust;
  return distance < -latitude ? exact::Coverage::kMustNot : exact::Coverage::kMay;
}

void add_boundaries(const Case& test_case, const Piece& piece, double x, double y, uint32_t subpixel_bits,
                    PrimitiveFacts& facts) {
  if (facts.undefined || piece.kind == Piece::Kind::kClipEdges) return;
  const double scale = std::ldexp(1.0, static_cast<int>(subpixel_bits));
  if (piece.kind == Piece::Kind::kTriangle) {
    add_edges(piece, x, y, scale, facts.boundaries);
    add_depth_planes(piece, x, y, scale, facts.boundaries);
    add_clip_planes(piece, x, y, scale, facts.boundaries);
  } else {
    add_shape_boundaries(test_case, piece, x, y, subpixel_bits, facts);
  }
  const VkViewport& viewport = test_case.draws[piece.draw].state.viewport;
  facts.boundaries.push_back(viewport_side(viewport, piece.latitude, x, y, scale));
  std::optional<Boundary> scissor = scissor_side(test_case, piece, x, y, scale);
  if (scissor) facts.boundaries.push_back(*std::move(scissor));
}

const Boundary* PrimitiveFacts::deciding() const {
  const auto least = std::ranges::min_element(boundaries, {}, &Boundary::distance);
  return least == boundaries.end() ? nullptr : &*least;
}

}  // namespace fillrule::explain
