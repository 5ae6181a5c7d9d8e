#include "reference/vulkan/hit_draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "reference/vulkan/device.h"
#include "reference/vulkan/hit_pipeline.h"
#include "reference/vulkan/instance.h"

namespace fillrule::vulkan {
namespace {

constexpr VkImageSubresourceRange kWholeImage{
    .aspectMask = VK_IMAGE_ASPECT_COLOR_BIT, .levelCount = 1, .layerCount = 1};

// The square that hits are counted in.
struct HitTarget {
  Memory memory;  // before the image, so that it goes after it
  Image image;
  ImageView view;
};

Result<HitTarget> create_target(const Device& device, uint32_t size) {
  if (size == 0 || size > device.info().max_target_size) {
    return failure(
        fmt::format("a target of {} x {} pixels is beyond the limits of {}", size, size, device.info().name),
        fmt::format("at most {}", device.info().max_target_size));
  }
  HitTarget target;
  const VkImageCreateInfo image_info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                     .imageType = VK_IMAGE_TYPE_2D,
                                     .format = kHitCountFormat,
                                     .extent = {size, size, 1},
                                     .mipLevels = 1,
                                     .arrayLayers = 1,
                                     .samples = VK_SAMPLE_COUNT_1_BIT,
                                     .tiling = VK_IMAGE_TILING_OPTIMAL,
                                     .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT};
  VkImage image = VK_NULL_HANDLE;
  VkResult result = vkCreateImage(device.get(), &image_info, nullptr, &image);
  if (result != VK_SUCCESS) return failed_call("vkCreateImage", result);
  target.image = Image(device.get(), image);

  VkMemoryRequirements requirements;
  vkGetImageMemoryRequirements(device.get(), image, &requirements);
  Result<Memory> memory = device.allocate(requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  if (!memory) return tl::unexpected(memory.error());
  target.memory = std::move(*memory);
  result = vkBindImageMemory(device.get(), image, target.memory.get(), 0);
  if (result != VK_SUCCESS) return failed_call("vkBindImageMemory", result);

  const VkImageViewCreateInfo view_info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                        .image = image,
                                        .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                        .format = kHitCountFormat,
                                        .subresourceRange = kWholeImage};
  VkImageView view = VK_NULL_HANDLE;
  result = vkCreateImageView(device.get(), &view_info, nullptr, &view);
  if (result != VK_SUCCESS) return failed_call("vkCreateImageView", result);
  target.view = ImageView(device.get(), view);
  return target;
}

void record_image_barrier(VkCommandBuffer commands, const VkImageMemoryBarrier2& barrier) {
  const VkDependencyInfo info{
      .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier};
  vkCmdPipelineBarrier2(commands, &info);
}

// Hazard: the clear writes after the layout transition has written. The last draw's copy was over when its fence was.
void record_begin_barrier(VkCommandBuffer commands, VkImage image) {
  record_image_barrier(
      commands, {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                 .srcStageMask = VK_PIPELINE_STAGE_2_NONE,
                 .srcAccessMask = VK_ACCESS_2_NONE,
                 .dstStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                 .dstAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                 .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED,
                 .newLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL,
                 .image = image,
                 .subresourceRange = kWholeImage});
}

// Hazard: the copy reads after the pass has stored.
void record_copy_barrier(VkCommandBuffer commands, VkImage image) {
  record_image_barrier(commands, {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                  .srcStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                  .srcAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                                  .dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT,
                                  .dstAccessMask = VK_ACCESS_2_TRANSFER_READ_BIT,
                                  .oldLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL,
                                  .newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                  .image = image,
                                  .subresourceRange = kWholeImage});
}

// Hazard: the host reads after the copy has written.
void record_host_barrier(VkCommandBuffer commands) {
  const VkMemoryBarrier2 barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                                 .srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT,
                                 .srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                 .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT,
                                 .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT};
  const VkDependencyInfo info{
      .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &barrier};
  vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace

// Members refer to those above them, which therefore never move.
struct HitDrawer::State {
  State(Instance the_instance, Device the_device)
      : instance(std::move(the_instance)), device(std::move(the_device)) {}

  Result<void> create_commands();
  void record_pass(uint32_t vertices, VkCullModeFlags cull_mode) const;
  [[nodiscard]] Result<void> submit(uint32_t vertices, VkCullModeFlags cull_mode) const;

  Instance instance;
  Device device;
  uint32_t size = 0;          // pixels
  uint32_t max_vertices = 0;  // that the upload buffer holds
  HitTarget target;
  HitPipeline pipeline;
  HostBuffer upload;
  HostBuffer readback;
  CommandPool command_pool;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  Fence fence;
};

Result<void> HitDrawer::State::create_commands() {
  const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                          .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                                          .queueFamilyIndex = device.queue_family()};
  VkCommandPool pool = VK_NULL_HANDLE;
  VkResult result = vkCreateCommandPool(device.get(), &pool_info, nullptr, &pool);
  if (result != VK_SUCCESS) return failed_call("vkCreateCommandPool", result);
  command_pool = CommandPool(device.get(), pool);
  const VkCommandBufferAllocateInfo commands_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                  .commandPool = pool,
                                                  .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                  .commandBufferCount = 1};
  result = vkAllocateCommandBuffers(device.get(), &commands_info, &commands);
  if (result != VK_SUCCESS) return failed_call("vkAllocateCommandBuffers", result);
  const VkFenceCreateInfo fence_info{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  VkFence fence_handle = VK_NULL_HANDLE;
  result = vkCreateFence(device.get(), &fence_info, nullptr, &fence_handle);
  if (result != VK_SUCCESS) return failed_call("vkCreateFence", result);
  fence = Fence(device.get(), fence_handle);
  return {};
}

