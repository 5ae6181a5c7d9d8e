// Fixed-point framebuffer coordinates, and why no integer of the rasterizer can overflow.
//
// A snapped coordinate counts subpixels of 1/2^subpixel_bits px (Vulkan: subPixelPrecisionBits), bits from 4 to 8, in
// an int32. At most kGuardBandPixels = 2^21 px from the origin of the framebuffer are reached, so with 8 bits:
//   coordinate             |x| <= 2^29
//   difference of two      |d| <= 2^30          int32
//   product of two of them      <= 2^60          int64
//   edge function, 2 x area    <= 2^61          int64 (twice the area of a triangle in that square is <= 2^60)
//   sum over a polygon's pieces <= 2^61         int64
// The last one since the pieces up to any of them make a polygon that is convex but for snapping, so that its area is
// that of the square at most, and a subpixel along its circumference (2^32 subpixels).
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace fillrule::renderer {

inline constexpr uint32_t kMinSubpixelBits = 4;
inline constexpr uint32_t kMaxSubpixelBits = 8;
inline constexpr double kGuardBandPixels = 2097152.0;  // 2^21

// Framebuffer coordinates, y down, in subpixels.
struct FixedPosition {
  int32_t x_fixed = 0;
  int32_t y_fixed = 0;
  bool operator==(const FixedPosition&) const = default;
};

// Snaps a framebuffer coordinate (pixels) to the subpixel grid, to the nearest, ties to even. The clamp only catches
// the last rounding of a vertex that clipping put on the border of the guard band.
inline int32_t snap(double coordinate_framebuffer, uint32_t subpixel_bits) {
  const double clamped = std::clamp(coordinate_framebuffer, -kGuardBandPixels, kGuardBandPixels);
  const double subpixels = clamped * static_cast<double>(1U << subpixel_bits);  // exact: a power of two
  // Adding 1.5 * 2^52 leaves no bit for a fraction: the addition itself rounds to nearest even, without a call.
  constexpr double kNoFraction = 0x1.8p52;
  return static_cast<int32_t>(std::bit_cast<int64_t>(subpixels + kNoFraction) - std::bit_cast<int64_t>(kNoFraction));
}

// The centre within a pixel, from its left and top border.
inline constexpr FixedPosition pixel_centre_fixed(uint32_t subpixel_bits) {
  return {1 << (subpixel_bits - 1), 1 << (subpixel_bits - 1)};
}

// The first pixel whose sample, at `sample_fixed` within each pixel, is at or after the coordinate. A range [min,
// max) of coordinates holds the samples of the pixels [first_pixel(min), first_pixel(max)): the half-open range that
// the top-left rule asks for.
inline constexpr int32_t first_pixel(int32_t coordinate_fixed, int32_t sample_fixed, uint32_t subpixel_bits) {
  return (coordinate_fixed - sample_fixed + (1 << subpixel_bits) - 1) >> subpixel_bits;
}

// Whole pixels, left and top inside, right and bottom outside.
struct PixelRect {
  int32_t left = 0;
  int32_t top = 0;
  int32_t right = 0;
  int32_t bottom = 0;
  [[nodiscard]] bool empty() const { return left >= right || top >= bottom; }
  [[nodiscard]] int32_t width() const { return right - left; }
  [[nodiscard]] int32_t height() const { return bottom - top; }
  bool operator==(const PixelRect&) const = default;
};

inline PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

// A rectangle around both.
inline PixelRect hull(const PixelRect& a, const PixelRect& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
}

}  // namespace fillrule::renderer
