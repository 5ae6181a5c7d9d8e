// The families of random triangles: each is a way in which rasterizers, and oracles, go wrong.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace fillrule::stress {

enum class Family : uint8_t {
  kSmall,        // a few pixels
  kBig,          // larger than the viewport
  kSliver,       // a few subpixels wide
  kOnGrid,       // vertices on multiples of 1/256 px
  kTies,         // vertices halfway between multiples of 1/256 px, on pixel centres, or edges through centres
  kCollinear,    // without area, or almost
  kPerspective,  // w from 1 to 1000
  kSteep,        // w from 1 to 1,000,000
  kNear,         // across the near plane
  kFar,          // across the far plane
  kNearAndFar,   // across both
  kMixedW,       // w of both signs
  kZeroW,        // one or two vertices with w = 0
  kHuge,         // far outside of the viewport, or of extreme magnitude
  kViewport,     // viewports with fractions, beyond the target, upside down, of any depth range
  kSharedEdges,  // fans, strips and grids of triangles that share edges
};
inline constexpr size_t kFamilyCount = 16;

std::array<Family, kFamilyCount> all_families();

// "small", "near_and_far": the middle of a case's name, stress/small/7-12.
std::string_view name_of(Family family);
std::optional<Family> family_named(std::string_view name);

// How many triangles one case of the family has. Few where they fill the target, so that the values of each can be
// seen.
uint32_t triangles_per_case(Family family);

}  // namespace fillrule::stress
