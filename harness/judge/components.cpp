#include "harness/judge/components.h"

#include <algorithm>

namespace fillrule::judge {

std::vector<ComponentSource> component_sources(const std::vector<Varying>& varyings) {
  std::vector<ComponentSource> sources;
  uint32_t of_vertices = 0;
  for (const Varying& varying : varyings) {
    for (uint32_t c = 0; c < varying.components; ++c) {
      const bool built_in = varying.source != VaryingSource::kVertices;
      sources.push_back({.source = varying.source,
                         .number = built_in ? c : of_vertices++,
                         .interpolation = varying.interpolation,
                         .sampling = varying.sampling});
    }
  }
  return sources;
}

bool shades_samples(const Case& test_case) {
  return test_case.target.samples != VK_SAMPLE_COUNT_1_BIT &&
         std::ranges::any_of(test_case.varyings,
                             [](const Varying& varying) { return varying.sampling == Sampling::kSample; });
}

}  // namespace fillrule::judge
