#include "renderer/window_transform.h"

#include <algorithm>
#include <cmath>

namespace fillrule::renderer {
namespace {

bool is_finite(const ClipPosition& pos_clip) {
  return std::isfinite(pos_clip[0]) && std::isfinite(pos_clip[1]) && std::isfinite(pos_clip[2]) &&
         std::isfinite(pos_clip[3]);
}

float guard_band(float centre_framebuffer, float half_extent) {
  const double guard = (kGuardBandPixels - std::abs(double{centre_framebuffer})) / std::abs(double{half_extent});
  // A viewport of almost no extent reaches nowhere with any factor.
  constexpr double kMaxGuard = 0x1p64;
  return std::nextafter(static_cast<float>(std::min(guard, kMaxGuard)), 0.0F);
}

}  // namespace

WindowTransform::WindowTransform(const VkViewport& viewport, uint32_t subpixel_bits, const DepthVolume& depth_volume)
    : half_width_(viewport.width / 2),
      half_height_(viewport.height / 2),
      centre_x_(viewport.x + half_width_),
      centre_y_(viewport.y + half_height_),
      guard_x_(guard_band(centre_x_, half_width_)),
      guard_y_(guard_band(centre_y_, half_height_)),
      subpixel_bits_(subpixel_bits),
      depth_volume_(depth_volume) {}

bool WindowTransform::is_inside_clip_volume(const ClipPosition& pos_clip) const {
  const auto& [x, y, z, w] = pos_clip;
  const float near = depth_volume_.negative_one_to_one ? -w : 0.0F;
  return w > 0.0F && -w <= x && x <= w && -w <= y && y <= w && (!depth_volume_.clips || (near <= z && z <= w));
}

WindowVertex WindowTransform::window_vertex(const ClipPosition& pos_clip) const {
  if (is_inside_clip_volume(pos_clip) && is_invertible(pos_clip[3])) {
    return {.position = snapped(framebuffer_as_lavapipe(pos_clip))};
  }
  if (!is_finite(pos_clip)) {
    return {.clip_code = kClipNotFinite};
  }
  const HomogeneousPosition<double> position{pos_clip[0], pos_clip[1], pos_clip[2], pos_clip[3]};
  ClipCode code = 0;
  for (uint32_t plane = first_plane(); plane < kClipPlanes; ++plane) {
    if (distance(static_cast<ClipPlane>(plane), position) < 0) {
      code = static_cast<ClipCode>(code | (1U << plane));
    }
  }
  if (code == 0 && position.w <= 0) {
    code = kClipAtOrigin;
  }
  return {.position = code == 0 ? project(position) : FixedPosition{}, .clip_code = code};
}

void add_user_distances(std::span<const float> clip_distances, std::span<const float> cull_distances,
                        WindowVertex& vertex) {
  for (uint32_t i = 0; i < clip_distances.size(); ++i) {
    const float distance = clip_distances[i];
    const uint32_t code =
        !std::isfinite(distance) ? kClipNotFinite : (distance < 0 ? uint32_t{kClipFirstUser} << i : 0U);
    vertex.clip_code = static_cast<ClipCode>(vertex.clip_code | code);
  }
  for (uint32_t i = 0; i < cull_distances.size(); ++i) {
    const uint32_t code = cull_distances[i] < 0 ? 1U << i : 0U;
    vertex.cull_code = static_cast<uint8_t>(vertex.cull_code | code);
  }
}

FramebufferPosition WindowTransform::framebuffer_as_lavapipe(const ClipPosition& pos_clip) const {
  const float reciprocal_w = 1.0F / pos_clip[3];
  return {std::fma(pos_clip[0] * reciprocal_w, half_width_, centre_x_),
          std::fma(pos_clip[1] * reciprocal_w, half_height_, centre_y_)};
}

FramebufferPosition WindowTransform::framebuffer(const HomogeneousPosition<double>& pos_clip) const {
  return {pos_clip.x / pos_clip.w * double{half_width_} + double{centre_x_},
          pos_clip.y / pos_clip.w * double{half_height_} + double{centre_y_}};
}

FramebufferPosition WindowTransform::vertex_framebuffer(const ClipPosition& pos_clip) const {
  const auto& [x, y, z, w] = pos_clip;
  return is_invertible(w) ? framebuffer_as_lavapipe(pos_clip) : framebuffer({x, y, z, w});
}

FixedPosition WindowTransform::snapped(const FramebufferPosition& position_framebuffer) const {
  return {snap(position_framebuffer.x, subpixel_bits_), snap(position_framebuffer.y, subpixel_bits_)};
}

FixedPosition WindowTransform::project(const HomogeneousPosition<double>& pos_clip) const {
  return snapped(framebuffer(pos_clip));
}

PixelRect WindowTransform::viewport_pixels(const FixedPosition& sample_fixed) const {
  const FixedPosition low = snapped(framebuffer_as_lavapipe({-1, -1, 0, 1}));
  const FixedPosition high = snapped(framebuffer_as_lavapipe({1, 1, 0, 1}));
  // A negative height turns top and bottom round.
  const auto [y_min, y_max] = std::minmax(low.y_fixed, high.y_fixed);
  return {first_pixel(low.x_fixed, sample_fixed.x_fixed, subpixel_bits_),
          first_pixel(y_min, sample_fixed.y_fixed, subpixel_bits_),
          first_pixel(high.x_fixed, sample_fixed.x_fixed, subpixel_bits_),
          first_pixel(y_max, sample_fixed.y_fixed, subpixel_bits_)};
}

}  // namespace fillrule::renderer