void HitDrawer::State::record_pass(uint32_t vertices, VkCullModeFlags cull_mode) const {
  const VkRenderingAttachmentInfo attachment{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                             .imageView = target.view.get(),
                                             .imageLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL,
                                             .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                             .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
  const VkRenderingInfo rendering{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                                  .renderArea = {.extent = {size, size}},
                                  .layerCount = 1,
                                  .colorAttachmentCount = 1,
                                  .pColorAttachments = &attachment};
  vkCmdBeginRendering(commands, &rendering);
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.pipeline.get());
  vkCmdSetCullMode(commands, cull_mode);
  VkBuffer buffer = upload.get();
  const VkDeviceSize offset = 0;
  vkCmdBindVertexBuffers(commands, 0, 1, &buffer, &offset);
  vkCmdDraw(commands, vertices, 1, 0, 0);
  vkCmdEndRendering(commands);
}

Result<void> HitDrawer::State::submit(uint32_t vertices, VkCullModeFlags cull_mode) const {
  VkResult result = vkResetCommandPool(device.get(), command_pool.get(), 0);
  if (result != VK_SUCCESS) return failed_call("vkResetCommandPool", result);
  const VkCommandBufferBeginInfo begin_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                            .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  result = vkBeginCommandBuffer(commands, &begin_info);
  if (result != VK_SUCCESS) return failed_call("vkBeginCommandBuffer", result);
  // The upload buffer needs no barrier: submitting makes the host's writes visible.
  record_begin_barrier(commands, target.image.get());
  record_pass(vertices, cull_mode);
  record_copy_barrier(commands, target.image.get());
  const VkBufferImageCopy region{.imageSubresource = {.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT, .layerCount = 1},
                                 .imageExtent = {size, size, 1}};
  vkCmdCopyImageToBuffer(commands, target.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readback.get(), 1,
                         &region);
  record_host_barrier(commands);
  result = vkEndCommandBuffer(commands);
  if (result != VK_SUCCESS) return failed_call("vkEndCommandBuffer", result);

  VkFence fence_handle = fence.get();
  result = vkResetFences(device.get(), 1, &fence_handle);
  if (result != VK_SUCCESS) return failed_call("vkResetFences", result);
  const VkSubmitInfo submit_info{
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
  result = vkQueueSubmit(device.queue(), 1, &submit_info, fence_handle);
  if (result != VK_SUCCESS) return failed_call("vkQueueSubmit", result);
  result = vkWaitForFences(device.get(), 1, &fence_handle, VK_TRUE, UINT64_MAX);
  if (result != VK_SUCCESS) return failed_call("vkWaitForFences", result);
  return {};
}

Result<HitDrawer> HitDrawer::create(const HitDrawOptions& options) {
  Result<Instance> instance = Instance::create(options.driver_files, options.validation);
  if (!instance) return tl::unexpected(instance.error());
  const Result<PhysicalDevice> physical = instance->choose_device(options.driver);
  if (!physical) return tl::unexpected(physical.error());
  Result<Device> device = Device::create(*physical);
  if (!device) return tl::unexpected(device.error());

  auto state = std::make_unique<State>(std::move(*instance), std::move(*device));
  state->size = options.target_size;
  state->max_vertices = options.max_vertices;
  Result<HitTarget> target = create_target(state->device, options.target_size);
  if (!target) return tl::unexpected(target.error());
  state->target = std::move(*target);
  Result<HitPipeline> pipeline = create_hit_pipeline(state->device, options.target_size);
  if (!pipeline) return tl::unexpected(pipeline.error());
  state->pipeline = std::move(*pipeline);
  const uint64_t upload_bytes = std::max<uint64_t>(options.max_vertices, 3) * sizeof(PlanePosition);
  Result<HostBuffer> upload = HostBuffer::create(state->device, upload_bytes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  if (!upload) return tl::unexpected(upload.error());
  state->upload = std::move(*upload);
  const uint64_t pixels = uint64_t{options.target_size} * options.target_size;
  Result<HostBuffer> readback = HostBuffer::create(state->device, pixels, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  if (!readback) return tl::unexpected(readback.error());
  state->readback = std::move(*readback);
  if (const Result<void> created = state->create_commands(); !created) return tl::unexpected(created.error());
  return HitDrawer(std::move(state));
}

HitDrawer::HitDrawer(std::unique_ptr<State> state) : state_(std::move(state)) {}
HitDrawer::HitDrawer(HitDrawer&&) noexcept = default;
HitDrawer& HitDrawer::operator=(HitDrawer&&) noexcept = default;
HitDrawer::~HitDrawer() = default;

const DeviceInfo& HitDrawer::device() const {
  return state_->device.info();
}

std::vector<std::string> HitDrawer::validation_messages() const {
  return state_->instance.log().messages();
}

Result<void> HitDrawer::draw(std::span<const PlanePosition> positions_clip, VkCullModeFlags cull_mode,
                             std::span<uint8_t> hits) {
  if (positions_clip.size() > state_->max_vertices || hits.size() != state_->readback.size()) {
    return failure(fmt::format("a draw of {} vertices to {} pixels, with room for {} and {}", positions_clip.size(),
                               hits.size(), state_->max_vertices, state_->readback.size()));
  }
  std::memcpy(state_->upload.bytes().data(), positions_clip.data(), positions_clip.size_bytes());
  if (auto drawn = state_->submit(static_cast<uint32_t>(positions_clip.size()), cull_mode); !drawn) {
    return drawn;
  }
  std::memcpy(hits.data(), state_->readback.bytes().data(), hits.size());
  return {};
}

}  // namespace fillrule::vulkan
