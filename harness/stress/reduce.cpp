#include "harness/stress/reduce.h"

#include <algorithm>

#include "reference/exact/assembly.h"

namespace fillrule::stress {
namespace {

constexpr size_t kVertices = 3;  // of a triangle

bool is_plain_list(const Draw& draw) {
  return draw.topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST && !draw.indices;
}

// The same triangles, each with vertices of its own; the provoking one is the first of each already.
Draw as_list(const Draw& draw) {
  Draw list{.state = draw.state};
  const size_t components = draw.positions.empty() ? 0 : draw.varyings.size() / draw.positions.size();
  for (const exact::AssembledTriangle& triangle : exact::assemble(draw)) {
    for (const uint32_t vertex : triangle.vertices) {
      list.positions.push_back(draw.positions[vertex]);
      for (size_t c = 0; c < components; ++c) list.varyings.push_back(draw.varyings[vertex * components + c]);
    }
  }
  return list;
}

void erase_triangle(Draw& draw, size_t triangle) {
  const size_t components = draw.varyings.size() / draw.positions.size();
  const auto erase = [](auto& values, size_t first, size_t count) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    values.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  erase(draw.positions, triangle * kVertices, kVertices);
  erase(draw.varyings, triangle * kVertices * components, kVertices * components);
}

}  // namespace

Case reduce(const Case& failing, const StillFails& still_fails) {
  Case least = failing;
  const auto try_instead = [&](Case&& smaller) {
    const bool fails = still_fails(smaller);
    if (fails) least = std::move(smaller);
    return fails;
  };
  for (size_t d = least.draws.size(); d-- > 0;) {
    if (!is_plain_list(least.draws[d])) {
      Case listed = least;
      listed.draws[d] = as_list(least.draws[d]);
      if (!try_instead(std::move(listed))) continue;
    }
    for (size_t triangle = least.draws[d].positions.size() / kVertices; triangle-- > 0;) {
      Case smaller = least;
      erase_triangle(smaller.draws[d], triangle);
      const bool empty = smaller.draws[d].positions.empty();
      if (empty) smaller.draws.erase(smaller.draws.begin() + static_cast<std::ptrdiff_t>(d));
      if (smaller.draws.empty()) break;
      if (try_instead(std::move(smaller)) && empty) break;
    }
  }
  return least;
}

}  // namespace fillrule::stress
