// Where the samples of a pixel are (Vulkan, "Multisampling": the standard sample locations).
//
// All of them lie on a grid of 1/16 px, so they are exact in fixed point (4 subpixel bits or more) and in double.
#pragma once

#include <cstdint>
#include <span>

#include "cases/model/case.h"
#include "renderer/fixed_point.h"

namespace fillrule::renderer {

// From the centre of a pixel, in pixels.
struct WindowOffset {
  double x = 0;
  double y = 0;
};

// From the top left of the pixel, in 1/16 px.
struct SampleLocation {
  int32_t x_16 = 0;
  int32_t y_16 = 0;

  // From the top left of the pixel, in subpixels.
  [[nodiscard]] constexpr FixedPosition fixed(uint32_t subpixel_bits) const {
    const uint32_t shift = subpixel_bits - kMinSubpixelBits;
    return {x_16 << shift, y_16 << shift};
  }

  // From the centre of the pixel, in pixels.
  [[nodiscard]] constexpr WindowOffset from_centre() const { return {(x_16 - 8) / 16.0, (y_16 - 8) / 16.0}; }
};

// In the order of gl_SampleID, for 1, 2, 4, 8 or 16 samples a pixel; empty for any other number.
std::span<const SampleLocation> standard_sample_locations(uint32_t samples);

}  // namespace fillrule::renderer
