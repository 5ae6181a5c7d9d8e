#include "harness/bench/workloads.h"

namespace fillrule::bench {
namespace {

constexpr uint32_t kSize = 1024;
constexpr uint32_t kMidTriangles = 100'000;
constexpr double kMidArea = 100;
constexpr uint32_t kTinyTriangles = 1'000'000;

Scene with_samples(Scene scene, uint32_t samples) {
  scene.samples = samples;
  return scene;
}

Scene flat(Scene scene) {
  scene.is_flat = true;
  return scene;
}

// So many attributes a vertex, whose mean is no vertex' own colour.
Scene with_attributes(Scene scene, uint32_t count) {
  std::vector<Attribute> attributes;
  attributes.reserve(scene.attributes.size() * count);
  for (const Attribute& color : scene.attributes) {
    for (uint32_t i = 0; i < count; ++i) {
      const float scale = 1.0F / static_cast<float>(i + 1);
      attributes.push_back({color[i % 3] * scale, color[(i + 1) % 3] * scale, color[(i + 2) % 3] * scale, color[3]});
    }
  }
  scene.attribute_count = count;
  scene.attributes = std::move(attributes);
  return scene;
}

Scene fill() {
  return fill_scene(16, kSize);
}

Scene mid() {
  return random_triangles_scene(kMidTriangles, kMidArea, kSize);
}

Scene tiny() {
  return grid_scene(kTinyTriangles, kSize);
}

}  // namespace

const std::vector<Workload>& workloads() {
  static const std::vector<Workload> all{
      {"fill", "16 full-screen quads back to front, w 1 to 4", fill},
      {"mid", "100,000 random triangles of 100 px", mid},
      {"tiny", "1,000,000 triangles of a watertight grid", tiny},
      {"fill_4x", "fill with 4 samples", [] { return with_samples(fill(), 4); }},
      {"mid_4x", "mid with 4 samples", [] { return with_samples(mid(), 4); }},
      {"tiny_4x", "tiny with 4 samples", [] { return with_samples(tiny(), 4); }},
      {"fill_flat", "fill in flat colours", [] { return flat(fill()); }},
      {"mid_flat", "mid in flat colours", [] { return flat(mid()); }},
      {"fill_4_varyings", "fill with four vec4", [] { return with_attributes(fill(), 4); }},
      {"mid_4_varyings", "mid with four vec4", [] { return with_attributes(mid(), 4); }},
      {"lines", "100,000 random lines of 30 px", [] { return lines_scene(100'000, 30, kSize); }},
      {"mesh", "a torus with bumps, 80,000 triangles, back faces culled", [] { return mesh_scene(kSize); }},
      {"clip", "20,000 large triangles around the camera, most of them cut",
       [] { return clip_scene(20'000, kSize); }},
  };
  return all;
}

}  // namespace fillrule::bench
