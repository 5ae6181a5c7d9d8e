#include "harness/faults/window.h"

#include <algorithm>
#include <cmath>

namespace fillrule::faults {
namespace {

// Only faults reach further: what follows must stay within int64.
constexpr double kFarthest = 0x1p28;  // pixels

struct Place {
  double x = 0;
  double y = 0;
};

// 1/w with the 12 bits that some processors offer as an approximation.
double coarse(double reciprocal_w) {
  int exponent = 0;
  const double mantissa = std::frexp(reciprocal_w, &exponent);
  return std::ldexp(std::nearbyint(mantissa * 0x1p12), exponent - 12);
}

Place place_of(const Context& context, const Corner& corner) {
  const VkViewport& viewport = context.state().viewport;
  const auto& [x, y, z, w] = corner.position;
  auto x_ndc = static_cast<double>(x / w);
  auto y_ndc = static_cast<double>(y / w);
  if (context.has(Fault::kReciprocalTooCoarse)) {
    x_ndc = static_cast<double>(x) * coarse(1 / static_cast<double>(w));
    y_ndc = static_cast<double>(y) * coarse(1 / static_cast<double>(w));
  }
  double left{viewport.x};
  double top{viewport.y};
  double height{viewport.height};
  if (context.has(Fault::kViewportOriginTruncated)) {
    left = std::trunc(left);
    top = std::trunc(top);
  }
  if (context.has(Fault::kNegativeHeightIgnored) && height < 0) {
    top += height;
    height = -height;
  }
  return {.x = left + (x_ndc + 1) * double{viewport.width} / 2, .y = top + (y_ndc + 1) * height / 2};
}

double depth_of(const Context& context, const Corner& corner) {
  const VkViewport& viewport = context.state().viewport;
  const auto& [x, y, z, w] = corner.position;
  const double z_ndc = context.has(Fault::kClipDepthUndivided) ? static_cast<double>(z) : static_cast<double>(z / w);
  double min{viewport.minDepth};
  double max{viewport.maxDepth};
  if (context.has(Fault::kDepthRangeSorted) && min > max) std::swap(min, max);
  return min + (max - min) * (context.minus_one_to_one() ? (z_ndc + 1) / 2 : z_ndc);
}

// 16 bits before the point and 16 behind it, in 32 bits that wrap around.
double wrapped(double pixels) {
  const double period = 0x1p16;
  return pixels - period * std::floor((pixels + period / 2) / period);
}

double within_reach(const Context& context, double pixels) {
  if (context.has(Fault::kFixedPointOverflow)) return wrapped(pixels);
  const double farthest = context.has(Fault::kGuardBandClamps) ? 1024 : kFarthest;
  return std::clamp(pixels, -farthest, farthest);
}

// Twice the signed area, positive for corners that go round clockwise on the picture.
double clockwise_area(const std::vector<Place>& corners) {
  double area = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Place& a = corners[i];
    const Place& b = corners[(i + 1) % corners.size()];
    area += a.x * b.y - b.x * a.y;
  }
  return area;
}

}  // namespace

int64_t snap(const Context& context, double pixels) {
  const double subpixels = std::ldexp(pixels, static_cast<int>(context.subpixel_bits));
  const double pixel = std::ldexp(1.0, static_cast<int>(context.subpixel_bits));
  if (context.has(Fault::kSnapToPixels)) return static_cast<int64_t>(std::nearbyint(pixels) * pixel);
  if (context.has(Fault::kSnapByTruncation)) return static_cast<int64_t>(std::trunc(subpixels));
  return static_cast<int64_t>(std::nearbyint(subpixels));
}

WindowCorner to_window(const Context& context, const Primitive& primitive, const Corner& corner) {
  const Wide w = corner.position[3];
  const Place place = place_of(context, corner);
  WindowCorner window{.x = within_reach(context, place.x),
                      .y = within_reach(context, place.y),
                      .depth = depth_of(context, corner),
                      .reciprocal_w = static_cast<double>(1 / w)};
  for (size_t i = 0; i < primitive.size; ++i) {
    const Wide w_of_vertex = context.draw.positions[primitive.vertices[i]][3];
    window.weights_over_w[i] = static_cast<double>(corner.weights[i] / w);
    window.noperspective[i] = static_cast<double>(corner.weights[i] * w_of_vertex / w);
    if (context.has(Fault::kClipNoperspectiveInSpace)) {
      window.noperspective[i] = static_cast<double>(corner.weights[i]);
    }
  }
  window.snapped = {.x = snap(context, window.x), .y = snap(context, window.y)};
  const auto to_pixels = [&](double position, double centre) {
    return snap(context, position < centre ? std::floor(position) : std::ceil(position));
  };
  const VkViewport& viewport = context.state().viewport;
  if (context.has(Fault::kClipCornersToPixels) && corner.is_new) {
    window.snapped = {.x = to_pixels(window.x, double{viewport.x} + double{viewport.width} / 2),
                      .y = to_pixels(window.y, double{viewport.y} + double{viewport.height} / 2)};
  }
  if (context.has(Fault::kSnapRowsToPixels)) window.snapped.y = snap(context, std::nearbyint(window.y));
  return window;
}

bool out_of_range(const Context& context, const std::vector<WindowCorner>& corners) {
  constexpr double kRange = 2048;  // pixels
  return context.has(Fault::kCullRangeTooSmall) && std::ranges::any_of(corners, [](const WindowCorner& one) {
           return std::abs(one.x) > kRange || std::abs(one.y) > kRange;
         });
}

bool is_front_facing(const Context& context, const std::vector<Corner>& clipped,
                     const std::vector<WindowCorner>& corners) {
  std::vector<Place> places;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Snapped& snapped = corners[i].snapped;
    places.push_back({.x = static_cast<double>(snapped.x), .y = static_cast<double>(snapped.y)});
    if (context.has(Fault::kFacingBeforeDivide)) {
      const double y_sign = context.state().viewport.height < 0 ? -1 : 1;
      places[i] = {.x = static_cast<double>(clipped[i].position[0]),
                   .y = static_cast<double>(clipped[i].position[1]) * y_sign};
    }
    if (context.has(Fault::kFacingUnflipped) && context.state().viewport.height < 0) places[i].y = -places[i].y;
  }
  const double area = clockwise_area(places);
  if (area == 0) return context.has(Fault::kZeroAreaIsFront);
  const bool clockwise_is_front =
      context.state().front_face == VK_FRONT_FACE_CLOCKWISE && !context.has(Fault::kFrontFaceIgnored);
  return (area > 0) == clockwise_is_front;
}

bool is_culled(const Context& context, bool front_facing) {
  return (context.state().cull_mode & (front_facing ? VK_CULL_MODE_FRONT_BIT : VK_CULL_MODE_BACK_BIT)) != 0;
}

}  // namespace fillrule::faults
