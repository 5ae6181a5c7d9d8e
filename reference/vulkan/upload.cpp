#include <cstring>

#include "reference/vulkan/job.h"

namespace fillrule::vulkan {
namespace {

Numbering numbering_of(VkPrimitiveTopology topology, uint32_t first_primitive) {
  switch (topology) {
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP:
      return {.first_primitive = first_primitive, .vertices_per_primitive = 1, .first_provoking_vertex = 0};
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN:
      return {.first_primitive = first_primitive, .vertices_per_primitive = 1, .first_provoking_vertex = 1};
    default:
      return {.first_primitive = first_primitive, .vertices_per_primitive = 3, .first_provoking_vertex = 0};
  }
}

// Copies one after another into a buffer.
class Writer {
 public:
  Writer(std::span<std::byte> buffer, uint64_t offset) : buffer_(buffer), offset_(offset) {}

  [[nodiscard]] uint64_t offset() const { return offset_; }
  template <typename T>
  void write(std::span<const T> values) {
    std::memcpy(buffer_.subspan(offset_, values.size_bytes()).data(), values.data(), values.size_bytes());
    offset_ += values.size_bytes();
  }
  void align() { offset_ = (offset_ + kVec4Bytes - 1) / kVec4Bytes * kVec4Bytes; }

 private:
  std::span<std::byte> buffer_;
  uint64_t offset_;
};

// One vertex's components at their places in its slots; the lanes that no component fills are 0.
void scatter(std::span<const float> components, const Packing& packing, std::span<float> slots) {
  for (size_t i = 0; i < components.size(); ++i) {
    const ComponentPlace place = packing.components[i];
    slots[place.slot * kSlotComponents + place.lane] = components[i];
  }
}

UploadedDraw upload_draw(const Draw& draw, const Packing& packing, bool expand_indices, Writer& writer) {
  const bool expand = draw.indices && expand_indices;
  UploadedDraw uploaded{.state = &draw.state,
                        .topology = draw.topology,
                        .positions_offset = writer.offset(),
                        .elements = element_count(draw),
                        .indexed = draw.indices && !expand};
  const size_t vertices = expand ? draw.indices->size() : draw.positions.size();
  const auto source = [&](size_t vertex) { return expand ? (*draw.indices)[vertex] : vertex; };

  for (size_t i = 0; i < vertices; ++i) writer.write(std::span<const float>(draw.positions[source(i)]));
  uploaded.slots_offset = writer.offset();
  const size_t components = packing.components.size();
  std::vector<float> slots(size_t{packing.counts.total()} * kSlotComponents, 0.0F);
  for (size_t i = 0; i < vertices && components > 0; ++i) {
    scatter(std::span(draw.varyings).subspan(source(i) * components, components), packing, slots);
    writer.write(std::span<const float>(slots));
  }
  uploaded.indices_offset = writer.offset();
  if (uploaded.indexed) writer.write(std::span<const uint32_t>(*draw.indices));
  writer.align();
  return uploaded;
}

}  // namespace

std::vector<UploadedDraw> upload(const CaseJob& job, bool expand_indices, std::span<std::byte> buffer) {
  Writer writer(buffer, job.upload_offset);
  uint32_t first_primitive = 0;
  std::vector<UploadedDraw> uploaded;
  for (const Draw& draw : job.drawn->draws) {
    const uint32_t primitives = primitive_count(draw);
    if (primitives == 0) continue;
    uploaded.push_back(upload_draw(draw, job.needs.packing, expand_indices, writer));
    uploaded.back().numbering = numbering_of(draw.topology, first_primitive);
    first_primitive += primitives;
  }
  return uploaded;
}

}  // namespace fillrule::vulkan
