#include "harness/programs/varyings.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/programs/draw_draws.h"

namespace fillrule::programs {
namespace {

Result<void> check_target(const Target& target) {
  if (target.width == 0 || target.width > kMaxTargetSize || target.height == 0 || target.height > kMaxTargetSize) {
    return failure(fmt::format("a target of {} x {} pixels", target.width, target.height),
                   fmt::format("1 to {} each", kMaxTargetSize));
  }
  return {};
}

Result<void> check_varyings(const Case& drawn_case) {
  const uint32_t components = component_count(drawn_case.varyings);
  if (components > kMaxVaryings * kMaxVaryingComponents) {
    return failure(fmt::format("{} components of varyings", components),
                   fmt::format("at most {}", kMaxVaryings * kMaxVaryingComponents));
  }
  for (const Varying& varying : drawn_case.varyings) {
    if (varying.source == VaryingSource::kFragCoord && varying.components > 4) {
      return failure(fmt::format("{} components of gl_FragCoord", varying.components), "4");
    }
    if (varying.source == VaryingSource::kPointCoord && varying.components > 2) {
      return failure(fmt::format("{} components of gl_PointCoord", varying.components), "2");
    }
  }
  const uint32_t vertex_components = vertex_component_count(drawn_case.varyings);
  for (const Draw& draw : drawn_case.draws) {
    if (draw.varyings.size() != draw.positions.size() * vertex_components) {
      return failure(fmt::format("{} values of varyings for {} vertices of {} components", draw.varyings.size(),
                                 draw.positions.size(), vertex_components));
    }
  }
  return {};
}

}  // namespace

VaryingsProgram::VaryingsProgram(const std::vector<Varying>& varyings, const Draw& draw, uint32_t first_primitive,
                                 Planes& planes)
    : draw_(&draw),
      first_primitive_(first_primitive),
      width_(planes.width),
      samples_(planes.samples),
      hits_(planes.hits.data()),
      owner_(planes.owner.data()),
      front_facing_(planes.front_facing.data()) {
  for (const Varying& varying : varyings) {
    has_centroid_ = has_centroid_ || varying.sampling == Sampling::kCentroid;
    has_sample_ = has_sample_ || varying.sampling == Sampling::kSample;
    has_frag_coord_ = has_frag_coord_ || varying.source == VaryingSource::kFragCoord;
    has_point_coord_ = has_point_coord_ || varying.source == VaryingSource::kPointCoord;
    const bool is_of_vertices = varying.source == VaryingSource::kVertices;
    for (uint32_t i = 0; i < varying.components; ++i) {
      components_[component_count_] = {.plane = planes.varyings[component_count_].data(),
                                       .interpolation = varying.interpolation,
                                       .sampling = varying.sampling,
                                       .source = varying.source,
                                       .index = is_of_vertices ? vertex_component_count_++ : i};
      ++component_count_;
    }
  }
  is_plain_ = samples_ == 1 && !has_centroid_ && !has_sample_ && !has_frag_coord_ && !has_point_coord_;
  Component* const end = components_.data() + component_count_;
  const auto move_to_front = [&](uint32_t from, Interpolation interpolation) {
    Component* const behind = std::partition(components_.data() + from, end, [interpolation](const Component& one) {
      return one.interpolation == interpolation;
    });
    return static_cast<uint32_t>(behind - components_.data());
  };
  flat_end_ = move_to_front(0, Interpolation::kFlat);
  smooth_end_ = move_to_front(flat_end_, Interpolation::kSmooth);
}

FeatureSet renderer_features() {
  FeatureSet features;
  for (const Feature feature : {Feature::kIndexTypeUint8, Feature::kPrimitiveRestart, Feature::kProvokingVertexLast,
                                Feature::kSamples2,       Feature::kSamples4,         Feature::kSamples8,
                                Feature::kSamples16,      Feature::kSampleMask,       Feature::kCentroid,
                                Feature::kSampleShading,  Feature::kDepthD16,         Feature::kDepthX8D24,
                                Feature::kDepthBias,      Feature::kDepthBiasClamp,   Feature::kDepthBounds,
                                Feature::kDepthClamp,     Feature::kDepthClipOff,     Feature::kNegativeOneToOne,
                                Feature::kClipDistances,  Feature::kCullDistances,    Feature::kFragCoord}) {
    features.add(feature);
  }
  for (const Feature feature : {Feature::kPoints, Feature::kLargePoints, Feature::kLines, Feature::kBresenhamLines,
                                Feature::kWideLines, Feature::kFillModeNonSolid, Feature::kPointCoord}) {
    features.add(feature);
  }
  return features;
}

Result<Planes> cleared_planes(const Case& drawn_case) {
  if (const Result<void> checked =
          check_target(drawn_case.target).and_then([&] { return check_varyings(drawn_case); });
      !checked) {
    return tl::unexpected(checked.error());
  }
  const FeatureSet missing = features_of(drawn_case).without(renderer_features());
  if (!missing.empty()) return failure(fmt::format("the renderer lacks {}", to_string(missing)));
  const Target& target = drawn_case.target;
  Planes planes = Planes::cleared(
      target.width, target.height, static_cast<uint32_t>(target.samples), component_count(drawn_case.varyings),
      renderer::quantized_depth(renderer::max_depth_code(target.depth_format), target.clear_depth));
  if (target.depth_format == VK_FORMAT_UNDEFINED) {
    planes.depth.clear();
  }
  return planes;
}

renderer::DrawInput draw_input(const Case& drawn_case, const Draw& draw, std::span<const ElementRun> runs,
                               const renderer::DepthBuffer& depth) {
  const Target& target = drawn_case.target;
  const bool sample_shading = std::any_of(drawn_case.varyings.begin(), drawn_case.varyings.end(),
                                          [](const Varying& one) { return one.sampling == Sampling::kSample; });
  return {.target_width = target.width,
          .target_height = target.height,
          .samples = static_cast<uint32_t>(target.samples),
          .sample_shading = sample_shading,
          .vertices = {.topology = draw.topology,
                       .vertex_count = static_cast<uint32_t>(draw.positions.size()),
                       .indices = draw.indices ? renderer::Indices(*draw.indices) : std::nullopt,
                       .vertex_offset = draw.vertex_offset,
                       .runs = runs,
                       .point_sizes = draw.point_sizes},
          .clip_distances = {.count = draw.clip_distance_count, .values = draw.clip_distances},
          .cull_distances = {.count = draw.cull_distance_count, .values = draw.cull_distances},
          .state = draw.state,
          .depth = depth};
}

Result<Planes> draw_case(const Case& drawn_case, const renderer::Options& options) {
  return draw_draws(drawn_case, options, [&](size_t draw, uint32_t first_primitive, Planes& planes) {
    return VaryingsProgram(drawn_case.varyings, drawn_case.draws[draw], first_primitive, planes);
  });
}

}  // namespace fillrule::programs
