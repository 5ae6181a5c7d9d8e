#include "renderer/test_scene.h"

#include <algorithm>

#include "renderer/pipeline.h"

namespace fillrule::renderer {
namespace {

class RecordingProgram {
 public:
  struct PrimitiveData {
    ShadedPrimitive primitive;
    std::array<float, 3> values{};
  };

  RecordingProgram(const TestScene& scene, TestPlanes& planes) : scene_(scene), planes_(planes) {}

  [[nodiscard]] ClipPosition position(uint32_t vertex) const { return scene_.positions[vertex]; }

  [[nodiscard]] PrimitiveData primitive_data(const ShadedPrimitive& primitive) const {
    PrimitiveData data{.primitive = primitive};
    for (size_t i = 0; i < 3; ++i) {
      data.values[i] = scene_.values.empty() ? 0.0F : scene_.values[primitive.vertices[i]];
    }
    return data;
  }

  void fragment(const PrimitiveData& data, const Fragment& fragment) const {
    const auto value_with = [&](const VertexWeights& weights) {
      return interpolate(data.values[0], data.values[1], data.values[2], weights);
    };
    const PixelWeights weights = fragment.weights();
    for (uint32_t sample = 0; sample < planes_.samples; ++sample) {
      if ((fragment.samples >> sample & 1U) == 0) {
        continue;
      }
      const size_t i = planes_.pixel(static_cast<uint32_t>(fragment.x), static_cast<uint32_t>(fragment.y), sample);
      ++planes_.hits[i];
      planes_.owner[i] = data.primitive.primitive;
      planes_.front_facing[i] = data.primitive.front_facing ? 1 : 0;
      planes_.smooth[i] = value_with(weights.smooth);
      planes_.noperspective[i] = value_with(weights.noperspective);
      planes_.centroid[i] = value_with(fragment.weights(fragment.centroid).noperspective);
      planes_.at_sample[i] = value_with(fragment.weights(fragment.position).noperspective);
      planes_.flat[i] = data.values[0];
      planes_.point_s[i] = fragment.point_coord()[0];
      planes_.point_t[i] = fragment.point_coord()[1];
    }
  }

 private:
  const TestScene& scene_;
  TestPlanes& planes_;
};

VertexDistances distances_of(const std::vector<float>& values, size_t vertices) {
  return {.count = static_cast<uint32_t>(values.size() / std::max<size_t>(vertices, 1)), .values = values};
}

}  // namespace

Result<void> render_into(const TestScene& scene, TestPlanes& planes, const Options& options) {
  return draw({.target_width = scene.width,
               .target_height = scene.height,
               .samples = scene.samples,
               .sample_shading = scene.sample_shading,
               .vertices = {.topology = scene.topology,
                            .vertex_count = static_cast<uint32_t>(scene.positions.size()),
                            .indices = scene.indices ? Indices(*scene.indices) : std::nullopt,
                            .point_sizes = scene.point_sizes},
               .clip_distances = distances_of(scene.clip_distances, scene.positions.size()),
               .cull_distances = distances_of(scene.cull_distances, scene.positions.size()),
               .state = scene.state,
               .depth = {planes.depth, scene.depth_format}},
              RecordingProgram(scene, planes), options);
}

}  // namespace fillrule::renderer
