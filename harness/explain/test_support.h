// Small cases, drawn by the renderer and changed at one sample, for the tests of this folder.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "harness/explain/explain.h"
#include "harness/programs/varyings.h"

namespace fillrule::explain {

inline ClipPosition at(double x, double y, double z, double w = 1) {
  return {static_cast<float>((x / 8 - 1) * w), static_cast<float>((y / 8 - 1) * w), static_cast<float>(z * w),
          static_cast<float>(w)};
}

// One triangle in a target of 16 x 16 pixels.
inline Case triangle_case(const std::string& name, std::vector<ClipPosition> positions) {
  Case one{.name = name,
           .target = {.width = 16, .height = 16},
           .varyings = {{.name = "u", .components = 1, .interpolation = Interpolation::kSmooth}}};
  Draw draw{.positions = std::move(positions)};
  draw.state.viewport = {.x = 0, .y = 0, .width = 16, .height = 16, .minDepth = 0, .maxDepth = 1};
  draw.state.scissor = {.offset = {}, .extent = {.width = 16, .height = 16}};
  draw.state.depth_test = true;
  draw.state.depth_compare = VK_COMPARE_OP_LESS_OR_EQUAL;
  for (size_t i = 0; i < draw.positions.size(); ++i) draw.varyings.push_back(static_cast<float>(i % 3));
  one.draws.push_back(std::move(draw));
  return one;
}

inline Case upright(const std::string& name) {
  return triangle_case(name, {at(2, 2, 0.25), at(14, 2, 0.5), at(2, 14, 0.75)});
}

using Change = std::function<void(Planes&, size_t)>;

// A candidate that is the renderer with a change at the sample (its index in Planes; of the pixel's first one where
// none is named), against the renderer as it is or with another change.
inline Explanation explanation_of(const Case& one, const SampleId& id, const Change& candidate_change = nullptr,
                                  const Change& reference_change = nullptr) {
  Planes candidate = programs::draw_case(one, {}).value();
  Planes reference = candidate;
  const size_t index = (size_t{id.y} * one.target.width + id.x) * candidate.samples + id.sample.value_or(0);
  if (candidate_change) candidate_change(candidate, index);
  if (reference_change) reference_change(reference, index);
  const NamedParty named{.name = "renderer", .party = {.planes = &candidate}};
  const NamedParty against{.name = "lavapipe", .party = {.planes = &reference}};
  return explain(one, named, &against, {}, id).value();
}

inline std::string explained(const Case& one, uint32_t x, uint32_t y, const Change& candidate_change = nullptr,
                             const Change& reference_change = nullptr) {
  return to_text(explanation_of(one, {.x = x, .y = y}, candidate_change, reference_change));
}

// Something lands, or nothing does.
inline Change lands(uint32_t owner, bool front_facing = false) {
  return [=](Planes& planes, size_t index) {
    planes.hits[index] = 1;
    planes.owner[index] = owner;
    planes.front_facing[index] = front_facing ? 1 : 0;
  };
}
inline void is_lost(Planes& planes, size_t index) {
  planes.hits[index] = 0;
  planes.owner[index] = kNoOwner;
  planes.front_facing[index] = 0;
}

inline std::string last_line(const std::string& text) {
  return text.substr(text.rfind('\n', text.size() - 2) + 1);
}

}  // namespace fillrule::explain
