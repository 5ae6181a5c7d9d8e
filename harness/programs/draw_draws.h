// A whole case with the renderer, each draw with a program of its own.
#pragma once

#include <span>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "cases/model/result.h"
#include "renderer/pipeline.h"

namespace fillrule::programs {

// The planes of a case before anything is drawn. An error names what the renderer cannot draw, or what is
// inconsistent in the case.
Result<Planes> cleared_planes(const Case& drawn_case);

// What the renderer is given of a case's draw, with element_runs() of it.
renderer::DrawInput draw_input(const Case& drawn_case, const Draw& draw, std::span<const ElementRun> runs,
                               const renderer::DepthBuffer& depth);

// `make_program(number of the draw, number of primitives in the draws before, planes)` gives the program that writes
// to the planes.
template <typename MakeProgram>
Result<Planes> draw_draws(const Case& drawn_case, const renderer::Options& options, const MakeProgram& make_program) {
  Result<Planes> planes = cleared_planes(drawn_case);
  if (!planes) return planes;
  uint32_t first_primitive = 0;
  for (size_t i = 0; i < drawn_case.draws.size(); ++i) {
    const Draw& draw = drawn_case.draws[i];
    const std::vector<ElementRun> runs = element_runs(draw);
    const auto program = make_program(i, first_primitive, *planes);
    const renderer::DrawInput input =
        draw_input(drawn_case, draw, runs, {planes->depth, drawn_case.target.depth_format});
    if (const Result<void> drawn = renderer::draw(input, program, options); !drawn) {
      return tl::unexpected(drawn.error());
    }
    first_primitive += primitive_count(draw);
  }
  return planes;
}

}  // namespace fillrule::programs
