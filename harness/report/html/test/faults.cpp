#include "harness/report/html/test/faults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace fillrule::report {
namespace {

// What is done to a case before it is drawn, or to the planes after.
using SpoilCase = void (*)(Case&);
using SpoilPlanes = void (*)(Planes&);

struct Fault {
  std::string_view name;
  SpoilCase spoil_case = nullptr;
  SpoilPlanes spoil_planes = nullptr;
};

template <typename Visit>
void for_each_plane(Planes& planes, const Visit& visit) {
  visit(planes.hits);
  visit(planes.owner);
  visit(planes.front_facing);
  if (!planes.depth.empty()) visit(planes.depth);
  for (std::vector<float>& plane : planes.varyings) visit(plane);
}

// Calls back with the index of each sample where something landed.
template <typename Visit>
void for_each_hit(Planes& planes, const Visit& visit) {
  for (size_t i = 0; i < planes.hits.size(); ++i) {
    if (planes.hits[i] != 0) visit(i);
  }
}

void invert_culling(Case& test_case) {
  for (Draw& draw : test_case.draws) {
    const VkCullModeFlags mode = draw.state.cull_mode;
    if (mode == VK_CULL_MODE_FRONT_BIT || mode == VK_CULL_MODE_BACK_BIT) {
      draw.state.cull_mode = mode ^ VK_CULL_MODE_FRONT_AND_BACK;
    }
  }
}

void flip_depth_compare(Case& test_case) {
  constexpr std::array<std::pair<VkCompareOp, VkCompareOp>, 2> kPairs{
      {{VK_COMPARE_OP_LESS, VK_COMPARE_OP_GREATER}, {VK_COMPARE_OP_LESS_OR_EQUAL, VK_COMPARE_OP_GREATER_OR_EQUAL}}};
  for (Draw& draw : test_case.draws) {
    VkCompareOp& compare = draw.state.depth_compare;
    for (const auto& [one, other] : kPairs) {
      if (compare == one || compare == other) {
        compare = compare == one ? other : one;
        break;
      }
    }
  }
  // With the other comparison nothing would pass the clear value.
  test_case.target.clear_depth = 1 - test_case.target.clear_depth;
}

void ignore_perspective(Case& test_case) {
  for (Varying& varying : test_case.varyings) {
    if (varying.interpolation == Interpolation::kSmooth) varying.interpolation = Interpolation::kNoperspective;
  }
}

void ignore_scissor(Case& test_case) {
  for (Draw& draw : test_case.draws) {
    draw.state.scissor = {.offset = {},
                          .extent = {.width = test_case.target.width, .height = test_case.target.height}};
  }
}

void ignore_depth_planes(Case& test_case) {
  for (Draw& draw : test_case.draws) draw.state.depth_clip = false;
}

// Samples at the pixels' corners.
void sample_at_corners(Case& test_case) {
  for (Draw& draw : test_case.draws) {
    draw.state.viewport.x += 0.5F;
    draw.state.viewport.y += 0.5F;
  }
}

// Drawn as in a mirror, so that ties fall to right edges.
void mirror_case(Case& test_case) {
  for (Draw& draw : test_case.draws) {
    for (ClipPosition& position : draw.positions) position[0] = -position[0];
    RasterState& state = draw.state;
    const auto width = static_cast<float>(test_case.target.width);
    state.viewport.x = width - state.viewport.x - state.viewport.width;
    state.scissor.offset.x = static_cast<int32_t>(test_case.target.width) - state.scissor.offset.x -
                             static_cast<int32_t>(state.scissor.extent.width);
    state.front_face =
        state.front_face == VK_FRONT_FACE_CLOCKWISE ? VK_FRONT_FACE_COUNTER_CLOCKWISE : VK_FRONT_FACE_CLOCKWISE;
  }
}

void mirror_planes(Planes& planes) {
  for_each_plane(planes, [&planes](auto& plane) {
    for (size_t y = 0; y < planes.height; ++y) {
      const auto begin = plane.begin() + static_cast<std::ptrdiff_t>(y * planes.width * planes.samples);
      std::reverse(begin, begin + static_cast<std::ptrdiff_t>(size_t{planes.width} * planes.samples));
    }
  });
}

void shift_to_the_right(Planes& planes) {
  for_each_plane(planes, [&](auto& plane) {
    for (size_t y = 0; y < planes.height; ++y) {
      const auto row = plane.begin() + static_cast<std::ptrdiff_t>(y * planes.width * planes.samples);
      std::rotate(row, row + static_cast<std::ptrdiff_t>(size_t{planes.width - 1} * planes.samples),
                  row + static_cast<std::ptrdiff_t>(size_t{planes.width} * planes.samples));
    }
  });
}

void swap_varyings(Planes& planes) {
  if (planes.varyings.size() > 1) std::swap(planes.varyings[0], planes.varyings[1]);
}

void make_nan(Planes& planes) {
  for_each_hit(planes, [&](size_t i) {
    for (auto& plane : planes.varyings) plane[i] = std::numeric_limits<float>::quiet_NaN();
  });
}

void make_depth_constant(Planes& planes) {
  if (planes.depth.empty()) return;
  for_each_hit(planes, [&](size_t i) { planes.depth[i] = 0.3125F; });
}

// One lone sample, in the middle of all that landed.
void spoil_one_depth(Planes& planes) {
  std::vector<size_t> hits;
  for_each_hit(planes, [&](size_t i) { hits.push_back(i); });
  if (!hits.empty() && !planes.depth.empty()) planes.depth[hits[hits.size() / 2]] += 1.0F / 128;
}

void flip_facing(Planes& planes) {
  for_each_hit(planes, [&](size_t i) { planes.front_facing[i] ^= 1U; });
}

void draw_nothing(Planes& planes) {
  planes = Planes::cleared(planes.width, planes.height, planes.samples, static_cast<uint32_t>(planes.varyings.size()),
                           1.0F);
}

void land_twice(Planes& planes) {
  for_each_hit(planes, [&](size_t i) { ++planes.hits[i]; });
}

constexpr std::array<Fault, 15> kFaults{{{"culling_inverted", invert_culling},
                                         {"depth_compare_flipped", flip_depth_compare},
                                         {"affine_varyings", ignore_perspective},
                                         {"scissor_ignored", ignore_scissor},
                                         {"no_depth_clip", ignore_depth_planes},
                                         {"samples_at_corners", sample_at_corners},
                                         {"top_right_rule", mirror_case, mirror_planes},
                                         {"shifted", nullptr, shift_to_the_right},
                                         {"varyings_swapped", nullptr, swap_varyings},
                                         {"nan", nullptr, make_nan},
                                         {"depth_constant", nullptr, make_depth_constant},
                                         {"one_depth", nullptr, spoil_one_depth},
                                         {"facing_flipped", nullptr, flip_facing},
                                         {"blank", nullptr, draw_nothing},
                                         {"lands_twice", nullptr, land_twice}}};

}  // namespace

std::vector<std::string_view> broken_candidates() {
  std::vector<std::string_view> names;
  names.reserve(kFaults.size());
  for (const Fault& fault : kFaults) names.push_back(fault.name);
  return names;
}

Result<run::Candidate> make_broken(std::string_view name) {
  const auto fault = std::ranges::find(kFaults, name, &Fault::name);
  if (fault == kFaults.end()) return failure("there is no fault '" + std::string(name) + "'");
  Result<run::Candidate> candidate = run::make_candidate("renderer", {});
  if (!candidate) return candidate;
  candidate->name = "broken:" + std::string(name);
  candidate->draw = [sound = candidate->draw, fault = *fault](const Case& test_case,
                                                              uint32_t threads) -> Result<Planes> {
    Case spoiled = test_case;
    if (fault.spoil_case != nullptr) fault.spoil_case(spoiled);
    Result<Planes> planes = sound(spoiled, threads);
    if (planes && fault.spoil_planes != nullptr) fault.spoil_planes(*planes);
    return planes;
  };
  return candidate;
}

}  // namespace fillrule::report
