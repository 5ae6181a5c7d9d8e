#include "harness/judge/variants.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

#include "reference/exact/assembly.h"

namespace fillrule::judge {
namespace {

Draw as_triangle_list(const Draw& draw, const std::vector<Varying>& varyings, const std::array<uint32_t, 3>& order) {
  Draw list{.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST,
            .state = draw.state,
            .clip_distance_count = draw.clip_distance_count,
            .cull_distance_count = draw.cull_distance_count};
  const size_t stride = vertex_component_count(varyings);
  const auto copy_distances = [](const std::vector<float>& from, uint32_t count, uint32_t vertex,
                                 std::vector<float>& to) {
    const auto begin = from.begin() + static_cast<ptrdiff_t>(size_t{vertex} * count);
    to.insert(to.end(), begin, begin + static_cast<ptrdiff_t>(count));
  };
  const std::vector<exact::AssembledTriangle> triangles = exact::assemble(draw);
  const size_t vertices = triangles.size() * order.size();
  list.positions.reserve(vertices);
  list.clip_distances.reserve(vertices * draw.clip_distance_count);
  list.cull_distances.reserve(vertices * draw.cull_distance_count);
  list.varyings.reserve(vertices * stride);
  for (const exact::AssembledTriangle& triangle : triangles) {
    const uint32_t provoking = triangle.vertices[triangle.provoking];
    for (const uint32_t corner : order) {
      const uint32_t vertex = triangle.vertices[corner];
      list.positions.push_back(draw.positions[vertex]);
      copy_distances(draw.clip_distances, draw.clip_distance_count, vertex, list.clip_distances);
      copy_distances(draw.cull_distances, draw.cull_distance_count, vertex, list.cull_distances);
      size_t component = 0;
      for (const Varying& varying : varyings) {
        if (varying.source != VaryingSource::kVertices) continue;
        const uint32_t source = varying.interpolation == Interpolation::kFlat ? provoking : vertex;
        for (uint32_t c = 0; c < varying.components; ++c, ++component) {
          list.varyings.push_back(draw.varyings[source * stride + component]);
        }
      }
    }
  }
  return list;
}

// The ends of a line have an order, and so have the edges of a polygon drawn as lines.
bool is_filled(const Draw& draw) {
  return draw.topology >= VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST && draw.state.polygon_mode == VK_POLYGON_MODE_FILL;
}

// Whether a coordinate can be scaled by a power of two without rounding.
bool scales(float coordinate, float factor) {
  if (coordinate == 0 || !std::isfinite(coordinate)) return true;
  const float scaled = coordinate * factor;
  return std::abs(coordinate) >= FLT_MIN && std::abs(scaled) >= FLT_MIN && std::abs(scaled) <= FLT_MAX / 16;
}

}  // namespace

Case without_texts(const Case& test_case) {
  return {
      .target = test_case.target, .varyings = test_case.varyings, .draws = test_case.draws, .scene = test_case.scene};
}

Case as_triangle_list(const Case& test_case, const std::array<uint32_t, 3>& order) {
  Case result = test_case;
  for (Draw& draw : result.draws) {
    if (is_filled(draw)) draw = as_triangle_list(draw, test_case.varyings, order);
  }
  return result;
}

Case with_front_faces_flipped(Case test_case) {
  for (Draw& draw : test_case.draws) {
    if (!is_filled(draw)) continue;
    const bool clockwise = draw.state.front_face == VK_FRONT_FACE_CLOCKWISE;
    draw.state.front_face = clockwise ? VK_FRONT_FACE_COUNTER_CLOCKWISE : VK_FRONT_FACE_CLOCKWISE;
  }
  return test_case;
}

Case without_varyings(Case test_case) {
  test_case.varyings.clear();
  for (Draw& draw : test_case.draws) draw.varyings.clear();
  return test_case;
}

Case without_depth_test(Case test_case) {
  for (Draw& draw : test_case.draws) {
    draw.state.depth_test = false;
    draw.state.depth_bounds.reset();
  }
  return test_case;
}

bool tests_depth(const Case& test_case) {
  return std::any_of(test_case.draws.begin(), test_case.draws.end(),
                     [](const Draw& draw) { return draw.state.depth_test || draw.state.depth_bounds; });
}

bool draws_filled_triangles(const Case& test_case) {
  return std::all_of(test_case.draws.begin(), test_case.draws.end(), [](const Draw& draw) {
    return exact::draws_polygons(draw) && draw.state.polygon_mode == VK_POLYGON_MODE_FILL;
  });
}

bool add_cut(Case& test_case, bool other_side) {
  for (Draw& draw : test_case.draws) {
    const uint32_t count = draw.clip_distance_count;
    if (count + draw.cull_distance_count == kMaxClipAndCullDistances) return false;
    std::vector<float> distances;
    distances.reserve(draw.positions.size() * (size_t{count} + 1));
    for (size_t vertex = 0; vertex < draw.positions.size(); ++vertex) {
      const auto& [x, y, z, w] = draw.positions[vertex];
      // Askew, so that few samples are on it, and through the middle of the view volume.
      const float distance = 0.6875F * x + 0.4375F * y + 0.03125F * w;
      const auto begin = draw.clip_distances.begin() + static_cast<ptrdiff_t>(vertex * count);
      distances.insert(distances.end(), begin, begin + static_cast<ptrdiff_t>(count));
      distances.push_back(other_side ? -distance : distance);
    }
    draw.clip_distances = std::move(distances);
    draw.clip_distance_count = count + 1;
  }
  return true;
}

bool scale_clip_space(Case& test_case, int exponent) {
  const float factor = std::ldexp(1.0F, exponent);
  for (const Draw& draw : test_case.draws) {
    for (const ClipPosition& position : draw.positions) {
      for (const float coordinate : position) {
        if (!scales(coordinate, factor)) return false;
      }
    }
  }
  for (Draw& draw : test_case.draws) {
    for (ClipPosition& position : draw.positions) {
      for (float& coordinate : position) coordinate *= factor;
    }
  }
  return true;
}

Case with_scissor(Case test_case, const VkRect2D& rectangle) {
  const auto end = [](int32_t offset, uint32_t extent) { return int64_t{offset} + int64_t{extent}; };
  const auto cut = [&end](int32_t& offset, uint32_t& extent, int32_t low, uint32_t size) {
    const int64_t high = std::min(end(offset, extent), end(low, size));
    offset = std::max(offset, low);
    extent = static_cast<uint32_t>(std::max<int64_t>(high - offset, 0));
  };
  for (Draw& draw : test_case.draws) {
    VkRect2D& scissor = draw.state.scissor;
    cut(scissor.offset.x, scissor.extent.width, rectangle.offset.x, rectangle.extent.width);
    cut(scissor.offset.y, scissor.extent.height, rectangle.offset.y, rectangle.extent.height);
  }
  return test_case;
}

}  // namespace fillrule::judge
