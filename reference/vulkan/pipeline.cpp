#include "reference/vulkan/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "reference/vulkan/graphics_pipeline.h"
#include "reference/vulkan/shader.h"

namespace fillrule::vulkan {
namespace {

// "INTERPOLATED(S) S(0, smooth) ...": what is named calls its argument for each of the slots.
struct SlotMacro {
  std::string_view name;
  SlotKind first_kind;
  SlotKind last_kind;
};
constexpr std::array kSlotMacros = {
    SlotMacro{"INTERPOLATED", SlotKind::kSmooth, SlotKind::kFlat},
    SlotMacro{"FRAG_COORDS", SlotKind::kFragCoord, SlotKind::kFragCoord},
    SlotMacro{"POINT_COORDS", SlotKind::kPointCoord, SlotKind::kPointCoord},
};

// Behind the slot's number; nothing for built-ins.
constexpr std::array<std::string_view, kSlotKindCount> kQualifiers = {
    ", smooth",
    ", centroid smooth",
    ", sample smooth",
    ", noperspective",
    ", centroid noperspective",
    ", sample noperspective",
    ", flat",
    "",
    "",
};

std::string define_slots(const SlotCounts& slots) {
  std::string defines;
  uint32_t slot = 0;
  for (const SlotMacro& macro : kSlotMacros) {
    defines += fmt::format("#define {}(S)", macro.name);
    for (auto kind = static_cast<size_t>(macro.first_kind); kind <= static_cast<size_t>(macro.last_kind); ++kind) {
      for (uint32_t i = 0; i < slots.of[kind]; ++i) defines += fmt::format(" S({}{})", slot++, kQualifiers[kind]);
    }
    defines += '\n';
  }
  return defines + fmt::format("#define NUM_INTERPOLATED {}\n", slots.interpolated());
}

SlotCounts without_built_ins(SlotCounts slots) {
  std::fill(slots.of.begin() + kFirstBuiltIn, slots.of.end(), 0U);
  return slots;
}

std::string define_distances(const PipelineKey& key) {
  return fmt::format("#define NUM_CLIP_DISTANCES {}\n#define NUM_CULL_DISTANCES {}\n", key.clip_distances,
                     key.cull_distances);
}

}  // namespace

Result<PipelineCache> PipelineCache::create(const Device& device, Program program, bool use_primitive_id,
                                            VkDescriptorSetLayout resource_layout) {
  PipelineCache cache;
  cache.device_ = &device;
  cache.program_ = std::move(program);
  cache.use_primitive_id_ = use_primitive_id;
  cache.dynamic_state_ = DynamicState(device);
  const VkPushConstantRange range{.stageFlags = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT,
                                  .size = sizeof(Numbering)};
  const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                        .setLayoutCount = resource_layout == VK_NULL_HANDLE ? 0U : 1U,
                                        .pSetLayouts = &resource_layout,
                                        .pushConstantRangeCount = 1,
                                        .pPushConstantRanges = &range};
  VkPipelineLayout layout = VK_NULL_HANDLE;
  const VkResult result = vkCreatePipelineLayout(device.get(), &info, nullptr, &layout);
  if (result != VK_SUCCESS) return failed_call("vkCreatePipelineLayout", result);
  cache.layout_ = PipelineLayout(device.get(), layout);

  for (const VkShaderStageFlagBits stage : {VK_SHADER_STAGE_VERTEX_BIT, VK_SHADER_STAGE_FRAGMENT_BIT}) {
    if (const auto module = cache.find_or_compile(stage, {}); !module) return tl::unexpected(module.error());
  }
  return cache;
}

Result<VkShaderModule> PipelineCache::find_or_compile(VkShaderStageFlagBits stage, const PipelineKey& key) {
  const bool is_vertex = stage == VK_SHADER_STAGE_VERTEX_BIT;
  const std::string defines =
      (is_vertex ? define_slots(without_built_ins(key.slots)) + define_distances(key) : define_slots(key.slots)) +
      fmt::format("#define PRIMITIVE_ID {}\n#define VARIANT {}\n", use_primitive_id_ ? 1 : 0, key.variant);
  if (const auto found = modules_.find({stage, defines}); found != modules_.end()) return found->second.get();
  Result<ShaderModule> module =
      create_shader(device_->get(), stage, is_vertex ? program_.vertex_glsl : program_.fragment_glsl, defines);
  if (!module) return tl::unexpected(module.error());
  return modules_.emplace(std::pair(stage, defines), std::move(*module)).first->second.get();
}

Result<VkPipeline> PipelineCache::find_or_create(const PipelineKey& wanted) {
  const PipelineKey key = dynamic_state_.without(wanted);
  if (const auto found = pipelines_.find(key); found != pipelines_.end()) return found->second.get();
  const Result<VkShaderModule> vertex = find_or_compile(VK_SHADER_STAGE_VERTEX_BIT, key);
  if (!vertex) return tl::unexpected(vertex.error());
  const Result<VkShaderModule> fragment = find_or_compile(VK_SHADER_STAGE_FRAGMENT_BIT, key);
  if (!fragment) return tl::unexpected(fragment.error());
  Result<Pipeline> pipeline =
      create_graphics_pipeline(device_->get(), layout_.get(), key, dynamic_state_.states(), *vertex, *fragment);
  if (!pipeline) return tl::unexpected(pipeline.error());
  return pipelines_.emplace(key, std::move(*pipeline)).first->second.get();
}

}  // namespace fillrule::vulkan
