// Where the components of a case's varyings, in the order of Planes::varyings, have their values from.
#pragma once

#include <cstdint>
#include <vector>

#include "cases/model/case.h"

namespace fillrule::judge {

struct ComponentSource {
  VaryingSource source = VaryingSource::kVertices;
  uint32_t number = 0;  // of the components that the vertices carry, or of the built-in's
  Interpolation interpolation = Interpolation::kSmooth;
  Sampling sampling = Sampling::kCenter;
};

std::vector<ComponentSource> component_sources(const std::vector<Varying>& varyings);

// Whether fragments are shaded for each sample on its own.
bool shades_samples(const Case& test_case);

}  // namespace fillrule::judge
