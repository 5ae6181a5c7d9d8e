// The other ways to draw a case that the metamorphic checks compare.
#pragma once

#include <array>
#include <cstdint>

#include "cases/model/case.h"

namespace fillrule::judge {

// Without all that its drawing does not depend on: its texts, of which each variant would have copies.
Case without_texts(const Case& test_case);

// Every draw as a list of triangles without indices. `order` picks each triangle's vertices: {1, 2, 0} rotates them,
// {0, 2, 1} turns the winding over. Flat varyings keep their value, whichever vertex comes first. Draws of anything
// but filled triangles are left as they are, here and in with_front_faces_flipped().
Case as_triangle_list(const Case& test_case, const std::array<uint32_t, 3>& order);

Case with_front_faces_flipped(Case test_case);
Case without_depth_test(Case test_case);
// What is covered by whom is the same, and cheaper to draw.
Case without_varyings(Case test_case);
bool tests_depth(const Case& test_case);

// True if every draw is of triangles that are filled.
bool draws_filled_triangles(const Case& test_case);

// Adds a user clip distance, linear in clip space, to every draw: the part of one side of it remains, or, negated to
// the bit, that of the other. False if a draw has no room for one.
bool add_cut(Case& test_case, bool other_side);

// All coordinates times 2^exponent. False if that would leave the normal float32 numbers, and then nothing is done.
bool scale_clip_space(Case& test_case, int exponent);

// Each draw's scissor cut down to the rectangle.
Case with_scissor(Case test_case, const VkRect2D& rectangle);

}  // namespace fillrule::judge
