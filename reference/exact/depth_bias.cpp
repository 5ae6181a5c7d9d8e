#include "reference/exact/depth_bias.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/exact/depth_format.h"
#include "reference/exact/window_linear.h"

namespace fillrule::exact {
namespace {

constexpr int kMantissaBits = 23;     // of float32
constexpr int kLeastExponent = -126;  // of a normal float32

struct Range {
  double low = 0;
  double high = 0;
};

Range times(const Range& range, double factor) {
  const double a = range.low * factor;
  const double b = range.high * factor;
  return {.low = std::min(a, b), .high = std::max(a, b)};
}

// The exponent of the largest float32 that is not above `value`.
int exponent_of(double value) {
  if (!(value > 0)) return kLeastExponent;
  return std::max(std::ilogb(value), kLeastExponent);
}

// Of a floating-point format 2^(e - 23), where e is the largest exponent in the polygon; the vertices' depths round.
// Of a fixed-point format of n bits no less than keeps two depths distinct, and at most 2 * 2^-n, which a step being
// 1 / (2^n - 1) is read as two steps.
Range resolvable_difference(VkFormat format, const PolygonDepth& polygon) {
  if (format == VK_FORMAT_UNDEFINED) return {.low = 0, .high = std::numeric_limits<double>::infinity()};
  if (const double largest = largest_code(format); largest > 0)
    return {.low = 1 / (largest + 1), .high = 2 / largest};
  constexpr double kRounding = 4 * kUnitRoundoff;
  const double low = polygon.least_depth * (1 - kRounding) - kRounding * 0x1p-20;
  return {.low = low > 0 ? std::ldexp(1.0, exponent_of(low) - kMantissaBits) : 0,
          .high = std::ldexp(1.0, exponent_of(polygon.most_depth * (1 + kRounding)) - kMantissaBits)};
}

double clamped(double bias, double clamp) {
  if (clamp > 0) return std::min(bias, clamp);
  return clamp < 0 ? std::max(bias, clamp) : bias;
}

}  // namespace

BiasRange bias_range(const DepthBias& bias, VkFormat format, const PolygonDepth& polygon) {
  const auto slope_factor = double{bias.slope_factor};
  const auto constant_factor = double{bias.constant_factor};
  const auto clamp = double{bias.clamp};
  // A factor of 0 takes no part, whatever it is multiplied by.
  const Range slope{.low = std::max(polygon.gradient_x, polygon.gradient_y),
                    .high = std::hypot(polygon.gradient_x, polygon.gradient_y)};
  const Range sloped = slope_factor == 0 ? Range{} : times(slope, slope_factor);
  const Range constant =
      constant_factor == 0 ? Range{} : times(resolvable_difference(format, polygon), constant_factor);
  const double low = sloped.low + constant.low;
  const double high = sloped.high + constant.high;
  double tolerance = slope_factor == 0 ? 0 : std::abs(slope_factor) * polygon.gradient_tolerance;
  // Either product and the sum round.
  tolerance += 2 * kUnitRoundoff *
               (std::max(std::abs(sloped.low), std::abs(sloped.high)) +
                std::max(std::abs(constant.low), std::abs(constant.high)));
  BiasRange range{.low = clamped(low, clamp), .high = clamped(high, clamp)};
  range.tolerance =
      std::max(range.low - clamped(low - tolerance, clamp), clamped(high + tolerance, clamp) - range.high);
  if (std::isfinite(range.low) && std::isfinite(range.high) && std::isfinite(range.tolerance)) return range;
  return {.tolerance = std::numeric_limits<double>::infinity()};
}

BiasRange optional_bias_range(const DepthBias& bias, VkFormat format, const PolygonDepth& primitive) {
  BiasRange range;
  for (const DepthBias& terms : {bias, DepthBias{.constant_factor = bias.constant_factor, .clamp = bias.clamp}}) {
    const BiasRange biased = bias_range(terms, format, primitive);
    range = {.low = std::min(range.low, biased.low),
             .high = std::max(range.high, biased.high),
             .tolerance = std::max(range.tolerance, biased.tolerance)};
  }
  return range;
}

}  // namespace fillrule::exact
