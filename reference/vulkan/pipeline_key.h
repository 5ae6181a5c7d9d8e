// What a pipeline is bound to. Every other state of a draw is dynamic, since a pipeline costs a CPU driver tens of
// milliseconds and a case with a kept pipeline a fraction of one. State that cannot matter to a draw is left at its
// default, so that draws share pipelines.
#pragma once

#include <compare>
#include <cstdint>

#include "cases/model/case.h"
#include "reference/vulkan/packing.h"

namespace fillrule::vulkan {

struct PipelineKey {
  SlotCounts slots;      // of the pass
  uint32_t outputs = 0;  // as in SlotRange
  // Any topology of the class that is drawn: triangle list stands for strip and fan too.
  VkPrimitiveTopology topology_class = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPolygonMode polygon_mode = VK_POLYGON_MODE_FILL;
  // VK_LINE_RASTERIZATION_MODE_DEFAULT_EXT where no lines are drawn.
  VkLineRasterizationModeEXT line_mode = VK_LINE_RASTERIZATION_MODE_DEFAULT_EXT;
  VkProvokingVertexModeEXT provoking_vertex = VK_PROVOKING_VERTEX_MODE_FIRST_VERTEX_EXT;
  bool depth_clamp = false;
  bool depth_clip = true;
  bool negative_one_to_one = false;
  uint32_t clip_distances = 0;
  uint32_t cull_distances = 0;
  VkFormat depth_format = VK_FORMAT_D32_SFLOAT;
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
  uint32_t sample_mask = 1;     // the bits of the samples that there are
  bool sample_shading = false;  // the fragment stage runs for each sample
  uint32_t variant = 0;         // of the program (DrawResources)
  // NOLINTNEXTLINE(modernize-use-nullptr,readability-implicit-bool-conversion): false alarms at the comparisons
  auto operator<=>(const PipelineKey&) const = default;

  [[nodiscard]] bool draws_points() const;
  [[nodiscard]] bool draws_lines() const;
};

// Whether the fragment stage runs for each sample (Sampling::kSample).
bool has_sample_shading(const Case& drawn);

// Of a draw of the case, in a pass over `slots`.
PipelineKey pipeline_key(const Case& drawn, const Draw& draw, const SlotRange& slots);

}  // namespace fillrule::vulkan
