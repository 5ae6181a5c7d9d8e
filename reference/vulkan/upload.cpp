#include <cstring>

#include "reference/vulkan/elements.h"
#include "reference/vulkan/job.h"

namespace fillrule::vulkan {
namespace {

// Without gl_PrimitiveID: where primitive i of a run has its provoking vertex.
Numbering numbering_of(VkPrimitiveTopology topology, VkProvokingVertexModeEXT provoking) {
  const bool last = provoking == VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
  switch (topology) {
    case VK_PRIMITIVE_TOPOLOGY_LINE_LIST:
      return {.vertices_per_primitive = 2};
    case VK_PRIMITIVE_TOPOLOGY_LINE_STRIP:
      return {.first_provoking_vertex = last ? 1U : 0U};
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST:
      return {.vertices_per_primitive = 3};
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP:
      return {.first_provoking_vertex = last ? 2U : 0U};
    case VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN:
      return {.first_provoking_vertex = last ? 2U : 1U};
    default:
      return {};
  }
}

// Copies one after another into a buffer.
class Writer {
 public:
  Writer(std::span<std::byte> buffer, uint64_t offset) : buffer_(buffer), offset_(offset) {}

  [[nodiscard]] uint64_t offset() const { return offset_; }
  template <typename T>
  void write(std::span<const T> values) {
    if (values.empty()) return;  // memcpy() takes no null pointer
    std::memcpy(buffer_.subspan(offset_, values.size_bytes()).data(), values.data(), values.size_bytes());
    offset_ += values.size_bytes();
  }
  template <typename T>
  void write_one(T value) {
    write(std::span<const T>(&value, 1));
  }
  void align() { offset_ = aligned(offset_, kUploadAlignment); }

 private:
  std::span<std::byte> buffer_;
  uint64_t offset_;
};

// One vertex's components at their places in its slots; the lanes that no component fills are 0.
void scatter(std::span<const float> components, const Packing& packing, std::span<float> slots) {
  for (size_t i = 0; i < components.size(); ++i) {
    const ComponentPlace place = packing.vertex_components[i];
    slots[place.slot * kSlotComponents + place.lane] = components[i];
  }
}

// One for all vertices where no points are drawn and nobody reads it.
void write_point_sizes(const Draw& draw, bool draws_points, const std::vector<uint32_t>& vertices, Writer& writer) {
  if (!draws_points) return writer.write_one(1.0F);
  for (const uint32_t vertex : vertices) writer.write_one(draw.point_sizes.empty() ? 1.0F : draw.point_sizes[vertex]);
}

// In the order of the shader's inputs.
void write_distances(const Draw& draw, uint32_t vertex, Writer& writer) {
  const auto distances = [&](const std::vector<float>& values, uint32_t count) {
    writer.write(std::span<const float>(values).subspan(size_t{vertex} * count, count));
  };
  distances(draw.clip_distances, draw.clip_distance_count);
  distances(draw.cull_distances, draw.cull_distance_count);
}

void write_indices(const Draw& draw, Writer& writer) {
  for (const uint32_t index : *draw.indices) {
    switch (draw.index_type) {
      case VK_INDEX_TYPE_UINT8_EXT:
        writer.write_one(static_cast<uint8_t>(index));
        break;
      case VK_INDEX_TYPE_UINT16:
        writer.write_one(static_cast<uint16_t>(index));
        break;
      default:
        writer.write_one(index);
    }
  }
}

UploadedDraw upload_draw(const Draw& draw, const Packing& packing, const Elements& elements, Writer& writer) {
  const PipelineKey key = pipeline_key({}, draw, {});
  UploadedDraw uploaded{.draw = &draw,
                        .topology = elements.topology,
                        .indexed = elements.indexed,
                        .draws_points = key.draws_points(),
                        .draws_lines = key.draws_lines()};
  uploaded.positions_offset = writer.offset();
  for (const uint32_t vertex : elements.vertices) writer.write(std::span<const float>(draw.positions[vertex]));
  uploaded.slots_offset = writer.offset();
  const size_t components = packing.vertex_components.size();
  std::vector<float> slots(size_t{packing.counts.interpolated()} * kSlotComponents, 0.0F);
  for (const uint32_t vertex : elements.vertices) {
    scatter(std::span(draw.varyings).subspan(vertex * components, components), packing, slots);
    writer.write(std::span<const float>(slots));
  }
  uploaded.point_sizes_offset = writer.offset();
  write_point_sizes(draw, uploaded.draws_points, elements.vertices, writer);
  uploaded.distances_offset = writer.offset();
  for (const uint32_t vertex : elements.vertices) write_distances(draw, vertex, writer);
  writer.align();
  uploaded.indices_offset = writer.offset();
  if (elements.indexed) write_indices(draw, writer);
  writer.align();
  return uploaded;
}

}  // namespace

std::vector<UploadedDraw> upload(const CaseJob& job, bool use_primitive_id, std::span<std::byte> buffer) {
  Writer writer(buffer, job.upload_offset);
  uint32_t first_primitive = 0;
  std::vector<UploadedDraw> draws;
  for (uint32_t i = 0; i < job.drawn->draws.size(); ++i) {
    const Draw& draw = job.drawn->draws[i];
    if (primitive_count(draw) == 0) continue;
    const Elements elements = elements_of(draw, use_primitive_id);
    UploadedDraw uploaded = upload_draw(draw, job.needs.packing, elements, writer);
    uploaded.index = i;
    for (const ElementRun& run : elements.runs) {
      uploaded.run = run;
      uploaded.numbering = numbering_of(elements.topology, draw.state.provoking_vertex);
      uploaded.numbering.first_provoking_vertex += run.first;
      uploaded.numbering.first_primitive = first_primitive;
      draws.push_back(uploaded);
      first_primitive += elements.indexed ? primitive_count(draw) : primitives_in_run(elements.topology, run.count);
    }
  }
  return draws;
}

}  // namespace fillrule::vulkan
