// A case on its way through a submission: what it needs, where its vertices lie in the upload buffer, which
// attachments it is drawn to, and where they land in the readback buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/planes.h"
#include "reference/vulkan/packing.h"
#include "reference/vulkan/pipeline.h"
#include "reference/vulkan/targets.h"

namespace fillrule::vulkan {

// A draw in the upload buffer; offsets in bytes.
struct UploadedDraw {
  const RasterState* state = nullptr;
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  uint64_t positions_offset = 0;
  uint64_t slots_offset = 0;
  uint64_t indices_offset = 0;
  uint32_t elements = 0;  // vertices, or indices where indexed
  bool indexed = false;
  Numbering numbering;
};

// One pass: every draw of the case, with the slots that fit.
struct Pass {
  SlotRange slots;
  TargetSet target;
  VkPipeline pipeline = VK_NULL_HANDLE;
  uint64_t readback_offset = 0;  // bytes
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
};

// `expand_indices`: indexed draws are uploaded vertex by vertex in the order of their indices.
CaseNeeds needs_of(const Case& drawn, uint32_t slots_per_pass, bool expand_indices);
TargetKey target_key(const Case& drawn, const SlotRange& slots);

// Writes the vertices and indices of the job's draws; those without a complete primitive are left out.
std::vector<UploadedDraw> upload(const CaseJob& job, bool expand_indices, std::span<std::byte> buffer);

// Where attachment `index` of `target` begins in the pass's part of the readback buffer, in bytes; for the index
// behind the last one, the size of that part.
uint64_t attachment_offset(const TargetKey& target, uint32_t index);

// The planes out of the readback buffer.
Planes read_back(const CaseJob& job, std::span<const std::byte> buffer);

}  // namespace fillrule::vulkan
