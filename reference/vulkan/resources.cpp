#include "reference/vulkan/resources.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace fillrule::vulkan {
namespace {

// The largest alignment that Vulkan lets a device ask of storage buffers.
constexpr uint64_t kUniformAlignment = 256;

uint64_t uniform_stride(uint32_t bytes) {
  return (bytes + kUniformAlignment - 1) / kUniformAlignment * kUniformAlignment;
}

}  // namespace

Result<ResourceBinder> ResourceBinder::create(const Device& device, uint32_t uniform_bytes) {
  ResourceBinder binder(device);
  binder.uniform_bytes_ = uniform_bytes;
  binder.white_ = std::make_shared<const Texture>(
      Texture{.levels = {TextureLevel{.width = 1, .height = 1, .texels = {{1, 1, 1, 1}}}}});
  if (const auto created = binder.create_layout(); !created) return tl::unexpected(created.error());
  if (const auto created = binder.create_commands(); !created) return tl::unexpected(created.error());
  return binder;
}

Result<void> ResourceBinder::create_layout() {
  constexpr VkShaderStageFlags kStages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
  const std::array bindings{VkDescriptorSetLayoutBinding{.binding = 0,
                                                         .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                                         .descriptorCount = 1,
                                                         .stageFlags = kStages},
                            VkDescriptorSetLayoutBinding{.binding = 1,
                                                         .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                                         .descriptorCount = 1,
                                                         .stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT}};
  const VkDescriptorSetLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                             .bindingCount = bindings.size(),
                                             .pBindings = bindings.data()};
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  const VkResult result = vkCreateDescriptorSetLayout(device_->get(), &info, nullptr, &layout);
  if (result != VK_SUCCESS) return failed_call("vkCreateDescriptorSetLayout", result);
  layout_ = DescriptorSetLayout(device_->get(), layout);
  return {};
}

Result<void> ResourceBinder::create_commands() {
  const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                          .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                                          .queueFamilyIndex = device_->queue_family()};
  VkCommandPool pool = VK_NULL_HANDLE;
  VkResult result = vkCreateCommandPool(device_->get(), &pool_info, nullptr, &pool);
  if (result != VK_SUCCESS) return failed_call("vkCreateCommandPool", result);
  command_pool_ = CommandPool(device_->get(), pool);
  const VkCommandBufferAllocateInfo commands_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                  .commandPool = pool,
                                                  .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                  .commandBufferCount = 1};
  result = vkAllocateCommandBuffers(device_->get(), &commands_info, &commands_);
  if (result != VK_SUCCESS) return failed_call("vkAllocateCommandBuffers", result);
  return {};
}

Result<std::vector<VkDescriptorSet>> ResourceBinder::bind(std::span<const DrawResources> draws) {
  std::vector<VkDescriptorSet> sets(draws.size(), VK_NULL_HANDLE);
  if (draws.empty()) return sets;
  drop_unused_images();
  if (const auto fitted = fit(static_cast<uint32_t>(draws.size())); !fitted) return tl::unexpected(fitted.error());
  const std::vector<VkDescriptorSetLayout> layouts(draws.size(), layout_.get());
  const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                         .descriptorPool = pool_.get(),
                                         .descriptorSetCount = static_cast<uint32_t>(layouts.size()),
                                         .pSetLayouts = layouts.data()};
  const VkResult result = vkAllocateDescriptorSets(device_->get(), &info, sets.data());
  if (result != VK_SUCCESS) return failed_call("vkAllocateDescriptorSets", result);
  for (size_t i = 0; i < draws.size(); ++i) {
    if (draws[i].uniforms.size() != uniform_bytes_) {
      return failure(fmt::format("uniforms of {} bytes instead of {}", draws[i].uniforms.size(), uniform_bytes_));
    }
    const uint64_t offset = i * uniform_stride(uniform_bytes_);
    std::memcpy(uniforms_.bytes().subspan(offset, uniform_bytes_).data(), draws[i].uniforms.data(), uniform_bytes_);
    const Result<const SampledImage*> image = find_or_create(draws[i].texture ? draws[i].texture : white_);
    if (!image) return tl::unexpected(image.error());
    write(sets[i], offset, **image);
  }
  return sets;
}

void ResourceBinder::drop_unused_images() {
  std::erase_if(images_, [](const auto& entry) { return entry.second.texture.use_count() == 1; });
}

Result<void> ResourceBinder::fit(uint32_t sets) {
  if (sets <= pool_sets_) {
    vkResetDescriptorPool(device_->get(), pool_.get(), 0);
    return {};
  }
  pool_sets_ = std::bit_ceil(sets);
  const std::array sizes{
      VkDescriptorPoolSize{.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .descriptorCount = pool_sets_},
      VkDescriptorPoolSize{.type = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, .descriptorCount = pool_sets_}};
  const VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                        .maxSets = pool_sets_,
                                        .poolSizeCount = sizes.size(),
                                        .pPoolSizes = sizes.data()};
  VkDescriptorPool pool = VK_NULL_HANDLE;
  const VkResult result = vkCreateDescriptorPool(device_->get(), &info, nullptr, &pool);
  if (result != VK_SUCCESS) return failed_call("vkCreateDescriptorPool", result);
  pool_ = DescriptorPool(device_->get(), pool);
  Result<HostBuffer> buffer =
      HostBuffer::create(*device_, pool_sets_ * uniform_stride(uniform_bytes_), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  if (!buffer) return tl::unexpected(buffer.error());
  uniforms_ = std::move(*buffer);
  return {};
}

Result<const SampledImage*> ResourceBinder::find_or_create(const std::shared_ptr<const Texture>& texture) {
  if (const auto found = images_.find(texture.get()); found != images_.end()) return &found->second;
  Result<SampledImage> sampled = create_sampled_image(*device_, texture);
  if (!sampled) return tl::unexpected(sampled.error());
  const VkResult result = vkResetCommandPool(device_->get(), command_pool_.get(), 0);
  if (result != VK_SUCCESS) return failed_call("vkResetCommandPool", result);
  if (const auto done = upload(*device_, commands_, *sampled); !done) return tl::unexpected(done.error());
  return &images_.emplace(texture.get(), std::move(*sampled)).first->second;
}

void ResourceBinder::write(VkDescriptorSet set, uint64_t uniform_offset, const SampledImage& image) const {
  const VkDescriptorBufferInfo buffer{.buffer = uniforms_.get(), .offset = uniform_offset, .range = uniform_bytes_};
  const VkDescriptorImageInfo sampled{.sampler = image.sampler.get(),
                                      .imageView = image.view.get(),
                                      .imageLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  const std::array writes{VkWriteDescriptorSet{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                               .dstSet = set,
                                               .dstBinding = 0,
                                               .descriptorCount = 1,
                                               .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                               .pBufferInfo = &buffer},
                          VkWriteDescriptorSet{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                               .dstSet = set,
                                               .dstBinding = 1,
                                               .descriptorCount = 1,
                                               .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                                               .pImageInfo = &sampled}};
  vkUpdateDescriptorSets(device_->get(), writes.size(), writes.data(), 0, nullptr);
}

}  // namespace fillrule::vulkan
