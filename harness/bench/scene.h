// What a workload draws: vertices in clip space, drawn once to a square target with RGBA8 and D32F LESS, the colour
// being the mean of the vertices' interpolated vec4.
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <vector>

#include "cases/model/case.h"

namespace fillrule::bench {

using Attribute = std::array<float, 4>;  // alpha is 1 everywhere: what is covered can be told from the picture

struct Scene {
  uint32_t target_size = 1024;  // pixels, of width and of height
  uint32_t samples = 1;         // of a pixel
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkCullModeFlags cull_mode = VK_CULL_MODE_NONE;
  uint32_t attribute_count = 1;  // vec4 of a vertex
  bool is_flat = false;          // the first vertex' values, else smooth
  std::vector<ClipPosition> positions_clip;
  std::vector<Attribute> attributes;  // [vertex][attribute]
  std::vector<uint32_t> indices;
};

}  // namespace fillrule::bench
