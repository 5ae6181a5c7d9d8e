// Tests only: random triangles of the kinds that break rasterizers.
#pragma once

#include <array>
#include <random>

#include "cases/model/case.h"

namespace fillrule::exact {

enum class Family : uint8_t {
  kSmall,        // a few pixels
  kBig,          // larger than the viewport
  kOnGrid,       // vertices on multiples of 1/256 px
  kOnCentres,    // vertices on pixel centres
  kSliver,       // a few subpixels wide
  kCollinear,    // without area, or almost
  kPerspective,  // w from 1 to 1000
  kMixedW,       // w of both signs
  kNear,         // crosses the near plane
  kFar,          // crosses the far plane
  kHuge,         // vertices up to 1e27 px away, edges across the viewport
  kDenormal,     // one coordinate denormal
};
inline constexpr size_t kFamilies = 12;

struct RandomTriangle {
  std::array<ClipPosition, 3> vertices{};
  VkViewport viewport{};
};

RandomTriangle random_triangle(Family family, std::mt19937_64& random);

}  // namespace fillrule::exact
