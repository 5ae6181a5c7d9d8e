// What the parts of this library share.
#pragma once

#include <string>
#include <string_view>

#include "harness/explain/explanation.h"
#include "reference/exact/expectation.h"

namespace fillrule::explain {

// The boundaries of a piece at (x, y), none where it is undefined.
void add_boundaries(const Case& test_case, const exact::Piece& piece, double x, double y, uint32_t subpixel_bits,
                    PrimitiveFacts& facts);

// The boundaries of a line or a point, and what its rules say.
void add_shape_boundaries(const Case& test_case, const exact::Piece& piece, double x, double y,
                          uint32_t subpixel_bits, PrimitiveFacts& facts);

// What a distance says that rounding may change by the latitude.
exact::Coverage answer_of(double distance, double latitude);

// "primitive 3", "line 0", "point 2", or "the line v0-v1 of primitive 3".
std::string name_of(const PrimitiveFacts& primitive);

// Explanation::reason, from all the rest.
std::string reason_of(const Explanation& explanation);

// What is wrong, of a plane that is at fault or imprecise: no full stop, no verdict.
std::string fault_text(const Explanation& explanation, const PlaneFacts& plane);

std::string_view word_for(judge::Verdict verdict);

// Of the pieces of a polygon the one that the sample is nearest to, or deepest in; null if none is near.
const PrimitiveFacts* find_primitive(const View& view, uint32_t number);

// The boundary nearest to a sample of which that boundary leaves open whether it is covered; null if there is none.
const Boundary* doubtful_boundary(const PrimitiveFacts& primitive);

// "0.31 subpixels inside edge v1-v2 of primitive 0"
std::string place_text(const PrimitiveFacts& primitive, const Boundary& boundary);

// "draws primitive 0, which is culled"
std::string excluded_text(const PrimitiveFacts& primitive);

// "12 subpixels", "0.31 subpixels", "1 subpixel".
std::string subpixels(double distance);

}  // namespace fillrule::explain
