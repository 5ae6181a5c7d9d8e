// The oracle's last resort: the same questions as Triangle's, answered in rationals, for the few samples where
// doubles cannot tell. Slow (tens of microseconds a question) and without rounding.
#pragma once

#include <array>

#include "reference/exact/triangle.h"

namespace fillrule::exact {

// The boundaries by number, as the bits of DoubtBits count them.
enum BoundaryNumber : int { kEdge0, kEdge1, kEdge2, kNear, kFar };

// The sign of D.
int exact_orientation(const std::array<ClipPosition, 3>& vertices, const VkViewport& viewport);

// |D|, rounded to double.
double exact_determinant(const std::array<ClipPosition, 3>& vertices, const VkViewport& viewport);

// The sign of the boundary's function at (x, y), positive inside.
int exact_side(const Triangle& triangle, int boundary, double x, double y);

// Whether the sample is further inside than the latitude (kMust), further outside (kMustNot) or in between.
Coverage exact_classification(const Triangle& triangle, int boundary, double x, double y, const Latitude& latitude);

// The same for the viewport's rectangle.
Coverage exact_viewport_classification(const VkViewport& viewport, double x, double y, const Latitude& latitude);

// True if (x, y) is outside of the projected vertices' bounding box grown by the latitude. All w must be positive.
bool exact_outside_bounds(const Triangle& triangle, double x, double y, const Latitude& latitude);

// The values at (x, y), each rounded to double once. q are the vertices' values of the varying.
double exact_depth(const Triangle& triangle, double x, double y);  // window space
double exact_reciprocal_w(const Triangle& triangle, double x, double y);
double exact_smooth(const Triangle& triangle, std::array<float, 3> q, double x, double y);         // perspective
double exact_noperspective(const Triangle& triangle, std::array<float, 3> q, double x, double y);  // window-linear

// True if every vertex lies exactly on the grid of 2^-subpixel_bits pixels. All w must be positive.
bool exactly_on_grid(const Triangle& triangle, uint32_t subpixel_bits);

}  // namespace fillrule::exact
