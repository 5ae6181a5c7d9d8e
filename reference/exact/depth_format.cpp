#include "reference/exact/depth_format.h"

#include <algorithm>
#include <cmath>

#include "reference/exact/window_linear.h"

namespace fillrule::exact {
namespace {

float depth_of_code(double code, double largest) {
  return static_cast<float>(code / largest);
}

}  // namespace

double largest_code(VkFormat format) {
  switch (format) {
    case VK_FORMAT_D16_UNORM:
      return 0xFFFF;
    case VK_FORMAT_X8_D24_UNORM_PACK32:
      return 0xFFFFFF;
    default:
      return 0;
  }
}

double half_step(VkFormat format) {
  const double largest = largest_code(format);
  return largest == 0 ? 0 : 0.5 / largest;
}

bool is_depth_of(VkFormat format, float depth) {
  const double largest = largest_code(format);
  if (largest == 0) return true;
  const double code = std::nearbyint(double{depth} * largest);
  return code >= 0 && code <= largest && depth_of_code(code, largest) == depth;
}

float nearest_depth(VkFormat format, double depth) {
  const double largest = largest_code(format);
  return largest == 0 ? static_cast<float>(depth) : depth_of_code(std::nearbyint(depth * largest), largest);
}

DepthRange stored(VkFormat format, const DepthRange& depths, bool nearest) {
  const double largest = largest_code(format);
  if (largest == 0) return depths;
  const auto code = [&](double depth, double (*round)(double)) {
    return std::clamp(round(depth * largest), 0.0, largest) / largest;
  };
  const auto to_nearest = [](double value) { return std::nearbyint(value); };
  const auto down = [](double value) { return std::floor(value); };
  const auto up = [](double value) { return std::ceil(value); };
  if (nearest) return {.low = code(depths.low, to_nearest), .high = code(depths.high, to_nearest)};
  return {.low = code(depths.low, down), .high = code(depths.high, up)};
}

DepthRange stored_clear(VkFormat format, float clear, bool nearest) {
  const double exact{clear};
  // 0 and 1 are exact whatever the arithmetic.
  const double rounding = exact == 0 || exact == 1 ? 0 : kUnitRoundoff * exact;
  if (largest_code(format) == 0) return {.low = exact, .high = exact};
  return stored(format, {.low = exact - rounding, .high = exact + rounding}, nearest);
}

}  // namespace fillrule::exact
