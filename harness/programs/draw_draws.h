// A whole case with the renderer, each draw with a program of its own.
#pragma once

#include <algorithm>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "cases/model/result.h"
#include "renderer/pipeline.h"

namespace fillrule::programs {

// The planes of a case before anything is drawn. An error names what the renderer cannot draw, or what is
// inconsistent in the case.
Result<Planes> cleared_planes(const Case& drawn_case);

// `make_program(number of the draw, number of primitives in the draws before, planes)` gives the program that writes
// to the planes.
template <typename MakeProgram>
Result<Planes> draw_draws(const Case& drawn_case, const renderer::Options& options, const MakeProgram& make_program) {
  Result<Planes> planes = cleared_planes(drawn_case);
  if (!planes) return planes;
  const Target& target = drawn_case.target;
  const bool sample_shading = std::any_of(drawn_case.varyings.begin(), drawn_case.varyings.end(),
                                          [](const Varying& one) { return one.sampling == Sampling::kSample; });
  uint32_t first_primitive = 0;
  for (size_t i = 0; i < drawn_case.draws.size(); ++i) {
    const Draw& draw = drawn_case.draws[i];
    const std::vector<ElementRun> runs = element_runs(draw);
    const auto program = make_program(i, first_primitive, *planes);
    const renderer::DrawInput input{
        .target_width = target.width,
        .target_height = target.height,
        .samples = planes->samples,
        .sample_shading = sample_shading,
        .vertices = {.topology = draw.topology,
                     .vertex_count = static_cast<uint32_t>(draw.positions.size()),
                     .indices = draw.indices ? renderer::Indices(*draw.indices) : std::nullopt,
                     .vertex_offset = draw.vertex_offset,
                     .runs = runs,
                     .point_sizes = draw.point_sizes},
        .clip_distances = {.count = draw.clip_distance_count, .values = draw.clip_distances},
        .cull_distances = {.count = draw.cull_distance_count, .values = draw.cull_distances},
        .state = draw.state,
        .depth = {planes->depth, target.depth_format},
    };
    if (const Result<void> drawn = renderer::draw(input, program, options); !drawn) {
      return tl::unexpected(drawn.error());
    }
    first_primitive += primitive_count(draw);
  }
  return planes;
}

}  // namespace fillrule::programs
