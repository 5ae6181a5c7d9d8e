// What a case asks of those who draw or judge it, beyond filled triangles at one sample a pixel. Each party says what
// it has; a case that needs more is skipped with the names of what lacks.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>

#include "cases/model/case.h"

namespace fillrule {

enum class Feature : uint8_t {
  kPoints,
  kLargePoints,
  kLines,
  kBresenhamLines,
  kWideLines,
  kFillModeNonSolid,
  kIndexTypeUint8,
  kPrimitiveRestart,
  kProvokingVertexLast,
  kSamples2,
  kSamples4,
  kSamples8,
  kSamples16,
  kSampleMask,
  kCentroid,
  kSampleShading,
  kDepthD16,
  kDepthX8D24,
  kDepthBias,
  kDepthBiasClamp,
  kDepthBounds,
  kDepthClamp,
  kDepthClipOff,
  kNegativeOneToOne,
  kClipDistances,
  kCullDistances,
  kFragCoord,
  kPointCoord,
};
inline constexpr size_t kFeatureCount = 28;

struct FeatureName {
  Feature feature;
  std::string_view name;
  std::string_view key;  // what asks for it in a case file
};

// In the order of the enumeration.
inline constexpr std::array<FeatureName, kFeatureCount> kFeatures{{
    {Feature::kPoints, "points", "topology or polygon_mode"},
    {Feature::kLargePoints, "points of other sizes than 1", "point_sizes"},
    {Feature::kLines, "rectangular lines", "topology or polygon_mode"},
    {Feature::kBresenhamLines, "Bresenham lines", "line_mode"},
    {Feature::kWideLines, "lines of other widths than 1", "line_width"},
    {Feature::kFillModeNonSolid, "polygons as lines or points", "polygon_mode"},
    {Feature::kIndexTypeUint8, "8-bit indices", "index_type"},
    {Feature::kPrimitiveRestart, "primitive restart", "primitive_restart"},
    {Feature::kProvokingVertexLast, "the last vertex provoking", "provoking_vertex"},
    {Feature::kSamples2, "2 samples", "samples"},
    {Feature::kSamples4, "4 samples", "samples"},
    {Feature::kSamples8, "8 samples", "samples"},
    {Feature::kSamples16, "16 samples", "samples"},
    {Feature::kSampleMask, "sample mask", "sample_mask"},
    {Feature::kCentroid, "centroid interpolation", "sampling"},
    {Feature::kSampleShading, "interpolation at samples", "sampling"},
    {Feature::kDepthD16, "depth format D16_UNORM", "depth_format"},
    {Feature::kDepthX8D24, "depth format X8_D24_UNORM_PACK32", "depth_format"},
    {Feature::kDepthBias, "depth bias", "depth_bias"},
    {Feature::kDepthBiasClamp, "depth bias clamp", "depth_bias.clamp"},
    {Feature::kDepthBounds, "depth bounds", "depth_bounds"},
    {Feature::kDepthClamp, "depth clamp", "depth_clamp"},
    {Feature::kDepthClipOff, "depth clip off", "depth_clip"},
    {Feature::kNegativeOneToOne, "view volume -w <= z <= w", "negative_one_to_one"},
    {Feature::kClipDistances, "user clip distances", "clip_distances"},
    {Feature::kCullDistances, "user cull distances", "cull_distances"},
    {Feature::kFragCoord, "gl_FragCoord", "source"},
    {Feature::kPointCoord, "gl_PointCoord", "source"},
}};

class FeatureSet {
 public:
  void add(Feature feature) { bits_.set(static_cast<size_t>(feature)); }
  [[nodiscard]] bool has(Feature feature) const { return bits_.test(static_cast<size_t>(feature)); }
  [[nodiscard]] bool empty() const { return bits_.none(); }
  // Those of this set that the other one lacks.
  [[nodiscard]] FeatureSet without(const FeatureSet& other) const {
    FeatureSet rest;
    rest.bits_ = bits_ & ~other.bits_;
    return rest;
  }
  static FeatureSet all() {
    FeatureSet set;
    set.bits_.set();
    return set;
  }
  bool operator==(const FeatureSet&) const = default;

 private:
  std::bitset<kFeatureCount> bits_;
};

// What the case needs.
FeatureSet features_of(const Case& one);

// "depth bounds (depth_bounds), 8 samples (samples)".
std::string to_string(const FeatureSet& features);

}  // namespace fillrule
