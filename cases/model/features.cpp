#include "cases/model/features.h"

#include <fmt/format.h>

#include <algorithm>

namespace fillrule {
namespace {

bool has_topology(const Draw& draw, VkPrimitiveTopology a, VkPrimitiveTopology b) {
  return draw.topology == a || draw.topology == b;
}

bool is_polygon(const Draw& draw) {
  return draw.topology >= VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
}

void add_shapes(const Draw& draw, FeatureSet& set) {
  const RasterState& state = draw.state;
  const bool as_lines = is_polygon(draw) && state.polygon_mode == VK_POLYGON_MODE_LINE;
  const bool as_points = is_polygon(draw) && state.polygon_mode == VK_POLYGON_MODE_POINT;
  if (as_lines || as_points) set.add(Feature::kFillModeNonSolid);
  if (draw.topology == VK_PRIMITIVE_TOPOLOGY_POINT_LIST || as_points) {
    set.add(Feature::kPoints);
    if (std::any_of(draw.point_sizes.begin(), draw.point_sizes.end(), [](float size) { return size != 1; })) {
      set.add(Feature::kLargePoints);
    }
  }
  if (as_lines || has_topology(draw, VK_PRIMITIVE_TOPOLOGY_LINE_LIST, VK_PRIMITIVE_TOPOLOGY_LINE_STRIP)) {
    const bool bresenham = state.line_mode == VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT;
    set.add(bresenham ? Feature::kBresenhamLines : Feature::kLines);
    if (state.line_width != 1) set.add(Feature::kWideLines);
  }
}

void add_state(const RasterState& state, FeatureSet& set) {
  if (state.provoking_vertex == VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT) set.add(Feature::kProvokingVertexLast);
  if (state.depth_bias) set.add(Feature::kDepthBias);
  if (state.depth_bias && state.depth_bias->clamp != 0) set.add(Feature::kDepthBiasClamp);
  if (state.depth_bounds) set.add(Feature::kDepthBounds);
  if (state.depth_clamp) set.add(Feature::kDepthClamp);
  // Vulkan's default is to clip unless depths are clamped; anything else is an extension.
  if (state.depth_clip == state.depth_clamp) set.add(Feature::kDepthClipOff);
  if (state.negative_one_to_one) set.add(Feature::kNegativeOneToOne);
  if (state.sample_mask != 0xFFFFFFFFU) set.add(Feature::kSampleMask);
}

void add_target(const Target& target, FeatureSet& set) {
  switch (target.samples) {
    case VK_SAMPLE_COUNT_2_BIT:
      set.add(Feature::kSamples2);
      break;
    case VK_SAMPLE_COUNT_4_BIT:
      set.add(Feature::kSamples4);
      break;
    case VK_SAMPLE_COUNT_8_BIT:
      set.add(Feature::kSamples8);
      break;
    case VK_SAMPLE_COUNT_16_BIT:
      set.add(Feature::kSamples16);
      break;
    default:
      break;
  }
  if (target.depth_format == VK_FORMAT_D16_UNORM) set.add(Feature::kDepthD16);
  if (target.depth_format == VK_FORMAT_X8_D24_UNORM_PACK32) set.add(Feature::kDepthX8D24);
}

}  // namespace

FeatureSet features_of(const Case& one) {
  FeatureSet set;
  add_target(one.target, set);
  for (const Varying& varying : one.varyings) {
    if (varying.sampling == Sampling::kCentroid) set.add(Feature::kCentroid);
    if (varying.sampling == Sampling::kSample) set.add(Feature::kSampleShading);
    if (varying.source == VaryingSource::kFragCoord) set.add(Feature::kFragCoord);
    if (varying.source == VaryingSource::kPointCoord) set.add(Feature::kPointCoord);
  }
  for (const Draw& draw : one.draws) {
    add_shapes(draw, set);
    add_state(draw.state, set);
    if (draw.indices && draw.index_type == VK_INDEX_TYPE_UINT8_EXT) set.add(Feature::kIndexTypeUint8);
    if (draw.primitive_restart) set.add(Feature::kPrimitiveRestart);
    if (draw.clip_distance_count > 0) set.add(Feature::kClipDistances);
    if (draw.cull_distance_count > 0) set.add(Feature::kCullDistances);
  }
  return set;
}

std::string to_string(const FeatureSet& features) {
  std::string text;
  for (const FeatureName& one : kFeatures) {
    if (!features.has(one.feature)) continue;
    if (!text.empty()) text += ", ";
    text += fmt::format("{} ({})", one.name, one.key);
  }
  return text;
}

}  // namespace fillrule
