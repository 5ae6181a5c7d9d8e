// Graphics pipelines with the program's stages, made on first need and kept.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "reference/vulkan/device.h"
#include "reference/vulkan/dynamic_state.h"
#include "reference/vulkan/pipeline_key.h"

namespace fillrule::vulkan {

// The push constants: how the number of a primitive is found.
struct Numbering {
  uint32_t first_primitive = 0;  // complete primitives of the case's draws before
  // Used without gl_PrimitiveID: primitive i has the provoking vertex
  // first_provoking_vertex + i * vertices_per_primitive.
  uint32_t vertices_per_primitive = 1;
  uint32_t first_provoking_vertex = 0;
};

class PipelineCache {
 public:
  // Compiles the program once without slots, so that its faults show at once. `device` and the layout of what the
  // program reads beside its vertices, if that is not null, must outlive the cache.
  static Result<PipelineCache> create(const Device& device, Program program, bool use_primitive_id,
                                      VkDescriptorSetLayout resource_layout);

  [[nodiscard]] VkPipelineLayout layout() const { return layout_.get(); }
  [[nodiscard]] bool uses_primitive_id() const { return use_primitive_id_; }
  [[nodiscard]] bool draws_color() const { return program_.draws_color; }
  // What a draw sets by itself, besides the state that is dynamic on every device.
  [[nodiscard]] const DynamicState& dynamic_state() const { return dynamic_state_; }
  Result<VkPipeline> find_or_create(const PipelineKey& wanted);

 private:
  PipelineCache() = default;
  Result<VkShaderModule> find_or_compile(VkShaderStageFlagBits stage, const PipelineKey& key);

  const Device* device_ = nullptr;
  Program program_;
  bool use_primitive_id_ = true;
  DynamicState dynamic_state_;
  PipelineLayout layout_;
  std::map<std::pair<VkShaderStageFlagBits, std::string>, ShaderModule> modules_;  // by stage and macros
  std::map<PipelineKey, Pipeline> pipelines_;
};

}  // namespace fillrule::vulkan
