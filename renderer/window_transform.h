// From clip space to snapped framebuffer coordinates (Vulkan, "Coordinate Transformations" and "Controlling the
// Viewport"), and which vertices need clipping first.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "cases/model/case.h"
#include "renderer/fixed_point.h"
#include "renderer/lanes.h"

namespace fillrule::renderer {

// A clip-space position in more than float precision: Real is double or DoubleDouble. Every float is exact in it, and
// no product of four floats overflows.
template <typename Real>
struct HomogeneousPosition {
  Real x = 0;
  Real y = 0;
  Real z = 0;
  Real w = 0;
};

// Framebuffer coordinates in pixels, y down.
struct FramebufferPosition {
  double x = 0;
  double y = 0;
};

// The planes against which triangles are clipped; each has a bit of its own in a vertex' clip code. The sides are
// those of the guard band, not of the viewport: pixels outside the viewport are left out by a rectangle instead. The
// near and far planes come first, so that a volume without them begins at kLeft.
enum class ClipPlane : uint8_t { kNear, kFar, kLeft, kRight, kTop, kBottom };
inline constexpr uint32_t kClipPlanes = 6;

// Bit i: outside of ClipPlane i. The upper eight bits: outside of a user's clip distance, kClipFirstUser << i.
using ClipCode = uint16_t;
inline constexpr ClipCode kClipAtOrigin = 0x40;  // (0, 0, 0, 0): inside of every plane, yet projected nowhere
inline constexpr ClipCode kClipNotFinite = 0x80;
inline constexpr ClipCode kClipFirstUser = 0x100;

// The part of the clip volume that a pipeline may choose.
struct DepthVolume {
  bool clips = true;                 // at the near and far planes
  bool negative_one_to_one = false;  // -w <= z <= w instead of 0 <= z <= w
};

struct WindowVertex {
  FixedPosition position;  // only meaningful with clip code 0
  ClipCode clip_code = 0;
  uint8_t cull_code = 0;  // bit i: the user's cull distance i is negative
};

// Takes the user's distances at the vertex into its codes. A clip distance that is not finite, of which nothing can
// be interpolated, drops the vertex' primitives like such a position.
void add_user_distances(std::span<const float> clip_distances, std::span<const float> cull_distances,
                        WindowVertex& vertex);

class WindowTransform {
 public:
  // The viewport must be within Vulkan's limits (see validate() of pipeline.h); its height may be negative.
  WindowTransform(const VkViewport& viewport, uint32_t subpixel_bits, const DepthVolume& depth_volume = {});

  // Depends on the vertex alone, so that triangles which share it agree about it, clipped or not. A vertex inside the
  // clip volume goes through lavapipe's float32 arithmetic (same snapped coordinate, same coverage); any other
  // through double precision.
  [[nodiscard]] WindowVertex window_vertex(const ClipPosition& pos_clip) const;

  // The same of as many vertices as there are lanes (lanes.h), which must follow each other.
  template <typename L>
  void window_vertices(const ClipPosition* positions_clip, WindowVertex* vertices) const;

  // Where a vertex inside of the view volume is, before it is snapped: by the same arithmetic as window_vertex() has.
  [[nodiscard]] FramebufferPosition vertex_framebuffer(const ClipPosition& pos_clip) const;

  // The same for a position made by clipping, in double precision; w must be positive.
  [[nodiscard]] FramebufferPosition framebuffer(const HomogeneousPosition<double>& pos_clip) const;

  // Within the sides of the viewport, and between near and far where those clip. False unless w > 0.
  [[nodiscard]] bool is_inside_clip_volume(const ClipPosition& pos_clip) const;

  // Double precision all the way to the snap; w must be positive.
  [[nodiscard]] FixedPosition project(const HomogeneousPosition<double>& pos_clip) const;

  // The planes to clip by are those from this one on, in the order of the enumeration.
  [[nodiscard]] uint32_t first_plane() const {
    return static_cast<uint32_t>(depth_volume_.clips ? ClipPlane::kNear : ClipPlane::kLeft);
  }

  // Negative outside of the plane; linear in the position. For a position of floats the sign is exact in any Real.
  template <typename Real>
  [[nodiscard]] Real distance(ClipPlane plane, const HomogeneousPosition<Real>& pos_clip) const;

  // Moves a position that lies on the plane but for rounding exactly onto it.
  template <typename Real>
  void put_on(ClipPlane plane, HomogeneousPosition<Real>& pos_clip) const;

  // The pixels whose sample at `sample_fixed` the viewport holds. Its corners are snapped like a vertex at NDC -1 or
  // 1, hence the result equals clipping a polygon to the snapped viewport by the top-left rule.
  [[nodiscard]] PixelRect viewport_pixels(const FixedPosition& sample_fixed) const;

  [[nodiscard]] uint32_t subpixel_bits() const { return subpixel_bits_; }

