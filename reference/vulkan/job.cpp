#include "reference/vulkan/job.h"

namespace fillrule::vulkan {
namespace {

// Vertex and index data, and image data in buffers, begin at multiples of a vec4.
constexpr uint64_t kAlignment = kVec4Bytes;

uint64_t aligned(uint64_t bytes) {
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

bool is_indexed(const Draw& draw, bool expand_indices) {
  return draw.indices && !expand_indices;
}

uint64_t uploaded_vertices(const Draw& draw, bool expand_indices) {
  return is_indexed(draw, expand_indices) ? draw.positions.size() : element_count(draw);
}

uint64_t upload_bytes(const Draw& draw, uint32_t slots, bool expand_indices) {
  if (primitive_count(draw) == 0) return 0;
  const uint64_t vertices = uploaded_vertices(draw, expand_indices) * kVec4Bytes * (1 + slots);
  return vertices + (is_indexed(draw, expand_indices) ? aligned(draw.indices->size() * sizeof(uint32_t)) : 0);
}

}  // namespace

TargetKey target_key(const Case& drawn, const SlotRange& slots) {
  return {.width = drawn.target.width,
          .height = drawn.target.height,
          .depth_format = drawn.target.depth_format,
          .samples = drawn.target.samples,
          .slots = slots.counts.total()};
}

uint64_t attachment_offset(const TargetKey& target, uint32_t index) {
  const uint64_t pixels = uint64_t{target.width} * target.height;
  uint64_t offset = 0;
  for (uint32_t i = 0; i < index; ++i) {
    const bool is_slot = i >= kFirstSlotAttachment && i < kFirstSlotAttachment + target.slots;
    offset += aligned(pixels * (is_slot ? kVec4Bytes : sizeof(float)));
  }
  return offset;
}

CaseNeeds needs_of(const Case& drawn, uint32_t slots_per_pass, bool expand_indices) {
  CaseNeeds needs{.packing = pack(drawn.varyings)};
  needs.passes = split_into_passes(needs.packing.counts, slots_per_pass);
  for (const Draw& draw : drawn.draws) {
    needs.upload_bytes += upload_bytes(draw, needs.packing.counts.total(), expand_indices);
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
