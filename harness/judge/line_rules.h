// The rules that Vulkan makes for Bresenham lines as a whole ("Bresenham Line Segment Rasterization"): an x-major
// line has at most one fragment in a column, as many as the diamond-exit rule makes of it give or take one, and where
// two lines that share an end go on in the same direction, no fragment is doubled and none left out between them.
// (For a y-major line read row for column; a line of width w has w fragments side by side instead of one.)
//
// They can be held against a line whose fragments the planes tell: hits say how many of the pieces at a sample
// landed, and where only one did, owner says which. Lines of which a sample does not tell, lines that are clipped or
// cut by the scissor, whose depth test may fail, or of more than one sample a pixel, are left alone.
#pragma once

#include <cstddef>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "reference/exact/expectation.h"

namespace fillrule::judge {

// The samples (indices of Planes, ascending) where a rule is broken: a fragment too many, or where one is missed.
std::vector<size_t> broken_line_rules(const Case& test_case, const exact::Expectation& expectation,
                                      const Planes& planes);

}  // namespace fillrule::judge
