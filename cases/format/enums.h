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

inline constexpr std::array<EnumName<VkPrimitiveTopology>, 3> kTopologies{{
    {"triangle_list", VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST},
    {"triangle_strip", VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP},
    {"triangle_fan", VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN},
}};

// What Vulkan knows and the format does not support yet, so that the error can tell this from a misspelling.
inline constexpr std::array<std::string_view, 8> kUnsupportedTopologies{
    "point_list",
    "line_list",
    "line_strip",
    "line_list_with_adjacency",
    "line_strip_with_adjacency",
    "triangle_list_with_adjacency",
    "triangle_strip_with_adjacency",
    "patch_list",
};

inline constexpr std::array<EnumName<VkFormat>, 1> kDepthFormats{{{"d32_sfloat", VK_FORMAT_D32_SFLOAT}}};

inline constexpr std::array<std::string_view, 6> kUnsupportedDepthFormats{
    "d16_unorm", "x8_d24_unorm_pack32", "d16_unorm_s8_uint", "d24_unorm_s8_uint", "d32_sfloat_s8_uint", "s8_uint",
};

inline constexpr std::array<EnumName<Interpolation>, 3> kInterpolations{{
    {"smooth", Interpolation::kSmooth},
    {"noperspective", Interpolation::kNoperspective},
    {"flat", Interpolation::kFlat},
}};

inline constexpr std::array<EnumName<PositionSpace>, 3> kPositionSpaces{{
    {"clip", PositionSpace::kClip},
    {"ndc", PositionSpace::kNdc},
    {"framebuffer", PositionSpace::kFramebuffer},
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
