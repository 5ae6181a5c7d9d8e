// What a benchmark leaves behind for other programs and for the eye.
#pragma once

#include <span>
#include <string>

#include "harness/bench/measure.h"

namespace fillrule::bench {

// {workloads: [{name, threads, isa, renderer_ms, reference_ms, ratio}]}: medians, ratio = reference / renderer.
std::string to_json(std::span<const Measurement> measurements);

// A bar for each ratio, and a line where both are as fast.
std::string to_svg(std::span<const Measurement> measurements);

}  // namespace fillrule::bench
