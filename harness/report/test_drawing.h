// For tests: a small case, drawn by our renderer, and then spoilt.
#pragma once

#include "harness/run/suite_runner.h"

namespace fillrule::report {

// A triangle of 8 x 8 pixels in perspective, with a smooth varying of two components.
inline Case small_case() {
  Case test_case{.name = "small/<triangle>",
                 .target = {.width = 8, .height = 8},
                 .varyings = {{.name = "uv", .components = 2, .interpolation = Interpolation::kSmooth}}};
  Draw draw{.positions = {{-0.75F, -0.75F, 0.25F, 1}, {3, -3, 2, 4}, {-0.75F, 0.75F, 0.25F, 1}},
            .varyings = {0, 0, 1, 0.25F, 0.125F, 1}};
  draw.state.viewport = {.x = 0, .y = 0, .width = 8, .height = 8, .minDepth = 0, .maxDepth = 1};
  draw.state.scissor = {.offset = {}, .extent = {.width = 8, .height = 8}};
  draw.state.depth_test = true;
  test_case.draws.push_back(draw);
  return test_case;
}

// Both parties are our renderer; the candidate's planes are spoilt.
template <typename Spoil>
run::Drawing drawing_of(const Case& test_case, const Spoil& spoil) {
  run::Drawing drawing;
  const Result<run::Candidate> renderer = run::make_candidate("renderer", {});
  drawing.candidate = renderer->draw(test_case, 1).value();
  drawing.reference = drawing.candidate;
  spoil(drawing.candidate);
  const judge::Party candidate{.planes = &drawing.candidate};
  const judge::Party reference{.planes = &*drawing.reference};
  drawing.verdict = judge::judge(test_case, candidate, &reference, {.keep_maps = true});
  return drawing;
}

}  // namespace fillrule::report
