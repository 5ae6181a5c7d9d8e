// Graphics pipelines, made on first need and kept. All that can be dynamic is, since a pipeline costs a CPU driver
// tens of milliseconds and a case with a kept pipeline a fraction of one. Vulkan specification, "Graphics Pipelines",
// "Dynamic State".
#pragma once

#include <cstdint>
#include <map>

#include "reference/vulkan/device.h"
#include "reference/vulkan/packing.h"

namespace fillrule::vulkan {

// What a pipeline is bound to; every other state is set for each draw.
struct PipelineKey {
  SlotCounts slots;  // of the pass
  // Any topology of the class that is drawn: triangle list stands for strip and fan too.
  VkPrimitiveTopology topology_class = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkFormat depth_format = VK_FORMAT_D32_SFLOAT;
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm at the comparison with zero
  auto operator<=>(const PipelineKey&) const = default;
};

// The push constants: how the number of a primitive is found.
struct Numbering {
  uint32_t first_primitive = 0;  // complete primitives of the case's draws before
  // Used without gl_PrimitiveID: primitive i has the provoking vertex
  // first_provoking_vertex + i * vertices_per_primitive.
  uint32_t vertices_per_primitive = 1;
  uint32_t first_provoking_vertex = 0;
};

// Vertex buffer bindings: positions, and the slots, whose stride is dynamic.
inline constexpr uint32_t kPositionBinding = 0;
inline constexpr uint32_t kSlotBinding = 1;
inline constexpr uint32_t kVec4Bytes = 16;

class PipelineCache {
 public:
  // Compiles the program once without slots, so that its faults show at once. `device` must outlive the cache.
  static Result<PipelineCache> create(const Device& device, Program program, bool use_primitive_id);

  [[nodiscard]] VkPipelineLayout layout() const { return layout_.get(); }
  [[nodiscard]] bool uses_primitive_id() const { return use_primitive_id_; }
  Result<VkPipeline> find_or_create(const PipelineKey& key);

 private:
  PipelineCache() = default;
  [[nodiscard]] Result<ShaderModule> compile(VkShaderStageFlagBits stage, const SlotCounts& slots) const;

  const Device* device_ = nullptr;
  Program program_;
  bool use_primitive_id_ = true;
  PipelineLayout layout_;
  std::map<PipelineKey, Pipeline> pipelines_;
};

}  // namespace fillrule::vulkan
