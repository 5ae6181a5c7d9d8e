#include "reference/vulkan/job.h"

#include "reference/vulkan/elements.h"

namespace fillrule::vulkan {
namespace {

uint32_t bytes_of(VkIndexType type) {
  switch (type) {
    case VK_INDEX_TYPE_UINT8_EXT:
      return 1;
    case VK_INDEX_TYPE_UINT16:
      return 2;
    default:
      return 4;
  }
}

uint64_t upload_bytes(const Draw& draw, uint32_t slots, bool use_primitive_id) {
  if (primitive_count(draw) == 0) return 0;
  const bool indexed = draw.indices && use_primitive_id;
  const uint64_t floats = 1 + draw.clip_distance_count + draw.cull_distance_count;  // beside position and slots
  const uint64_t vertex_bytes = uint64_t{kVec4Bytes} * (1 + slots) + sizeof(float) * floats;
  const uint64_t index_bytes = indexed ? draw.indices->size() * bytes_of(draw.index_type) : 0;
  return aligned(max_vertices(draw, use_primitive_id) * vertex_bytes, kUploadAlignment) +
         aligned(index_bytes, kUploadAlignment);
}

// In the readback buffer. Multisampled attachments get there through a shader, as 32-bit words.
uint64_t bytes_per_sample(const TargetKey& target, uint32_t attachment) {
  if (attachment < kFirstSlotAttachment) return sizeof(float);
  if (attachment < kFirstSlotAttachment + target.slots) return kVec4Bytes;
  const bool is_d16 = target.depth_format == VK_FORMAT_D16_UNORM && target.samples == VK_SAMPLE_COUNT_1_BIT;
  return is_d16 ? sizeof(uint16_t) : sizeof(float);
}

}  // namespace

TargetKey target_key(const Case& drawn, const SlotRange& slots) {
  return {.width = drawn.target.width,
          .height = drawn.target.height,
          .depth_format = drawn.target.depth_format,
          .samples = drawn.target.samples,
          .slots = slots.outputs};
}

uint64_t attachment_offset(const TargetKey& target, uint32_t index) {
  const uint64_t samples = uint64_t{target.width} * target.height * target.samples;
  uint64_t offset = 0;
  for (uint32_t i = 0; i < index; ++i) offset += aligned(samples * bytes_per_sample(target, i), kReadbackAlignment);
  return offset;
}

CaseNeeds needs_of(const Case& drawn, uint32_t slots_per_pass, bool use_primitive_id, bool draws_color) {
  CaseNeeds needs{.packing = pack(drawn.varyings)};
  needs.passes = split_into_passes(needs.packing.counts, slots_per_pass, draws_color);
  for (const Draw& draw : drawn.draws) {
    needs.upload_bytes += upload_bytes(draw, needs.packing.counts.interpolated(), use_primitive_id);
  }
  needs.device_bytes = needs.upload_bytes;
  for (const SlotRange& pass : needs.passes) {
    const TargetKey key = target_key(drawn, pass);
    const uint32_t attachments = kFirstSlotAttachment + key.slots + (key.depth_format == VK_FORMAT_UNDEFINED ? 0 : 1);
    needs.readback_bytes += attachment_offset(key, attachments);
    needs.device_bytes += estimated_bytes(key);
  }
  needs.device_bytes += needs.readback_bytes;
  return needs;
}

}  // namespace fillrule::vulkan
