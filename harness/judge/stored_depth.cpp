#include "harness/judge/stored_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fillrule::judge {
namespace {

double clamped(double depth, const exact::DepthRange& limits) {
  return std::clamp(depth, limits.low, limits.high);
}

}  // namespace

exact::DepthRange depth_limits(const RasterState& state) {
  if (!state.depth_clamp) return {.low = 0, .high = 1};
  const VkViewport& viewport = state.viewport;
  return {.low = double{std::min(viewport.minDepth, viewport.maxDepth)},
          .high = double{std::max(viewport.minDepth, viewport.maxDepth)}};
}

bool leaves_range(const RasterState& state, VkFormat format, const exact::Expected& depth) {
  if (state.depth_clamp || exact::largest_code(format) != 0) return false;
  const double slack = depth.spread + depth.tolerance;
  return depth.value + slack > 1 || depth.value - slack < 0;
}

exact::Expected expected_in(VkFormat format, const RasterState& state, const exact::Expected& depth) {
  const exact::DepthRange limits = depth_limits(state);
  const double low = clamped(depth.value - depth.spread, limits);
  const double high = clamped(depth.value + depth.spread, limits);
  // Of a fixed-point format either of the two closest codes may be stored.
  return {.value = low + (high - low) / 2,
          .tolerance = depth.tolerance,
          .spread = (high - low) / 2 + 2 * exact::half_step(format)};
}

exact::DepthRange range_in(VkFormat format, const RasterState& state, const exact::Expected& depth) {
  const double slack = depth.spread + depth.tolerance;
  if (!std::isfinite(slack)) return {.low = 0, .high = 1};
  const exact::DepthRange limits = depth_limits(state);
  exact::DepthRange range{.low = clamped(depth.value - slack, limits), .high = clamped(depth.value + slack, limits)};
  if (leaves_range(state, format, depth)) {
    range.low = std::min(range.low, depth.value - slack);
    range.high = std::max(range.high, depth.value + slack);
  }
  return exact::stored(format, range, false);
}

bool has_plain_depth(const RasterState& state, VkFormat format) {
  return format == VK_FORMAT_D32_SFLOAT && state.depth_clip && !state.depth_clamp && !state.depth_bias;
}

}  // namespace fillrule::judge