 private:
  [[nodiscard]] FramebufferPosition framebuffer_as_lavapipe(const ClipPosition& pos_clip) const;
  [[nodiscard]] FixedPosition snapped(const FramebufferPosition& position_framebuffer) const;

  // Where w and 1/w both are normal floats.
  static constexpr float kLeastInvertible = 0x1p-126F;
  static constexpr float kGreatestInvertible = 0x1p126F;
  static bool is_invertible(float w) { return w >= kLeastInvertible && w <= kGreatestInvertible; }

  // x_framebuffer = x_ndc * half_width_ + centre_x_, in pixels; float32 as lavapipe has them.
  float half_width_;
  float half_height_;
  float centre_x_;
  float centre_y_;
  // The guard band: |x| <= guard_x_ * w keeps |x_framebuffer| below kGuardBandPixels. Floats, so that the product
  // with a float w is exact in double.
  float guard_x_;
  float guard_y_;
  uint32_t subpixel_bits_;
  DepthVolume depth_volume_;
};

template <typename L>
[[gnu::always_inline]] inline void WindowTransform::window_vertices(const ClipPosition* positions_clip,
                                                                    WindowVertex* vertices) const {
  using Float = typename L::Float;
  const auto [x, y, z, w] =
      L::load_components([&](uint32_t lane) __attribute__((always_inline)) { return positions_clip[lane].data(); });
  const Float minus_w = L::all(0.0F) - w;
  const Float near = depth_volume_.negative_one_to_one ? minus_w : L::all(0.0F);
  typename L::Mask is_usual = w >= L::all(kLeastInvertible);
  is_usual &= w <= L::all(kGreatestInvertible);
  for (const Float& side : {x, y}) {
    is_usual &= minus_w <= side;
    is_usual &= side <= w;
  }
  if (depth_volume_.clips) {
    is_usual &= near <= z;
    is_usual &= z <= w;
  }
  // As framebuffer_as_lavapipe() and snap().
  const Float reciprocal_w = L::all(1.0F) / w;
  const auto snapped = [&](const Float& coordinate, float half_extent, float centre) __attribute__((always_inline)) {
    const Float framebuffer = L::fused(coordinate * reciprocal_w, L::all(half_extent), L::all(centre));
    const Float subpixels = L::to_nearest(framebuffer * L::all(static_cast<float>(1U << subpixel_bits_)));
    return L::truncated(is_usual ? subpixels : L::all(0.0F));
  };
  std::array<int32_t, L::kWidth> xs_fixed;
  std::array<int32_t, L::kWidth> ys_fixed;
  L::store(snapped(x, half_width_, centre_x_), xs_fixed.data());
  L::store(snapped(y, half_height_, centre_y_), ys_fixed.data());
  for (uint32_t lane = 0; lane < L::kWidth; ++lane) {
    vertices[lane] = {.position = {xs_fixed[lane], ys_fixed[lane]}};
  }
  constexpr uint32_t kAllLanes = (1U << L::kWidth) - 1;
  for (uint32_t rest = ~L::bits_of(is_usual) & kAllLanes; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<uint32_t>(std::countr_zero(rest));
    vertices[lane] = window_vertex(positions_clip[lane]);
  }
}

template <typename Real>
Real WindowTransform::distance(ClipPlane plane, const HomogeneousPosition<Real>& pos_clip) const {
  switch (plane) {
    case ClipPlane::kNear:
      return depth_volume_.negative_one_to_one ? pos_clip.z + pos_clip.w : pos_clip.z;
    case ClipPlane::kFar:
      return pos_clip.w - pos_clip.z;
    case ClipPlane::kLeft:
      return pos_clip.w * guard_x_ + pos_clip.x;
    case ClipPlane::kRight:
      return pos_clip.w * guard_x_ - pos_clip.x;
    case ClipPlane::kTop:
      return pos_clip.w * guard_y_ + pos_clip.y;
    case ClipPlane::kBottom:
      break;
  }
  return pos_clip.w * guard_y_ - pos_clip.y;
}

template <typename Real>
void WindowTransform::put_on(ClipPlane plane, HomogeneousPosition<Real>& pos_clip) const {
  switch (plane) {
    case ClipPlane::kNear:
      pos_clip.z = depth_volume_.negative_one_to_one ? -pos_clip.w : Real{0};
      return;
    case ClipPlane::kFar:
      pos_clip.z = pos_clip.w;
      return;
    case ClipPlane::kLeft:
      pos_clip.x = pos_clip.w * -guard_x_;
      return;
    case ClipPlane::kRight:
      pos_clip.x = pos_clip.w * guard_x_;
      return;
    case ClipPlane::kTop:
      pos_clip.y = pos_clip.w * -guard_y_;
      return;
    case ClipPlane::kBottom:
      pos_clip.y = pos_clip.w * guard_y_;
      return;
  }
}

}  // namespace fillrule::renderer
