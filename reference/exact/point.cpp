#include "reference/exact/point.h"

#include <algorithm>
#include <cmath>

#include "reference/exact/clip_position.h"

namespace fillrule::exact {
namespace {

// See line.cpp.
constexpr double kSlack = 0x1p-30;
constexpr double kLargestSize = 0x1p20;  // pixels; no target is larger

// Exactly as an implementation does: float32 numbers are compared.
bool inside_clip_volume(const ClipPosition& p, std::span<const float> distances, const RasterState& state) {
  const bool in_window = std::abs(p[0]) <= p[3] && std::abs(p[1]) <= p[3];
  const bool in_depth = !state.depth_clip || (p[2] >= (state.negative_one_to_one ? -p[3] : 0) && p[2] <= p[3]);
  return p[3] > 0 && in_window && in_depth &&
         std::none_of(distances.begin(), distances.end(), [](float d) { return d < 0; });
}

// Any other size may be rounded to a step of the subpixel grid, which moves each side by a quarter of a step: half of
// what rounding the vertex does.
bool is_whole(const SizeRange& size) {
  return size.least == std::nearbyint(size.least);
}

}  // namespace

Point::Point(const ClipPosition& vertex, const SizeRange& size, std::span<const float> distances,
             const RasterState& state)
    : vertex_(vertex), viewport_(state.viewport), size_(size) {
  undefined_ = coordinates_leave_float32(vertex, viewport_) || near_plane_by_flushing(std::span(&vertex, 1)) ||
               std::any_of(distances.begin(), distances.end(), [](float d) { return std::isnan(d); });
  visible_ = undefined_ || inside_clip_volume(vertex, distances, state);
  if (undefined_ || !visible_) return;
  const double w{vertex[3]};
  x_ = double{viewport_.x} + double{viewport_.width} / 2 * (1 + double{vertex[0]} / w);
  y_ = double{viewport_.y} + double{viewport_.height} / 2 * (1 + double{vertex[1]} / w);
}

Latitude Point::margin(const Latitude& latitude) const {
  const double rounding = is_whole(size_) ? 1 : 1.5;
  return {.x = rounding * latitude.x + kSlack, .y = rounding * latitude.y + kSlack};
}

Classification Point::classify(double x, double y, const Latitude& latitude, DoubtBits /*undecided*/) const {
  constexpr Classification kMaybe{.coverage = Coverage::kMay, .doubt = kDoubtShape};
  if (!visible_) return {};
  const Coverage viewport = classify_viewport(viewport_, x, y, latitude);
  if (undefined_) return viewport == Coverage::kMustNot ? Classification{} : kMaybe;
  const double dx = std::abs(x - x_);
  const double dy = std::abs(y - y_);
  const Latitude moved = margin(latitude);
  if (dx > size_.most / 2 + moved.x || dy > size_.most / 2 + moved.y) return {};
  const bool inside = dx < size_.least / 2 - moved.x && dy < size_.least / 2 - moved.y;
  // Whether a square is cut at the viewport, the specification does not say.
  return inside && viewport == Coverage::kMust ? Classification{.coverage = Coverage::kMust} : kMaybe;
}

BlockClassification Point::classify_block(const Block& /*block*/, const Latitude& /*latitude*/,
                                          DoubtBits /*undecided*/) const {
  return {.coverage = visible_ ? Coverage::kMay : Coverage::kMustNot};
}

std::array<double, 4> Point::bounds(const Latitude& latitude) const {
  if (!visible_) return {};
  const double reach = std::min(size_.most, kLargestSize) / 2 + 2 * (latitude.x + latitude.y) + 1;
  if (!undefined_) return {x_ - reach, y_ - reach, x_ + reach, y_ + reach};
  const double top = std::min(double{viewport_.y}, double{viewport_.y} + double{viewport_.height});
  return {double{viewport_.x} - 1, top - 1, double{viewport_.x} + double{viewport_.width} + 1,
          top + std::abs(double{viewport_.height}) + 1};
}

}  // namespace fillrule::exact
