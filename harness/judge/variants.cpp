#include "harness/judge/variants.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

#include "reference/exact/assembly.h"

namespace fillrule::judge {
namespace {

void append_some(const std::vector<float>& from, size_t vertex, size_t count, std::vector<float>& to) {
  const auto first = from.begin() + static_cast<ptrdiff_t>(vertex * count);
  to.insert(to.end(), first, first + static_cast<ptrdiff_t>(count));
}

// A corner that has the flat varyings of the provoking vertex and all else of its own.
void append_corner(const Draw& draw, uint32_t vertex, uint32_t provoking, const std::vector<Varying>& varyings,
                   Draw& list) {
  list.positions.push_back(draw.positions[vertex]);
  append_some(draw.clip_distances, vertex, draw.clip_distance_count, list.clip_distances);
  append_some(draw.cull_distances, vertex, draw.cull_distance_count, list.cull_distances);
  const size_t stride = vertex_component_count(varyings);
  size_t component = 0;
  for (const Varying& varying : varyings) {
    if (varying.source != VaryingSource::kVertices) continue;
    const uint32_t source = varying.interpolation == Interpolation::kFlat ? provoking : vertex;
    for (uint32_t c = 0; c < varying.components; ++c, ++component) {
      list.varyings.push_back(draw.varyings[source * stride + component]);
    }
  }
}

Draw as_triangle_list(const Draw& draw, const std::vector<Varying>& varyings, const std::array<uint32_t, 3>& order) {
  Draw list{.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, .state = draw.state};
  list.clip_distance_count = draw.clip_distance_count;
  list.cull_distance_count = draw.cull_distance_count;
  for (const exact::AssembledTriangle& triangle : exact::assemble(draw)) {
    const uint32_t provoking = triangle.vertices[triangle.provoking];
    for (const uint32_t corner : order) append_corner(draw, triangle.vertices[corner], provoking, varyings, list);
  }
  return list;
}

// Whether a coordinate can be scaled without rounding.
bool scales(float coordinate, int exponent) {
  if (coordinate == 0 || !std::isfinite(coordinate)) return true;
  const float scaled = std::ldexp(coordinate, exponent);
  return std::abs(coordinate) >= FLT_MIN && std::abs(scaled) >= FLT_MIN && std::abs(scaled) <= FLT_MAX / 16;
}

}  // namespace

Case as_triangle_list(const Case& test_case, const std::array<uint32_t, 3>& order) {
  Case result = test_case;
  for (Draw& draw : result.draws) draw = as_triangle_list(draw, test_case.varyings, order);
  return result;
}

Case with_front_faces_flipped(Case test_case) {
  for (Draw& draw : test_case.draws) {
    const bool clockwise = draw.state.front_face == VK_FRONT_FACE_CLOCKWISE;
    draw.state.front_face = clockwise ? VK_FRONT_FACE_COUNTER_CLOCKWISE : VK_FRONT_FACE_CLOCKWISE;
  }
  return test_case;
}

Case without_depth_test(Case test_case) {
  for (Draw& draw : test_case.draws) draw.state.depth_test = false;
  return test_case;
}

bool tests_depth(const Case& test_case) {
  return std::any_of(test_case.draws.begin(), test_case.draws.end(),
                     [](const Draw& draw) { return draw.state.depth_test; });
}

bool scale_clip_space(Case& test_case, int exponent) {
  for (const Draw& draw : test_case.draws) {
    for (const ClipPosition& position : draw.positions) {
      for (const float coordinate : position) {
        if (!scales(coordinate, exponent)) return false;
      }
    }
  }
  for (Draw& draw : test_case.draws) {
    for (ClipPosition& position : draw.positions) {
      for (float& coordinate : position) coordinate = std::ldexp(coordinate, exponent);
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
