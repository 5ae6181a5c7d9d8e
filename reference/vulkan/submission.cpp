#include "reference/vulkan/submission.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "reference/vulkan/check.h"
#include "reference/vulkan/record.h"

namespace fillrule::vulkan {

Result<Submitter> Submitter::create(const Device& device, PipelineCache& pipelines, uint64_t bytes_in_flight) {
  Submitter submitter(device, pipelines, std::min(bytes_in_flight, device.max_buffer_bytes()));
  const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                          .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                                          .queueFamilyIndex = device.queue_family()};
  VkCommandPool pool = VK_NULL_HANDLE;
  VkResult result = vkCreateCommandPool(device.get(), &pool_info, nullptr, &pool);
  if (result != VK_SUCCESS) return failed_call("vkCreateCommandPool", result);
  submitter.command_pool_ = CommandPool(device.get(), pool);

  const VkCommandBufferAllocateInfo commands_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                  .commandPool = pool,
                                                  .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                  .commandBufferCount = 1};
  result = vkAllocateCommandBuffers(device.get(), &commands_info, &submitter.commands_);
  if (result != VK_SUCCESS) return failed_call("vkAllocateCommandBuffers", result);

  const VkFenceCreateInfo fence_info{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  VkFence fence = VK_NULL_HANDLE;
  result = vkCreateFence(device.get(), &fence_info, nullptr, &fence);
  if (result != VK_SUCCESS) return failed_call("vkCreateFence", result);
  submitter.fence_ = Fence(device.get(), fence);
  return submitter;
}

Result<CaseNeeds> Submitter::needs(const Case& drawn) const {
  if (auto checked = check_case(device_->info(), drawn); !checked) return tl::unexpected(checked.error());
  CaseNeeds needs =
      needs_of(drawn, device_->slots_per_pass(), pipelines_->uses_primitive_id(), pipelines_->draws_color());
  if (needs.device_bytes <= bytes_in_flight_) return needs;
  const uint64_t buffer_bytes = std::max(needs.upload_bytes, needs.readback_bytes);
  const uint64_t available = device_->available_bytes();
  if (buffer_bytes > device_->max_buffer_bytes() || needs.device_bytes > available) {
    return failure(
        fmt::format("target.size: drawing {} x {} pixels with {} varying components takes {} MiB", drawn.target.width,
                    drawn.target.height, needs.packing.components.size(), needs.device_bytes >> 20U),
        fmt::format("{} has {} MiB, and at most {} MiB for a buffer", device_->info().driver, available >> 20U,
                    device_->max_buffer_bytes() >> 20U));
  }
  return needs;
}

void Submitter::draw(std::vector<CaseJob> jobs, std::span<Result<Planes>> results) {
  // Jobs that cannot be prepared leave the others undisturbed.
  std::erase_if(jobs, [&](CaseJob& job) {
    const Result<void> prepared = prepare(job);
    if (prepared) return false;
    results[job.result_index] = tl::unexpected(prepared.error());
    release(job);
    return true;
  });
  if (jobs.empty()) return;

  Result<void> done = place(jobs);
  if (done) {
    for (CaseJob& job : jobs) job.draws = upload(job, pipelines_->uses_primitive_id(), upload_.bytes());
    done = submit(jobs);
  }
  for (CaseJob& job : jobs) {
    if (done) {
      results[job.result_index] = read_back(job, readback_.bytes());
    } else {
      results[job.result_index] = tl::unexpected(done.error());
    }
    release(job);
  }
}

Result<void> Submitter::prepare(CaseJob& job) {
  for (const SlotRange& slots : job.needs.passes) {
    const TargetKey key = target_key(*job.drawn, slots);
    Result<TargetSet> target = targets_.acquire(key);
    if (!target) return tl::unexpected(target.error());
    job.passes.push_back({.slots = slots, .target = std::move(*target)});
    for (size_t i = 0; i < job.drawn->draws.size(); ++i) {
      PipelineKey pipeline_of_draw = pipeline_key(*job.drawn, job.drawn->draws[i], slots);
      if (!job.variants.empty()) pipeline_of_draw.variant = job.variants[i];
      const Result<VkPipeline> pipeline = pipelines_->find_or_create(pipeline_of_draw);
      if (!pipeline) return tl::unexpected(pipeline.error());
      job.passes.back().pipelines.push_back(*pipeline);
    }
  }
  return {};
}

Result<void> Submitter::place(std::span<CaseJob> jobs) {
  uint64_t upload_bytes = 0;
  uint64_t readback_bytes = 0;
  for (CaseJob& job : jobs) {
    job.upload_offset = upload_bytes;
    upload_bytes += job.needs.upload_bytes;
    for (Pass& pass : job.passes) {
      pass.readback_offset = readback_bytes;
      readback_bytes += attachment_offset(pass.target.key(), static_cast<uint32_t>(pass.target.attachments().size()));
    }
  }
  auto fitted = fit(upload_, upload_bytes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  if (fitted)
    fitted = fit(readback_, readback_bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  if (fitted) fitted = sample_reader_.bind(jobs, readback_.get());
  return fitted;
}

Result<void> Submitter::fit(HostBuffer& buffer, uint64_t bytes, VkBufferUsageFlags usage) const {
  constexpr uint64_t kMinBytes = uint64_t{1} << 16U;
  const bool is_oversized = buffer.size() > bytes_in_flight_ && bytes <= bytes_in_flight_;
  if (buffer.size() >= bytes && buffer.size() > 0 && !is_oversized) return {};
  buffer = HostBuffer();
  const uint64_t generous = std::min(std::bit_ceil(std::max(bytes, kMinBytes)), bytes_in_flight_);
  Result<HostBuffer> created = HostBuffer::create(*device_, std::max(bytes, generous), usage);
  if (!created) return tl::unexpected(created.error());
  buffer = std::move(*created);
  return {};
}

Result<void> Submitter::submit(std::span<const CaseJob> jobs) {
  VkResult result = vkResetCommandPool(device_->get(), command_pool_.get(), 0);
  if (result != VK_SUCCESS) return failed_call("vkResetCommandPool", result);
  const VkCommandBufferBeginInfo begin_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                            .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  result = vkBeginCommandBuffer(commands_, &begin_info);
  if (result != VK_SUCCESS) return failed_call("vkBeginCommandBuffer", result);
  record(commands_, *pipelines_, sample_reader_, {.upload = upload_.get(), .readback = readback_.get()}, jobs);
  result = vkEndCommandBuffer(commands_);
  if (result != VK_SUCCESS) return failed_call("vkEndCommandBuffer", result);

  VkFence fence = fence_.get();
  result = vkResetFences(device_->get(), 1, &fence);
  if (result != VK_SUCCESS) return failed_call("vkResetFences", result);
  const VkSubmitInfo submit_info{
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands_};
  result = vkQueueSubmit(device_->queue(), 1, &submit_info, fence);
  if (result != VK_SUCCESS) return failed_call("vkQueueSubmit", result);
  result = vkWaitForFences(device_->get(), 1, &fence, VK_TRUE, UINT64_MAX);
  if (result != VK_SUCCESS) return failed_call("vkWaitForFences", result);
  return {};
}

void Submitter::release(CaseJob& job) {
  for (Pass& pass : job.passes) targets_.release(std::move(pass.target));
  job.passes.clear();
}

}  // namespace fillrule::vulkan
