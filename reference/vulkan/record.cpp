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

// Hazard: the copies read after the passes' stores have written.
void record_copy_barrier(VkCommandBuffer commands, std::span<const CaseJob> jobs) {
  std::vector<VkImageMemoryBarrier2> barriers;
  for_each_attachment(jobs, [&](const Attachment& attachment, VkImageAspectFlags aspect, const Pass&, uint32_t) {
    const bool is_depth = aspect == VK_IMAGE_ASPECT_DEPTH_BIT;
    barriers.push_back({.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                        .srcStageMask = is_depth ? VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT
                                                 : VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                        .srcAccessMask = is_depth ? VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT
                                                  : VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                        .dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT,
                        .dstAccessMask = VK_ACCESS_2_TRANSFER_READ_BIT,
                        .oldLayout = VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL,
                        .newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                        .image = attachment.image.get(),
                        .subresourceRange = whole_image(aspect)});
  });
  record_image_barriers(commands, barriers);
}

// Hazard: the host reads after the copies have written. The fence alone makes nothing visible to the host.
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

void set_state(VkCommandBuffer commands, const UploadedDraw& draw) {
  const RasterState& state = *draw.state;
  vkCmdSetViewport(commands, 0, 1, &state.viewport);
  vkCmdSetScissor(commands, 0, 1, &state.scissor);
  vkCmdSetCullMode(commands, state.cull_mode);
  vkCmdSetFrontFace(commands, state.front_face);
  vkCmdSetPrimitiveTopology(commands, draw.topology);
  vkCmdSetDepthTestEnable(commands, state.depth_test ? VK_TRUE : VK_FALSE);
  vkCmdSetDepthWriteEnable(commands, state.depth_write ? VK_TRUE : VK_FALSE);
  vkCmdSetDepthCompareOp(commands, state.depth_compare);
}

void record_draw(VkCommandBuffer commands, VkPipelineLayout layout, VkBuffer upload, const UploadedDraw& draw,
                 const SlotRange& slots, uint32_t case_slots) {
  set_state(commands, draw);
  const std::array buffers = {upload, upload};
  const std::array<VkDeviceSize, 2> offsets = {draw.positions_offset,
                                               draw.slots_offset + VkDeviceSize{slots.first} * kVec4Bytes};
  const std::array<VkDeviceSize, 2> strides = {kVec4Bytes, VkDeviceSize{case_slots} * kVec4Bytes};
  const uint32_t bindings = slots.counts.total() > 0 ? 2 : 1;
  vkCmdBindVertexBuffers2(commands, kPositionBinding, bindings, buffers.data(), offsets.data(), nullptr,
                          strides.data());
  vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                     sizeof(Numbering), &draw.numbering);
  if (draw.indexed) {
    vkCmdBindIndexBuffer(commands, upload, draw.indices_offset, VK_INDEX_TYPE_UINT32);
    vkCmdDrawIndexed(commands, draw.elements, 1, 0, 0, 0);
  } else {
    vkCmdDraw(commands, draw.elements, 1, 0, 0);
  }
}

void record_pass(VkCommandBuffer commands, VkPipelineLayout layout, VkBuffer upload, const CaseJob& job,
                 const Pass& pass) {
  begin_rendering(commands, pass, job.drawn->target.clear_depth);
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pass.pipeline);
  for (const UploadedDraw& draw : job.draws) {
    record_draw(commands, layout, upload, draw, pass.slots, job.needs.packing.counts.total());
  }
  vkCmdEndRendering(commands);
}

void record_copies(VkCommandBuffer commands, VkBuffer readback, std::span<const CaseJob> jobs) {
  for_each_attachment(
      jobs, [&](const Attachment& attachment, VkImageAspectFlags aspect, const Pass& pass, uint32_t index) {
        const TargetKey& key = pass.target.key();
        const VkBufferImageCopy region{.bufferOffset = pass.readback_offset + attachment_offset(key, index),
                                       .imageSubresource = {.aspectMask = aspect, .layerCount = 1},
                                       .imageExtent = {key.width, key.height, 1}};
        vkCmdCopyImageToBuffer(commands, attachment.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readback, 1,
                               &region);
      });
}

}  // namespace

void record(VkCommandBuffer commands, const PipelineCache& pipelines, const SubmissionBuffers& buffers,
            std::span<const CaseJob> jobs) {
  // The upload buffer needs no barrier: submitting makes the host's writes visible.
  record_begin_barrier(commands, jobs);
  for (const CaseJob& job : jobs) {
    for (const Pass& pass : job.passes) record_pass(commands, pipelines.layout(), buffers.upload, job, pass);
  }
  record_copy_barrier(commands, jobs);
  record_copies(commands, buffers.readback, jobs);
  record_host_barrier(commands);
}

}  // namespace fillrule::vulkan
