// The rule without tolerance: a sample near an edge that two triangles share with identical end points is covered
// exactly once (Vulkan specification, "Basic Polygon Rasterization"), however the end points are rounded.
//
// It is applied to every set of triangles around a sample, fans around a vertex included: if each edge that leaves
// the sample in doubt is shared, in opposite direction, by two triangles of the set, then the set's outer boundary is
// further away than the latitude. Rounding the shared vertices cannot carry it across the sample, so the number of
// triangles that cover the sample stays what it is in exact arithmetic with ties resolved consistently.
#pragma once

#include <cstdint>
#include <span>

#include "cases/model/case.h"
#include "reference/exact/expectation.h"

namespace fillrule::judge {

struct WatertightHits {
  uint32_t primitives = 0;  // how many of the entries belong to the set; 0: the rule says nothing here
  uint32_t hits = 0;        // how many of them cover the sample, in any correct implementation
};

WatertightHits watertight_hits(const Case& test_case, const exact::Expectation& expectation,
                               std::span<const exact::Entry> entries, double x, double y);

}  // namespace fillrule::judge
