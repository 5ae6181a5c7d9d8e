// For tests: a triangle with depth and two varyings, drawn right by the reference, and by a candidate that is spoiled
// on purpose.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "harness/judge/judge.h"
#include "harness/programs/varyings.h"
#include "harness/run/run.h"
#include "harness/run/suite_runner.h"

namespace fillrule::terminal {

struct Scene {
  Case test_case;
  run::Drawing drawing;
  run::CaseResult result;
};

using Spoil = std::function<void(Planes& candidate, Planes& reference)>;

// The case has `size` pixels in each direction, and its triangle its right angle at 1/8 of that from the top left.
inline Scene draw_scene(uint32_t size, const Spoil& spoil) {
  Scene scene;
  Case& one = scene.test_case;
  one.name = "clipping/near[angle=30]";
  one.target = {.width = size, .height = size};
  one.varyings = {{.name = "uv", .components = 2}, {.name = "shade"}};
  Draw draw{.positions = {{-0.75F, -0.75F, 0.25F, 1}, {0.75F, -0.75F, 0.5F, 1}, {-0.75F, 0.75F, 0.75F, 1}}};
  const auto edge = static_cast<float>(size);
  draw.state.viewport = {.x = 0, .y = 0, .width = edge, .height = edge, .minDepth = 0, .maxDepth = 1};
  draw.state.scissor = {.offset = {}, .extent = {.width = size, .height = size}};
  draw.state.depth_test = true;
  draw.state.depth_compare = VK_COMPARE_OP_LESS_OR_EQUAL;
  draw.varyings = {0, 0, 0.25F, 1, 0, 0.5F, 0, 1, 0.75F};
  one.draws.push_back(std::move(draw));

  scene.drawing.candidate = programs::draw_case(one, {}).value();
  scene.drawing.reference = scene.drawing.candidate;
  spoil(scene.drawing.candidate, *scene.drawing.reference);
  const judge::Party reference{.planes = &*scene.drawing.reference};
  scene.drawing.verdict = judge::judge(one, {.planes = &scene.drawing.candidate}, &reference, {.keep_maps = true});
  scene.result = {
      .name = one.name,
      .status = scene.drawing.verdict.candidate_faults() > 0 ? run::Status::kFailed : run::Status::kPassed,
      .show_command = "fillrule show 'clipping/near[angle=30]'",
      .explain_command = "fillrule explain 'clipping/near[angle=30]' --pixel 9,4",
      .verdict = scene.drawing.verdict};
  return scene;
}

// As if the sample had never been drawn to.
inline void lose(Planes& planes, uint32_t x, uint32_t y) {
  const size_t index = size_t{y} * planes.width + x;
  planes.hits[index] = 0;
  planes.owner[index] = kNoOwner;
  planes.front_facing[index] = 0;
  planes.depth[index] = 1;
  for (auto& plane : planes.varyings) plane[index] = 0;
}

}  // namespace fillrule::terminal
