#include "reference/vulkan/record.h"

#include <array>

namespace fillrule::vulkan {
namespace {

VkImageSubresourceRange whole_image(VkImageAspectFlags aspect) {
  return {.aspectMask = aspect, .levelCount = 1, .layerCount = 1};
}

// Calls `use(attachment, aspect, pass)` for every attachment of every pass.
template <typename Use>
void for_each_attachment(std::span<const CaseJob> jobs, Use use) {
  for (const CaseJob& job : jobs) {
    for (const Pass& pass : job.passes) {
      const auto& attachments = pass.target.attachments();
      for (uint32_t i = 0; i < attachments.size(); ++i) {
        const bool is_depth = pass.target.has_depth() && i + 1 == attachments.size();
        use(attachments[i], is_depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT, pass, i);
      }
    }
  }
}

void record_image_barriers(VkCommandBuffer commands, const std::vector<VkImageMemoryBarrier2>& barriers) {
  const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                              .imageMemoryBarrierCount = static_cast<uint32_t>(barriers.size()),
                              .pImageMemoryBarriers = barriers.data()};
  vkCmdPipelineBarrier2(commands, &info);
}

// Hazard: the clear at the beginning of a pass writes after the layout transition has written. Nothing before is
// waited for: the last submission's copies from these images were over when the host saw its fence.
void record_begin_barrier(VkCommandBuffer commands, std::span<const CaseJob> jobs) {
  std::vector<VkImageMemoryBarrier2> barriers;
  for_each_attachment(jobs, [&](const Attachment& attachment, VkImageAspectFlags aspect, const Pass&, uint32_t) {
    const bool is_depth = aspect == VK_IMAGE_ASPECT_DEPTH_BIT;
    barriers.push_back(
        {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
         .srcStageMask = VK_PIPELINE_STAGE_2_NONE,
         .srcAccessMask = VK_ACCESS_2_NONE,
         .dstStageMask = is_depth ? VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT
                                  : VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
         .dstAccessMask =
             is_depth ? VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT
                      : VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
         .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED,
         .newLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL,
         .image = attachment.image.get(),
         .subresourceRange = whole_image(aspect)});
  });
  record_image_barriers(commands, barriers);
}

// Hazard: the copies, and the shader that reads samples, read after the passes' stores have written.
void record_read_barrier(VkCommandBuffer commands, std::span<const CaseJob> jobs) {
  std::vector<VkImageMemoryBarrier2> barriers;
  for_each_attachment(jobs, [&](const Attachment& attachment, VkImageAspectFlags aspect, const Pass& pass, uint32_t) {
    const bool is_depth = aspect == VK_IMAGE_ASPECT_DEPTH_BIT;
    const bool by_shader = pass.target.is_multisampled();
    barriers.push_back(
        {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
         .srcStageMask =
             is_depth ? VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT : VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
         .srcAccessMask =
             is_depth ? VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT : VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
         .dstStageMask = by_shader ? VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT : VK_PIPELINE_STAGE_2_COPY_BIT,
         .dstAccessMask = by_shader ? VK_ACCESS_2_SHADER_SAMPLED_READ_BIT : VK_ACCESS_2_TRANSFER_READ_BIT,
         .oldLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL,
         .newLayout = by_shader ? VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL : VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
         .image = attachment.image.get(),
         .subresourceRange = whole_image(aspect)});
  });
  record_image_barriers(commands, barriers);
}

// Hazard: the host reads after the copies and the shader have written, each its own part of the buffer. The fence
// alone makes nothing visible to the host.
void record_host_barrier(VkCommandBuffer commands) {
  const VkMemoryBarrier2 barrier{
      .sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
      .srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
      .srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
      .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT,
      .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT};
  const VkDependencyInfo info{
      .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &barrier};
  vkCmdPipelineBarrier2(commands, &info);
}

void begin_rendering(VkCommandBuffer commands, const Pass& pass, float clear_depth) {
  const TargetKey& key = pass.target.key();
  std::vector<VkRenderingAttachmentInfo> attachments;
  for (const Attachment& attachment : pass.target.attachments()) {
    // A cleared attachment is all zeros: no hits, no owner.
    attachments.push_back({.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                           .imageView = attachment.view.get(),
                           .imageLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL,
                           .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                           .storeOp = VK_ATTACHMENT_STORE_OP_STORE});
  }
  if (pass.target.has_depth()) attachments.back().clearValue.depthStencil.depth = clear_depth;
  const VkRenderingInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                             .renderArea = {.extent = {key.width, key.height}},
                             .layerCount = 1,
                             .colorAttachmentCount = kFirstSlotAttachment + key.slots,
                             .pColorAttachments = attachments.data(),
                             .pDepthAttachment = pass.target.has_depth() ? &attachments.back() : nullptr};
  vkCmdBeginRendering(commands, &info);
}

void set_depth_state(VkCommandBuffer commands, const RasterState& state) {
  vkCmdSetDepthTestEnable(commands, state.depth_test ? VK_TRUE : VK_FALSE);
  vkCmdSetDepthWriteEnable(commands, state.depth_write ? VK_TRUE : VK_FALSE);
  vkCmdSetDepthCompareOp(commands, state.depth_compare);
  const DepthBias bias = state.depth_bias.value_or(DepthBias{});
  vkCmdSetDepthBiasEnable(commands, state.depth_bias ? VK_TRUE : VK_FALSE);
  vkCmdSetDepthBias(commands, bias.constant_factor, bias.clamp, bias.slope_factor);
  const DepthBounds bounds = state.depth_bounds.value_or(DepthBounds{});
  vkCmdSetDepthBoundsTestEnable(commands, state.depth_bounds ? VK_TRUE : VK_FALSE);
  vkCmdSetDepthBounds(commands, bounds.min, bounds.max);
}

