#include "harness/report/outlines.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <span>

#include "reference/exact/assembly.h"

namespace fillrule::report {
namespace {

// A corner in clip space, with the user clip distances there.
struct Corner {
  std::array<double, 4> pos_clip{};
  std::array<double, kMaxClipAndCullDistances> distances{};
  std::string made_by;
};

// Inside where not negative.
struct Plane {
  std::string name;
  std::function<double(const Corner&)> distance;
};

std::vector<Plane> planes_of(const Draw& draw) {
  std::vector<Plane> planes{
      {"left plane", [](const Corner& c) { return c.pos_clip[3] + c.pos_clip[0]; }},
      {"right plane", [](const Corner& c) { return c.pos_clip[3] - c.pos_clip[0]; }},
      {"top plane", [](const Corner& c) { return c.pos_clip[3] + c.pos_clip[1]; }},
      {"bottom plane", [](const Corner& c) { return c.pos_clip[3] - c.pos_clip[1]; }},
  };
  if (draw.state.depth_clip) {
    const double w_share = draw.state.negative_one_to_one ? 1 : 0;
    planes.push_back({"near plane", [w_share](const Corner& c) { return c.pos_clip[2] + w_share * c.pos_clip[3]; }});
    planes.push_back({"far plane", [](const Corner& c) { return c.pos_clip[3] - c.pos_clip[2]; }});
  }
  for (uint32_t i = 0; i < draw.clip_distance_count; ++i) {
    planes.push_back({fmt::format("clip distance {}", i), [i](const Corner& c) { return c.distances[i]; }});
  }
  return planes;
}

Corner between(const Corner& inside, const Corner& outside, double t, const std::string& name) {
  Corner corner{.made_by = name};
  const auto mix = [t](double a, double b) { return a + t * (b - a); };
  for (size_t i = 0; i < 4; ++i) corner.pos_clip[i] = mix(inside.pos_clip[i], outside.pos_clip[i]);
  for (size_t i = 0; i < corner.distances.size(); ++i) {
    corner.distances[i] = mix(inside.distances[i], outside.distances[i]);
  }
  return corner;
}

// Sutherland and Hodgman; two corners are a line, whose way back is left out.
std::vector<Corner> clipped(const std::vector<Corner>& corners, const Plane& plane) {
  std::vector<Corner> result;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Corner& here = corners[i];
    const Corner& next = corners[(i + 1) % corners.size()];
    const double at_here = plane.distance(here);
    const double at_next = plane.distance(next);
    if (at_here >= 0) result.push_back(here);
    if (corners.size() == 2 && i == 1) break;
    if (at_here >= 0 && at_next < 0) result.push_back(between(here, next, at_here / (at_here - at_next), plane.name));
    if (at_here < 0 && at_next >= 0) result.push_back(between(next, here, at_next / (at_next - at_here), plane.name));
  }
  return result;
}

void add_corners(const Draw& draw, const std::vector<Plane>& planes, Outline& outline) {
  std::vector<Corner> corners;
  for (size_t i = 0; i < outline.vertices.size(); ++i) {
    const uint32_t vertex = outline.vertices[i];
    Corner corner{.made_by = fmt::format("v{}", i)};
    for (size_t c = 0; c < 4; ++c) corner.pos_clip[c] = double{draw.positions[vertex][c]};
    for (uint32_t d = 0; d < draw.clip_distance_count; ++d) {
      corner.distances[d] = double{draw.clip_distances[size_t{vertex} * draw.clip_distance_count + d]};
    }
    corners.push_back(corner);
  }
  for (const Plane& plane : planes) corners = clipped(corners, plane);
  const VkViewport& viewport = draw.state.viewport;
  for (const Corner& corner : corners) {
    const auto& [x, y, z, w] = corner.pos_clip;
    OutlineCorner projected{.x = double{viewport.x} + (x / w + 1) * double{viewport.width} / 2,
                            .y = double{viewport.y} + (y / w + 1) * double{viewport.height} / 2,
                            .made_by = corner.made_by};
    if (std::isfinite(projected.x) && std::isfinite(projected.y)) outline.corners.push_back(std::move(projected));
  }
}

// The vertices of each primitive of a draw, in order.
std::vector<std::vector<uint32_t>> primitives_of(const Draw& draw) {
  std::vector<std::vector<uint32_t>> primitives;
  if (exact::draws_polygons(draw)) {
    for (const exact::AssembledTriangle& triangle : exact::assemble(draw)) {
      primitives.emplace_back(triangle.vertices.begin(), triangle.vertices.end());
    }
    return primitives;
  }
  const bool is_point = draw.topology == VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
  const uint32_t step = draw.topology == VK_PRIMITIVE_TOPOLOGY_LINE_LIST ? 2 : 1;
  for (const ElementRun& run : element_runs(draw)) {
    for (uint32_t i = 0; i < primitives_in_run(draw.topology, run.count); ++i) {
      std::vector<uint32_t> vertices{exact::vertex_of_element(draw, run.first + i * step)};
      if (!is_point) vertices.push_back(exact::vertex_of_element(draw, run.first + i * step + 1));
      primitives.push_back(std::move(vertices));
    }
  }
  return primitives;
}

}  // namespace

std::vector<Outline> outlines_of(const Case& test_case, size_t limit) {
  std::vector<Outline> outlines;
  uint32_t number = 0;
  for (uint32_t d = 0; d < test_case.draws.size(); ++d) {
    const Draw& draw = test_case.draws[d];
    const std::vector<Plane> planes = planes_of(draw);
    for (std::vector<uint32_t>& vertices : primitives_of(draw)) {
      if (outlines.size() >= limit) return outlines;
      Outline outline{.primitive = number++, .draw = d, .vertices = std::move(vertices)};
      if (outline.vertices.size() == 1) {
        outline.kind = Outline::Kind::kPoint;
        outline.size = draw.point_sizes.empty() ? 1 : double{draw.point_sizes[outline.vertices[0]]};
      } else if (outline.vertices.size() == 2) {
        outline.kind = Outline::Kind::kLine;
        outline.size = double{draw.state.line_width};
      }
      add_corners(draw, planes, outline);
      if (!outline.corners.empty()) outlines.push_back(std::move(outline));
    }
  }
  return outlines;
}

}  // namespace fillrule::report
