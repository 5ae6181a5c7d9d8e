// The enumerators of the format: Vulkan's names in lower case without their prefix. The reader, the writer and the
// hints of errors use the same tables.
#pragma once

#include <vulkan/vulkan_core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cases/model/case.h"
#include "cases/model/scene.h"

namespace fillrule::format {

// The space in which a draw gives its positions; clip is what the model holds.
enum class PositionSpace : uint8_t { kClip, kNdc, kFramebuffer };

template <typename T>
struct EnumName {
  std::string_view text;
  T value;
};

inline constexpr std::array<EnumName<VkCullModeFlags>, 4> kCullModes{{
    {"none", VK_CULL_MODE_NONE},
    {"front", VK_CULL_MODE_FRONT_BIT},
    {"back", VK_CULL_MODE_BACK_BIT},
    {"front_and_back", VK_CULL_MODE_FRONT_AND_BACK},
}};

inline constexpr std::array<EnumName<VkFrontFace>, 2> kFrontFaces{{
    {"counter_clockwise", VK_FRONT_FACE_COUNTER_CLOCKWISE},
    {"clockwise", VK_FRONT_FACE_CLOCKWISE},
}};

inline constexpr std::array<EnumName<VkCompareOp>, 8> kCompareOps{{
    {"never", VK_COMPARE_OP_NEVER},
    {"less", VK_COMPARE_OP_LESS},
    {"equal", VK_COMPARE_OP_EQUAL},
    {"less_or_equal", VK_COMPARE_OP_LESS_OR_EQUAL},
    {"greater", VK_COMPARE_OP_GREATER},
    {"not_equal", VK_COMPARE_OP_NOT_EQUAL},
    {"greater_or_equal", VK_COMPARE_OP_GREATER_OR_EQUAL},
    {"always", VK_COMPARE_OP_ALWAYS},
}};

inline constexpr std::array<EnumName<VkPrimitiveTopology>, 6> kTopologies{{
    {"point_list", VK_PRIMITIVE_TOPOLOGY_POINT_LIST},
    {"line_list", VK_PRIMITIVE_TOPOLOGY_LINE_LIST},
    {"line_strip", VK_PRIMITIVE_TOPOLOGY_LINE_STRIP},
    {"triangle_list", VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST},
    {"triangle_strip", VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP},
    {"triangle_fan", VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN},
}};

// What Vulkan knows and the format does not, so that the error can tell this from a misspelling.
inline constexpr std::array<std::string_view, 5> kUnsupportedTopologies{
    "line_list_with_adjacency",
    "line_strip_with_adjacency",
    "triangle_list_with_adjacency",
    "triangle_strip_with_adjacency",
    "patch_list",
};

inline constexpr std::array<EnumName<VkIndexType>, 3> kIndexTypes{{
    {"uint8", VK_INDEX_TYPE_UINT8_EXT},
    {"uint16", VK_INDEX_TYPE_UINT16},
    {"uint32", VK_INDEX_TYPE_UINT32},
}};

inline constexpr std::array<EnumName<VkPolygonMode>, 3> kPolygonModes{{
    {"fill", VK_POLYGON_MODE_FILL},
    {"line", VK_POLYGON_MODE_LINE},
    {"point", VK_POLYGON_MODE_POINT},
}};

inline constexpr std::array<EnumName<VkLineRasterizationModeEXT>, 2> kLineModes{{
    {"rectangular", VK_LINE_RASTERIZATION_MODE_RECTANGULAR_EXT},
    {"bresenham", VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT},
}};

inline constexpr std::array<EnumName<VkProvokingVertexModeEXT>, 2> kProvokingVertices{{
    {"first", VK_PROVOKING_VERTEX_MODE_FIRST_VERTEX_EXT},
    {"last", VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT},
}};

inline constexpr std::array<EnumName<VkFormat>, 4> kDepthFormats{{
    {"none", VK_FORMAT_UNDEFINED},
    {"d16_unorm", VK_FORMAT_D16_UNORM},
    {"x8_d24_unorm_pack32", VK_FORMAT_X8_D24_UNORM_PACK32},
    {"d32_sfloat", VK_FORMAT_D32_SFLOAT},
}};

inline constexpr std::array<std::string_view, 4> kUnsupportedDepthFormats{
    "d16_unorm_s8_uint",
    "d24_unorm_s8_uint",
    "d32_sfloat_s8_uint",
    "s8_uint",
};

inline constexpr std::array<EnumName<Interpolation>, 3> kInterpolations{{
    {"smooth", Interpolation::kSmooth},
    {"noperspective", Interpolation::kNoperspective},
    {"flat", Interpolation::kFlat},
}};

inline constexpr std::array<EnumName<Sampling>, 3> kSamplings{{
    {"center", Sampling::kCenter},
    {"centroid", Sampling::kCentroid},
    {"sample", Sampling::kSample},
}};

inline constexpr std::array<EnumName<VaryingSource>, 3> kVaryingSources{{
    {"vertices", VaryingSource::kVertices},
    {"frag_coord", VaryingSource::kFragCoord},
    {"point_coord", VaryingSource::kPointCoord},
}};

inline constexpr std::array<EnumName<Effect>, 3> kEffects{{
    {"different", Effect::kDifferent},
    {"same", Effect::kSame},
    {"nothing", Effect::kNothing},
}};

inline constexpr std::array<EnumName<PositionSpace>, 3> kPositionSpaces{{
    {"clip", PositionSpace::kClip},
    {"ndc", PositionSpace::kNdc},
    {"framebuffer", PositionSpace::kFramebuffer},
}};

inline constexpr std::array<EnumName<Handedness>, 2> kHandedness{{
    {"right", Handedness::kRight},
    {"left", Handedness::kLeft},
}};

inline constexpr std::array<EnumName<DrawOrder>, 2> kDrawOrders{{
    {"depth_buffer", DrawOrder::kDepthBuffer},
    {"painter", DrawOrder::kPainter},
}};

inline constexpr std::array<EnumName<TransformOn>, 2> kTransformOn{{
    {"host", TransformOn::kHost},
    {"both", TransformOn::kBoth},
}};

inline constexpr std::array<EnumName<Normals>, 3> kNormals{{
    {"file", Normals::kFile},
    {"flat", Normals::kFlat},
    {"smooth", Normals::kSmooth},
}};

inline constexpr std::array<EnumName<VkFilter>, 2> kFilters{{
    {"nearest", VK_FILTER_NEAREST},
    {"bilinear", VK_FILTER_LINEAR},
}};

inline constexpr std::array<EnumName<VkSamplerAddressMode>, 4> kWrapModes{{
    {"repeat", VK_SAMPLER_ADDRESS_MODE_REPEAT},
    {"mirrored_repeat", VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT},
    {"clamp_to_edge", VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE},
    {"clamp_to_border", VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER},
}};

inline constexpr std::array<EnumName<VkBorderColor>, 2> kBorderColors{{
    {"black", VK_BORDER_COLOR_FLOAT_OPAQUE_BLACK},
    {"white", VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE},
}};

inline constexpr std::array<EnumName<Mipmaps>, 3> kMipmaps{{
    {"none", Mipmaps::kNone},
    {"nearest", Mipmaps::kNearest},
    {"linear", Mipmaps::kLinear},
}};

template <typename T, size_t N>
std::optional<T> enum_value(const std::array<EnumName<T>, N>& names, std::string_view text) {
  const auto* const found =
      std::find_if(names.begin(), names.end(), [&](const auto& name) { return name.text == text; });
  if (found == names.end()) return std::nullopt;
  return found->value;
}

// The name of a value; empty for one that the format does not have.
template <typename T, size_t N>
std::string_view enum_name(const std::array<EnumName<T>, N>& names, T value) {
  const auto* const found =
      std::find_if(names.begin(), names.end(), [&](const auto& name) { return name.value == value; });
  return found == names.end() ? std::string_view() : found->text;
}

template <typename T, size_t N>
std::vector<std::string> enum_names(const std::array<EnumName<T>, N>& names) {
  std::vector<std::string> texts;
  texts.reserve(N);
  for (const auto& name : names) texts.emplace_back(name.text);
  return texts;
}

}  // namespace fillrule::format
