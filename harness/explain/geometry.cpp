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

// The planes that a vertex is outside of.
void add_depth_planes(const Piece& piece, double x, double y, double scale, std::vector<Boundary>& boundaries) {
  const exact::Triangle& triangle = *piece.triangle();
  if (triangle.orientation() == 0) return;
  std::array<double, 3> near{};
  std::array<double, 3> far{};
  for (size_t i = 0; i < 3; ++i) {
    near[i] = double{triangle.vertices()[i][2]};
    far[i] = triangle.w(i) - near[i];
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

// The side that the sample is furthest out of, or nearest to.
Boundary viewport_side(const Piece& piece, double x, double y, double scale) {
  const VkViewport& viewport = piece.triangle()->viewport();
  const auto left = double{viewport.x};
  const double right = left + double{viewport.width};
  const auto one = double{viewport.y};
  const double other = one + double{viewport.height};
  struct Side {
    const char* name;
    double distance;  // pixels
    double latitude;
    std::array<double, 3> form;
  };
  const double half_width = double{viewport.width} / 2;
  const double half_height = std::abs(double{viewport.height}) / 2;
  const std::array<Side, 4> sides{
      {{"the viewport's left side", x - left, piece.latitude.x, {1, 0, half_width}},
       {"the viewport's right side", right - x, piece.latitude.x, {-1, 0, half_width}},
       {"the viewport's top", y - std::min(one, other), piece.latitude.y, {0, 1, half_height}},
       {"the viewport's bottom", std::max(one, other) - y, piece.latitude.y, {0, -1, half_height}}}};
  const Side& side = *std::ranges::min_element(sides, {}, &Side::distance);
  return {.kind = Boundary::Kind::kViewport,
          .name = side.name,
          .form = side.form,
          .value = side.distance,
          .distance = side.distance * scale,
          .latitude = side.latitude * scale,
          .answer = exact::exact_viewport_classification(viewport, x, y, piece.latitude)};
}

bool contains(const VkRect2D& scissor, double x, double y) {
  const double left = scissor.offset.x;
  const double top = scissor.offset.y;
  return x > left && x < left + static_cast<double>(scissor.extent.width) && y > top &&
         y < top + static_cast<double>(scissor.extent.height);
}

}  // namespace

PrimitiveFacts facts_of(const Case& test_case, const exact::Expectation& expectation, uint32_t number, double x,
                        double y, uint32_t subpixel_bits) {
  const Piece& piece = expectation.pieces()[number];
  const exact::Triangle& triangle = *piece.triangle();
  const RasterState& state = test_case.draws[piece.draw].state;
  const auto culls = piece.front_facing ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_BACK_BIT;
  PrimitiveFacts facts{.number = piece.owner,
                       .draw = piece.draw,
                       .vertices = piece.vertices,
                       .orientation = triangle.orientation(),
                       .front_facing = piece.front_facing,
                       .facing_in_doubt = piece.facing_in_doubt,
                       .undefined = triangle.undefined(),
                       .thin = piece.thin,
                       .clipped = !triangle.inside_volume(),
                       .culled = (state.cull_mode & culls) != 0,
                       .scissored = !contains(state.scissor, x, y)};
  facts.coverage = triangle.classify(x, y, piece.latitude);
  if (facts.undefined) return facts;
  const double scale = std::ldexp(1.0, static_cast<int>(subpixel_bits));
  add_edges(piece, x, y, scale, facts.boundaries);
  add_depth_planes(piece, x, y, scale, facts.boundaries);
  facts.boundaries.push_back(viewport_side(piece, x, y, scale));
  return facts;
}

const Boundary* PrimitiveFacts::deciding() const {
  const auto least = std::ranges::min_element(boundaries, {}, &Boundary::distance);
  return least == boundaries.end() ? nullptr : &*least;
}

}  // namespace fillrule::explain
