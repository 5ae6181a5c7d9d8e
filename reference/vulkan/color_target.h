// The attachments of color_draw.h, of one sample or several, and the image that several are resolved into.
// Vulkan specification, "Image Creation", "Render Pass", "Resolving Multisample Images".
#pragma once

#include "reference/vulkan/device.h"

namespace fillrule::vulkan {

struct BoundImage {
  Memory memory;  // before the image, so that it goes after it
  Image image;
  ImageView view;
};

class ColorTarget {
 public:
  ColorTarget() = default;
  static Result<ColorTarget> create(const Device& device, uint32_t size, uint32_t samples);

  // Begins to render: colour cleared to 0, depth to 1.
  void record_begin(VkCommandBuffer commands) const;

  // Resolves, if there are several samples, and copies to a buffer that the host may read afterwards.
  void record_copy(VkCommandBuffer commands, VkBuffer readback) const;

 private:
  uint32_t size_ = 0;
  uint32_t samples_ = 1;
  BoundImage color_;
  BoundImage depth_;
  BoundImage resolved_;  // with several samples
};

}  // namespace fillrule::vulkan
