#include "reference/vulkan/color_draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "reference/vulkan/color_pipeline.h"
#include "reference/vulkan/color_target.h"
#include "reference/vulkan/device.h"
#include "reference/vulkan/instance.h"

namespace fillrule::vulkan {
namespace {

Result<HostBuffer> create_filled(const Device& device, const void* values, uint64_t bytes, VkBufferUsageFlags usage) {
  Result<HostBuffer> buffer = HostBuffer::create(device, std::max<uint64_t>(bytes, 4), usage);
  if (buffer && bytes > 0) std::memcpy(buffer->bytes().data(), values, bytes);
  return buffer;
}

Result<void> check(const ColorScene& scene) {
  const size_t vertices = scene.positions_clip.size();
  if (scene.attribute_count == 0 || scene.attribute_count > kMaxColorAttributes ||
      scene.attributes.size() != vertices * scene.attribute_count) {
    return failure(fmt::format("{} attributes for {} vertices of {} each", scene.attributes.size(), vertices,
                               scene.attribute_count),
                   fmt::format("1 to {} each", kMaxColorAttributes));
  }
  return {};
}

}  // namespace

// Members refer to those above them, which therefore never move.
struct ColorDrawer::State {
  State(Instance the_instance, Device the_device)
      : instance(std::move(the_instance)), device(std::move(the_device)) {}

  Result<void> create_buffers(const ColorScene& scene);
  Result<void> create_commands();
  [[nodiscard]] Result<void> record_draw(uint32_t index_count) const;
  [[nodiscard]] Result<void> record_copy() const;
  [[nodiscard]] Result<void> submit(VkCommandBuffer commands) const;

  Instance instance;
  Device device;
  ColorTarget target;
  ColorPipeline pipeline;
  HostBuffer positions;
  HostBuffer attributes;
  HostBuffer indices;
  HostBuffer readback;
  CommandPool command_pool;
  VkCommandBuffer draw_commands = VK_NULL_HANDLE;
  VkCommandBuffer copy_commands = VK_NULL_HANDLE;
  Fence fence;
};

Result<void> ColorDrawer::State::create_buffers(const ColorScene& scene) {
  const auto fill = [&](HostBuffer& buffer, const auto& values, VkBufferUsageFlags usage) -> Result<void> {
    Result<HostBuffer> made = create_filled(device, values.data(), values.size_bytes(), usage);
    if (!made) return tl::unexpected(made.error());
    buffer = std::move(*made);
    return {};
  };
  return fill(positions, scene.positions_clip, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT)
      .and_then([&] { return fill(attributes, scene.attributes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT); })
      .and_then([&] { return fill(indices, scene.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT); })
      .and_then([&] {
        const std::vector<uint32_t> pixels(size_t{scene.target_size} * scene.target_size);
        return fill(readback, std::span(pixels), VK_BUFFER_USAGE_TRANSFER_DST_BIT);
      });
}

Result<void> ColorDrawer::State::create_commands() {
  const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                          .queueFamilyIndex = device.queue_family()};
  VkCommandPool pool = VK_NULL_HANDLE;
  VkResult result = vkCreateCommandPool(device.get(), &pool_info, nullptr, &pool);
  if (result != VK_SUCCESS) return failed_call("vkCreateCommandPool", result);
  command_pool = CommandPool(device.get(), pool);
  std::array<VkCommandBuffer, 2> buffers{};
  const VkCommandBufferAllocateInfo commands_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                  .commandPool = pool,
                                                  .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                  .commandBufferCount = static_cast<uint32_t>(buffers.size())};
  result = vkAllocateCommandBuffers(device.get(), &commands_info, buffers.data());
  if (result != VK_SUCCESS) return failed_call("vkAllocateCommandBuffers", result);
  draw_commands = buffers[0];
  copy_commands = buffers[1];
  const VkFenceCreateInfo fence_info{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  VkFence fence_handle = VK_NULL_HANDLE;
  result = vkCreateFence(device.get(), &fence_info, nullptr, &fence_handle);
  if (result != VK_SUCCESS) return failed_call("vkCreateFence", result);
  fence = Fence(device.get(), fence_handle);
  return {};
}

