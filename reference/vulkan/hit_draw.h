// A second, lean way into the reference: one draw of a great many small triangles in the plane, of which nothing is
// read back but how often each pixel was hit. For exhaustive proofs of coverage, where Planes would cost more than
// the drawing.
//
// The target is a square of R8_UNORM with additive blending: each fragment adds kHit, one of a front-facing triangle
// kFrontHit instead; so a pixel that is hit twice shows. Vulkan specification, "Rasterization", "Blending".
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cases/model/result.h"
#include "reference/vulkan/reference.h"

namespace fillrule::vulkan {

// What a fragment adds to its pixel: hits in the low four bits, those of front faces in the high four.
inline constexpr uint8_t kHit = 0x01;
inline constexpr uint8_t kFrontHit = 0x11;

struct HitDrawOptions {
  std::string driver = "lavapipe";
  std::vector<std::string> driver_files;  // as in list_devices
  uint32_t target_size = 0;               // pixels, of width and of height
  uint32_t max_vertices = 0;
  bool validation = false;
};

// Clip space, (x, y); z is 0.5 and w is 1.
using PlanePosition = std::array<float, 2>;

// One device with its target and buffers. Not for use by two threads at once.
class HitDrawer {
 public:
  static Result<HitDrawer> create(const HitDrawOptions& options);

  HitDrawer(HitDrawer&& other) noexcept;
  HitDrawer& operator=(HitDrawer&& other) noexcept;
  HitDrawer(const HitDrawer&) = delete;
  HitDrawer& operator=(const HitDrawer&) = delete;
  ~HitDrawer();

  [[nodiscard]] const DeviceInfo& device() const;

  // Clears the target, draws a triangle list with a viewport that is the whole target (counter-clockwise is front),
  // and copies the target to `hits`, row by row from the top left.
  Result<void> draw(std::span<const PlanePosition> positions_clip, VkCullModeFlags cull_mode,
                    std::span<uint8_t> hits);

  // Everything the validation layers had to say so far.
  [[nodiscard]] std::vector<std::string> validation_messages() const;

 private:
  struct State;
  explicit HitDrawer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace fillrule::vulkan