void set_state(VkCommandBuffer commands, const UploadedDraw& uploaded) {
  const RasterState& state = uploaded.draw->state;
  vkCmdSetViewport(commands, 0, 1, &state.viewport);
  vkCmdSetScissor(commands, 0, 1, &state.scissor);
  vkCmdSetCullMode(commands, state.cull_mode);
  vkCmdSetFrontFace(commands, state.front_face);
  vkCmdSetPrimitiveTopology(commands, uploaded.topology);
  const bool restarts = uploaded.indexed && uploaded.draw->primitive_restart;
  vkCmdSetPrimitiveRestartEnable(commands, restarts ? VK_TRUE : VK_FALSE);
  vkCmdSetLineWidth(commands, uploaded.draws_lines ? state.line_width : 1.0F);
  set_depth_state(commands, state);
}

void bind_vertices(VkCommandBuffer commands, VkBuffer upload, const UploadedDraw& uploaded, const SlotRange& slots,
                   uint32_t vertex_slots) {
  const std::array buffers = {upload, upload, upload, upload};
  // Bindings that the pipeline does not read begin with the positions, since an offset must lie in the buffer.
  std::array<VkDeviceSize, kBindings> offsets{};
  offsets.fill(uploaded.positions_offset);
  if (slots.counts.interpolated() > 0) {
    offsets[kSlotBinding] = uploaded.slots_offset + VkDeviceSize{slots.first} * kVec4Bytes;
  }
  offsets[kPointSizeBinding] = uploaded.point_sizes_offset;
  const uint32_t distances = uploaded.draw->clip_distance_count + uploaded.draw->cull_distance_count;
  if (distances > 0) offsets[kDistanceBinding] = uploaded.distances_offset;
  const std::array<VkDeviceSize, kBindings> strides = {kVec4Bytes, VkDeviceSize{vertex_slots} * kVec4Bytes,
                                                       uploaded.draws_points ? sizeof(float) : 0,
                                                       VkDeviceSize{distances} * sizeof(float)};
  vkCmdBindVertexBuffers2(commands, kPositionBinding, kBindings, buffers.data(), offsets.data(), nullptr,
                          strides.data());
}

void record_draw(VkCommandBuffer commands, VkPipelineLayout layout, VkBuffer upload, const UploadedDraw& uploaded) {
  vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                     sizeof(Numbering), &uploaded.numbering);
  if (uploaded.indexed) {
    vkCmdBindIndexBuffer(commands, upload, uploaded.indices_offset, uploaded.draw->index_type);
    vkCmdDrawIndexed(commands, uploaded.run.count, 1, uploaded.run.first, uploaded.draw->vertex_offset, 0);
  } else {
    vkCmdDraw(commands, uploaded.run.count, 1, uploaded.run.first, 0);
  }
}

void record_pass(VkCommandBuffer commands, const PipelineCache& pipelines, VkBuffer upload, const CaseJob& job,
                 const Pass& pass) {
  begin_rendering(commands, pass, job.drawn->target.clear_depth);
  VkPipeline bound = VK_NULL_HANDLE;
  for (const UploadedDraw& uploaded : job.draws) {
    VkPipeline pipeline = pass.pipelines[uploaded.index];
    if (pipeline != bound) vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
    bound = pipeline;
    if (!job.resource_sets.empty()) {
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.layout(), 0, 1,
                              &job.resource_sets[uploaded.index], 0, nullptr);
    }
    set_state(commands, uploaded);
    pipelines.dynamic_state().set(commands, pipeline_key(*job.drawn, *uploaded.draw, pass.slots));
    bind_vertices(commands, upload, uploaded, pass.slots, job.needs.packing.counts.interpolated());
    record_draw(commands, pipelines.layout(), upload, uploaded);
  }
  vkCmdEndRendering(commands);
}

void record_copies(VkCommandBuffer commands, VkBuffer readback, std::span<const CaseJob> jobs) {
  for_each_attachment(
      jobs, [&](const Attachment& attachment, VkImageAspectFlags aspect, const Pass& pass, uint32_t index) {
        if (pass.target.is_multisampled()) return;
        const TargetKey& key = pass.target.key();
        const VkBufferImageCopy region{.bufferOffset = pass.readback_offset + attachment_offset(key, index),
                                       .imageSubresource = {.aspectMask = aspect, .layerCount = 1},
                                       .imageExtent = {key.width, key.height, 1}};
        vkCmdCopyImageToBuffer(commands, attachment.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readback, 1,
                               &region);
      });
}

}  // namespace

void record(VkCommandBuffer commands, const PipelineCache& pipelines, const SampleReader& sample_reader,
            const SubmissionBuffers& buffers, std::span<const CaseJob> jobs) {
  // The upload buffer needs no barrier: submitting makes the host's writes visible.
  record_begin_barrier(commands, jobs);
  for (const CaseJob& job : jobs) {
    for (const Pass& pass : job.passes) record_pass(commands, pipelines, buffers.upload, job, pass);
  }
  record_read_barrier(commands, jobs);
  record_copies(commands, buffers.readback, jobs);
  sample_reader.record(commands);
  record_host_barrier(commands);
}

}  // namespace fillrule::vulkan
