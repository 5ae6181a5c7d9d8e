#include "harness/faults/depth.h"

#include <algorithm>
#include <cmath>

namespace fillrule::faults {
namespace {

double greatest_code(VkFormat format) {
  if (format == VK_FORMAT_D16_UNORM) return 0xFFFF;
  return format == VK_FORMAT_X8_D24_UNORM_PACK32 ? 0xFFFFFF : 0;
}

// The specification's r.
double least_difference(const Context& context, double greatest_depth) {
  const VkFormat format = context.drawn.target.depth_format;
  if (greatest_code(format) > 0) return 1 / greatest_code(format);
  if (context.has(Fault::kBiasUnitFixed)) return 0x1p-24;
  const double unit = std::ldexp(1.0, std::ilogb(std::max(greatest_depth, 0x1p-126)) - 23);
  return context.has(Fault::kBiasDoubled) ? 2 * unit : unit;
}

double rounded_to_bits(double value, int bits) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, bits)), exponent - bits);
}

bool compare(const Context& context, float depth, float stored) {
  auto op = static_cast<uint32_t>(context.state().depth_compare);
  // VkCompareOp is a set of outcomes: bit 0 less, bit 1 equal, bit 2 greater.
  const uint32_t outcome = depth < stored ? 1U : (depth == stored ? 2U : 4U);
  const bool has_order = (op & 1U) != (op >> 2U & 1U);
  if (context.has(Fault::kDepthCompareOffByEqual) && has_order) op ^= 2U;
  return (op & outcome) != 0;
}

double clamped(const Context& context, double depth) {
  const VkViewport& viewport = context.state().viewport;
  const bool to_range = context.state().depth_clamp && !context.has(Fault::kDepthNotClamped);
  const auto [low, high] = std::minmax(viewport.minDepth, viewport.maxDepth);
  return to_range ? std::clamp(depth, double{low}, double{high}) : std::clamp(depth, 0.0, 1.0);
}

}  // namespace

double depth_bias(const Context& context, const Interpolant& polygon) {
  if (!context.state().depth_bias) return 0;
  const DepthBias& bias = *context.state().depth_bias;
  const double slope = context.has(Fault::kBiasSlopeMissing) ? 0 : polygon.depth_slope();
  double offset = slope * double{bias.slope_factor} +
                  least_difference(context, polygon.greatest_depth()) * double{bias.constant_factor};
  if (!context.has(Fault::kBiasClampIgnored)) {
    if (bias.clamp > 0) offset = std::min(offset, double{bias.clamp});
    if (bias.clamp < 0) offset = std::max(offset, double{bias.clamp});
  }
  return context.has(Fault::kBiasSign) ? -offset : offset;
}

float rounded_to_format(VkFormat format, double depth) {
  const double greatest = greatest_code(format);
  return static_cast<float>(greatest > 0 ? std::nearbyint(depth * greatest) / greatest : depth);
}

bool passes_depth(const Context& context, double depth, float& stored) {
  const RasterState& state = context.state();
  const VkFormat format = context.drawn.target.depth_format;
  if (context.has(Fault::kDepthInHalfPrecision)) depth = rounded_to_bits(depth, 11);
  const double kept = clamped(context, depth);
  const float rounded = rounded_to_format(format, kept);
  if (state.depth_bounds) {
    const float tested = context.has(Fault::kDepthBoundsOfFragment) ? rounded : stored;
    if (tested < state.depth_bounds->min || tested > state.depth_bounds->max) return false;
  }
  if (!state.depth_test) return true;
  const float compared = context.has(Fault::kDepthComparedUnrounded) ? static_cast<float>(kept) : rounded;
  if (!compare(context, compared, stored)) return false;
  if (state.depth_write || context.has(Fault::kDepthWriteAlways)) stored = rounded;
  return true;
}

}  // namespace fillrule::faults
