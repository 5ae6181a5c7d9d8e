#include "renderer/depth_bias.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace fillrule::renderer {
namespace {

// r of the specification. For fixed point it is the greatest that is allowed, 2 * 2^-n for n bits, as lavapipe's. For
// floating point 2^(e - 23), e the exponent of the greatest depth.
double resolution(uint32_t max_code, double greatest_depth) {
  if (max_code != 0) {
    return std::ldexp(2.0, -static_cast<int>(std::bit_width(max_code)));
  }
  constexpr int kMantissaBits = std::numeric_limits<float>::digits - 1;
  const double normal = std::max(greatest_depth, double{std::numeric_limits<float>::min()});
  return std::ldexp(1.0, std::ilogb(normal) - kMantissaBits);
}

}  // namespace

double depth_bias(const DepthBias& bias, const WindowPlane& depth_framebuffer, uint32_t max_code,
                  double greatest_depth) {
  // m of the specification, its second form.
  const double slope = std::max(std::abs(depth_framebuffer.step_x), std::abs(depth_framebuffer.step_y));
  const double offset =
      slope * double{bias.slope_factor} + resolution(max_code, greatest_depth) * double{bias.constant_factor};
  if (bias.clamp > 0) {
    return std::min(offset, double{bias.clamp});
  }
  return bias.clamp < 0 ? std::max(offset, double{bias.clamp}) : offset;
}

}  // namespace fillrule::renderer
