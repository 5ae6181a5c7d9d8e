// A third, lean way into the reference: one draw to RGBA8 and D32F as an application has it, to be timed. Nothing is
// counted and nothing read back, except by picture().
//
// The scene's vertices carry their final clip-space position and up to four vec4, interpolated perspective-correctly
// or flat; the fragment's colour is their mean. Depth is tested with LESS and written. Vulkan specification,
// "Rasterization", "Render Pass".
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/result.h"
#include "reference/vulkan/reference.h"

namespace fillrule::vulkan {

inline constexpr uint32_t kMaxColorAttributes = 4;

// What is drawn; whatever it refers to must stay until ColorDrawer::create() has returned.
struct ColorScene {
  uint32_t target_size = 0;  // pixels, of width and of height
  uint32_t samples = 1;      // of a pixel
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkCullModeFlags cull_mode = VK_CULL_MODE_NONE;  // counter-clockwise is front
  std::span<const ClipPosition> positions_clip;
  uint32_t attribute_count = 1;                      // vec4 of a vertex, 1 to kMaxColorAttributes
  std::span<const std::array<float, 4>> attributes;  // [vertex][attribute]
  bool is_flat = false;                              // the provoking vertex' values, else smooth
  std::span<const uint32_t> indices;
};

struct ColorDrawOptions {
  std::string driver = "lavapipe";
  std::vector<std::string> driver_files;  // as in list_devices
  // That rasterize. Of lavapipe: 1 leaves it no thread but the one that submits, any other number is that of its
  // rasterizer's threads. Other drivers have as many as they like.
  uint32_t threads = 1;
  bool validation = false;
};

// One device, one scene, one recorded draw. Not for use by two threads at once.
class ColorDrawer {
 public:
  static Result<ColorDrawer> create(const ColorDrawOptions& options, const ColorScene& scene);

  ColorDrawer(ColorDrawer&& other) noexcept;
  ColorDrawer& operator=(ColorDrawer&& other) noexcept;
  ColorDrawer(const ColorDrawer&) = delete;
  ColorDrawer& operator=(const ColorDrawer&) = delete;
  ~ColorDrawer();

  [[nodiscard]] const DeviceInfo& device() const;

  // Clears colour to 0 and depth to 1, and draws. Returns when the device is done.
  [[nodiscard]] Result<void> draw() const;

  // What the last draw left: RGBA8 row by row from the top left, red in the lowest byte, samples resolved.
  [[nodiscard]] Result<std::vector<uint32_t>> picture() const;

  // Everything the validation layers had to say so far.
  [[nodiscard]] std::vector<std::string> validation_messages() const;

 private:
  struct State;
  explicit ColorDrawer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace fillrule::vulkan
