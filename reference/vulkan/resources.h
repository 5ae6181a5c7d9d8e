// What a program reads beside its vertices: for each draw a block of uniforms and a sampled image, in descriptor set
// 0 at the bindings 0 and 1. Vulkan specification, "Resource Descriptors", "Samplers".
//
// The block is in a storage buffer: where branches depend on a uniform buffer, lavapipe puts its values into the
// shader and compiles it again for each draw.
//
// Both bindings of every set are written, the image of a draw without a texture being one white texel: lavapipe
// breaks down at a combined image sampler that is not, even where no shader reads it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "reference/vulkan/device.h"
#include "reference/vulkan/reference.h"
#include "reference/vulkan/sampled_image.h"

namespace fillrule::vulkan {

class ResourceBinder {
 public:
  // `device` must outlive the binder.
  static Result<ResourceBinder> create(const Device& device, uint32_t uniform_bytes);

  [[nodiscard]] VkDescriptorSetLayout layout() const { return layout_.get(); }

  // A set for each draw, good until the next call. Images stay for as long as somebody else keeps their texture.
  Result<std::vector<VkDescriptorSet>> bind(std::span<const DrawResources> draws);

 private:
  explicit ResourceBinder(const Device& device) : device_(&device) {}
  Result<void> create_layout();
  Result<void> create_commands();
  Result<void> fit(uint32_t sets);
  void drop_unused_images();
  Result<const SampledImage*> find_or_create(const std::shared_ptr<const Texture>& texture);
  void write(VkDescriptorSet set, uint64_t uniform_offset, const SampledImage& image) const;

  const Device* device_;
  uint32_t uniform_bytes_ = 0;
  std::shared_ptr<const Texture> white_;
  DescriptorSetLayout layout_;
  CommandPool command_pool_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  HostBuffer uniforms_;
  DescriptorPool pool_;
  uint32_t pool_sets_ = 0;
  std::map<const Texture*, SampledImage> images_;
};

}  // namespace fillrule::vulkan
