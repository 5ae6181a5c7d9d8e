// The outlines of a case's primitives in the picture, to be drawn on top of it. For the eye alone: double arithmetic,
// clipped to the whole view volume, where implementations clip less and round.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cases/model/case.h"

namespace fillrule::report {

struct OutlineCorner {
  double x = 0;  // framebuffer coordinates: pixels, y down
  double y = 0;
  // "v1" for the primitive's own vertex, or the plane that cut it off: "near plane", "left plane", "clip distance 0".
  std::string made_by;
};

struct Outline {
  enum class Kind : uint8_t { kTriangle, kLine, kPoint };
  uint32_t primitive = 0;  // over all draws
  uint32_t draw = 0;
  Kind kind = Kind::kTriangle;
  std::vector<uint32_t> vertices;  // of the draw
  double size = 0;                 // pixels: a point's side, a line's width
  std::vector<OutlineCorner> corners;
};

// In submission order, those of which something is left in the view volume. At most `limit`.
std::vector<Outline> outlines_of(const Case& test_case, size_t limit);

}  // namespace fillrule::report