Result<void> ColorDrawer::State::record_draw(uint32_t index_count) const {
  const VkCommandBufferBeginInfo begin_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  VkResult result = vkBeginCommandBuffer(draw_commands, &begin_info);
  if (result != VK_SUCCESS) return failed_call("vkBeginCommandBuffer", result);
  target.record_begin(draw_commands);
  vkCmdBindPipeline(draw_commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.pipeline.get());
  const std::array buffers{positions.get(), attributes.get()};
  const std::array<VkDeviceSize, 2> offsets{};
  vkCmdBindVertexBuffers(draw_commands, 0, static_cast<uint32_t>(buffers.size()), buffers.data(), offsets.data());
  vkCmdBindIndexBuffer(draw_commands, indices.get(), 0, VK_INDEX_TYPE_UINT32);
  vkCmdDrawIndexed(draw_commands, index_count, 1, 0, 0, 0);
  vkCmdEndRendering(draw_commands);
  result = vkEndCommandBuffer(draw_commands);
  if (result != VK_SUCCESS) return failed_call("vkEndCommandBuffer", result);
  return {};
}

Result<void> ColorDrawer::State::record_copy() const {
  const VkCommandBufferBeginInfo begin_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  VkResult result = vkBeginCommandBuffer(copy_commands, &begin_info);
  if (result != VK_SUCCESS) return failed_call("vkBeginCommandBuffer", result);
  target.record_copy(copy_commands, readback.get());
  result = vkEndCommandBuffer(copy_commands);
  if (result != VK_SUCCESS) return failed_call("vkEndCommandBuffer", result);
  return {};
}

Result<void> ColorDrawer::State::submit(VkCommandBuffer commands) const {
  VkFence fence_handle = fence.get();
  const VkSubmitInfo submit_info{
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
  VkResult result = vkQueueSubmit(device.queue(), 1, &submit_info, fence_handle);
  if (result != VK_SUCCESS) return failed_call("vkQueueSubmit", result);
  result = vkWaitForFences(device.get(), 1, &fence_handle, VK_TRUE, UINT64_MAX);
  if (result != VK_SUCCESS) return failed_call("vkWaitForFences", result);
  result = vkResetFences(device.get(), 1, &fence_handle);
  if (result != VK_SUCCESS) return failed_call("vkResetFences", result);
  return {};
}

Result<ColorDrawer> ColorDrawer::create(const ColorDrawOptions& options, const ColorScene& scene) {
  if (auto checked = check(scene); !checked) return tl::unexpected(checked.error());
  const std::string threads = std::to_string(options.threads == 1 ? 0 : options.threads);
  setenv("LP_NUM_THREADS", threads.c_str(), 1);
  Result<Instance> instance = Instance::create(options.driver_files, options.validation);
  if (!instance) return tl::unexpected(instance.error());
  const Result<PhysicalDevice> physical = instance->choose_device(options.driver);
  if (!physical) return tl::unexpected(physical.error());
  Result<Device> device = Device::create(*physical);
  if (!device) return tl::unexpected(device.error());

  auto state = std::make_unique<State>(std::move(*instance), std::move(*device));
  Result<ColorTarget> target = ColorTarget::create(state->device, scene.target_size, scene.samples);
  if (!target) return tl::unexpected(target.error());
  state->target = std::move(*target);
  Result<ColorPipeline> pipeline = create_color_pipeline(state->device, scene);
  if (!pipeline) return tl::unexpected(pipeline.error());
  state->pipeline = std::move(*pipeline);
  const auto index_count = static_cast<uint32_t>(scene.indices.size());
  const Result<void> made = state->create_buffers(scene)
                                .and_then([&] { return state->create_commands(); })
                                .and_then([&] { return state->record_draw(index_count); })
                                .and_then([&] { return state->record_copy(); });
  if (!made) return tl::unexpected(made.error());
  return ColorDrawer(std::move(state));
}

ColorDrawer::ColorDrawer(std::unique_ptr<State> state) : state_(std::move(state)) {}
ColorDrawer::ColorDrawer(ColorDrawer&&) noexcept = default;
ColorDrawer& ColorDrawer::operator=(ColorDrawer&&) noexcept = default;
ColorDrawer::~ColorDrawer() = default;

const DeviceInfo& ColorDrawer::device() const {
  return state_->device.info();
}

std::vector<std::string> ColorDrawer::validation_messages() const {
  return state_->instance.log().messages();
}

Result<void> ColorDrawer::draw() const {
  return state_->submit(state_->draw_commands);
}

Result<std::vector<uint32_t>> ColorDrawer::picture() const {
  if (auto copied = state_->submit(state_->copy_commands); !copied) return tl::unexpected(copied.error());
  const std::span<const std::byte> bytes = state_->readback.bytes();
  std::vector<uint32_t> pixels(bytes.size() / sizeof(uint32_t));
  std::memcpy(pixels.data(), bytes.data(), bytes.size());
  return pixels;
}

}  // namespace fillrule::vulkan
