// A case on its way through a submission: what it needs, where its vertices lie in the upload buffer, which
// attachments it is drawn to, and where they land in the readback buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "reference/vulkan/graphics_pipeline.h"
#include "reference/vulkan/packing.h"
#include "reference/vulkan/pipeline.h"
#include "reference/vulkan/targets.h"

namespace fillrule::vulkan {

// A draw in the upload buffer, or a run of one between restarts; offsets in bytes.
struct UploadedDraw {
  const Draw* draw = nullptr;
  uint32_t index = 0;  // of the draw in its case
  uint64_t positions_offset = 0;
  uint64_t slots_offset = 0;
  uint64_t point_sizes_offset = 0;  // of one for all vertices where no points are drawn
  uint64_t distances_offset = 0;
  uint64_t indices_offset = 0;
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  bool indexed = false;
  ElementRun run;  // of the vertices, or of the indices
  bool draws_points = false;
  bool draws_lines = false;
  Numbering numbering;
};

// One pass: every draw of the case, with the slots that fit.
struct Pass {
  SlotRange slots;
  TargetSet target;
  std::vector<VkPipeline> pipelines;  // one for each draw of the case
  uint64_t readback_offset = 0;       // bytes
};

// What a case needs, before anything is allocated.
struct CaseNeeds {
  Packing packing;
  std::vector<SlotRange> passes;
  uint64_t upload_bytes = 0;
  uint64_t readback_bytes = 0;
  uint64_t device_bytes = 0;  // all of it, attachments included
};

struct CaseJob {
  const Case* drawn = nullptr;
  size_t result_index = 0;
  CaseNeeds needs;
  uint64_t upload_offset = 0;  // bytes
  std::vector<UploadedDraw> draws;
  std::vector<Pass> passes;
  // Of the program's resources, one for each draw of the case; empty if it has none.
  std::vector<VkDescriptorSet> resource_sets;
  std::vector<uint32_t> variants;
};

// Vertex and index data begin at multiples of a vec4. What is read back begins at multiples of the largest alignment
// that Vulkan lets a device ask of storage buffers.
inline constexpr uint64_t kUploadAlignment = kVec4Bytes;
inline constexpr uint64_t kReadbackAlignment = 256;
constexpr uint64_t aligned(uint64_t bytes, uint64_t alignment) {
  return (bytes + alignment - 1) / alignment * alignment;
}

// `use_primitive_id` as PipelineCache has it, `draws_color` as in Program.
CaseNeeds needs_of(const Case& drawn, uint32_t slots_per_pass, bool use_primitive_id, bool draws_color);
TargetKey target_key(const Case& drawn, const SlotRange& slots);

// Writes the vertices and indices of the job's draws; those without a complete primitive are left out.
std::vector<UploadedDraw> upload(const CaseJob& job, bool use_primitive_id, std::span<std::byte> buffer);

// Where attachment `index` of `target` begins in the pass's part of the readback buffer, in bytes; for the index
// behind the last one, the size of that part.
uint64_t attachment_offset(const TargetKey& target, uint32_t index);

// The planes out of the readback buffer.
Planes read_back(const CaseJob& job, std::span<const std::byte> buffer);

}  // namespace fillrule::vulkan
