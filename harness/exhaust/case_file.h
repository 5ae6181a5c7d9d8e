// A difference for people: as text, and as a case file that draws the triangle alone.
#pragma once

#include <string>

#include "cases/model/case.h"
#include "harness/exhaust/compare.h"

namespace fillrule::exhaust {

// "(0.25, 1) (4, 0) (2.5, 3.75)": pixels from the cell's corner.
std::string vertices_text(const World& world, const Triple& triple);

// The vertices, what the difference means, and both masks side by side: '.' no hit, '#' one, 'F' one of a front face,
// '?' anything else.
std::string difference_text(const World& world, const std::string& party, const Difference& difference);

// The triangle in a target of its own; the cell is at the target's top left. The name is that of the case file.
Case difference_case(const World& world, const std::string& party, const Difference& difference);

}  // namespace fillrule::exhaust
