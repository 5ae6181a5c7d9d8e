// From covered samples to planes: the tests of each fragment, and its values (Vulkan specification, "Fragment
// Operations", "Interpolation Decorations").
#pragma once

#include <cstdint>
#include <vector>

#include "cases/model/planes.h"
#include "harness/faults/coverage.h"
#include "harness/faults/depth.h"

namespace fillrule::faults {

// What the fragments of a primitive have in common.
struct Surface {
  const Primitive& primitive;
  const Interpolant& values;
  double depth_bias = 0;
  bool front_facing = true;
  // Of a point, pixels: its vertex and its size.
  double point_x = 0;
  double point_y = 0;
  double point_size = 1;
};

class FragmentStage {
 public:
  FragmentStage(const Context& context, uint32_t first_primitive, Planes& planes);

  // Bit i of `covered`: sample i of the pixel.
  void fragment(const Surface& surface, int32_t x, int32_t y, uint32_t covered);

  [[nodiscard]] const std::vector<Location>& locations() const { return locations_; }

 private:
  struct Place {  // pixels
    double x = 0;
    double y = 0;
  };
  [[nodiscard]] size_t index_of(int32_t x, int32_t y, size_t sample) const;
  [[nodiscard]] Place place_of(const Varying& varying, int32_t x, int32_t y, uint32_t covered, size_t sample) const;
  [[nodiscard]] float value(const Surface& surface, const Varying& varying, uint32_t component, uint32_t of_vertex,
                            const Place& place) const;
  void write(const Surface& surface, int32_t x, int32_t y, uint32_t covered, size_t sample);

  const Context& context_;
  uint32_t first_primitive_;
  Planes& planes_;
  std::vector<Location> locations_;
  bool shades_samples_ = false;
};

}  // namespace fillrule::faults
