// A texture on the device: its image with all levels, and a sampler with its state. Vulkan specification, "Images",
// "Samplers".
#pragma once

#include <memory>

#include "cases/model/texture.h"
#include "reference/vulkan/device.h"

namespace fillrule::vulkan {

struct SampledImage {
  std::shared_ptr<const Texture> texture;
  Memory memory;  // before the image, so that it goes after it
  Image image;
  ImageView view;
  Sampler sampler;
};

// Without its texels yet. Fails where the device cannot filter such a texture, or the texture is not complete.
Result<SampledImage> create_sampled_image(const Device& device, const std::shared_ptr<const Texture>& texture);

// Copies the texels, with a command buffer that is ready to be begun, and waits until fragment shaders may read them.
Result<void> upload(const Device& device, VkCommandBuffer commands, const SampledImage& sampled);

}  // namespace fillrule::vulkan
