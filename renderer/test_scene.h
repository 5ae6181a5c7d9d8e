// For the renderer's tests: a draw with all its state and the planes that it leaves.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <random>
#include <vector>

#include "renderer/prepared_draw.h"

namespace fillrule::renderer {

// Row by row, the samples of a pixel side by side; every value but `hits` is that of the last fragment.
struct TestPlanes {
  uint32_t width = 0;
  uint32_t samples = 1;
  std::vector<uint32_t> hits;
  std::vector<uint32_t> owner;  // kNobody where nothing landed
  std::vector<uint32_t> front_facing;
  std::vector<float> depth;
  std::vector<float> smooth;
  std::vector<float> noperspective;
  std::vector<float> centroid;   // noperspective too
  std::vector<float> at_sample;  // likewise: at the fragment's position
  std::vector<float> flat;
  std::vector<float> point_s;
  std::vector<float> point_t;

  [[nodiscard]] size_t pixel(uint32_t x, uint32_t y, uint32_t sample = 0) const {
    return (size_t{y} * width + x) * samples + sample;
  }
};

inline constexpr uint32_t kNobody = 0xFFFFFFFFU;

struct TestScene {
  uint32_t width = 64;
  uint32_t height = 64;
  uint32_t samples = 1;
  bool sample_shading = false;
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  RasterState state;
  std::vector<ClipPosition> positions;
  std::vector<float> values;  // one varying a vertex; 0 where absent
  std::optional<std::vector<uint32_t>> indices;
  std::vector<float> clip_distances;  // as many for each vertex; likewise the next
  std::vector<float> cull_distances;
  std::vector<float> point_sizes;
  VkFormat depth_format = VK_FORMAT_D32_SFLOAT;
  float clear_depth = 1;

  // The viewport and the scissor are the target.
  TestScene(uint32_t target_width, uint32_t target_height) : width(target_width), height(target_height) {
    state.viewport = {0, 0, static_cast<float>(width), static_cast<float>(height), 0, 1};
    state.scissor = {{0, 0}, {width, height}};
  }

  // The clip-space position that lands on (x, y) of the target, whatever w is. Exact for sizes and w that are powers
  // of two and multiples of 1/256 px.
  [[nodiscard]] ClipPosition at(double x, double y, double z_ndc = 0.5, double w = 1) const {
    return {static_cast<float>((x * 2 / width - 1) * w), static_cast<float>((y * 2 / height - 1) * w),
            static_cast<float>(z_ndc * w), static_cast<float>(w)};
  }
};

// In a source of its own, so that the pipeline is translated for all instruction sets once and not for each test.
Result<void> render_into(const TestScene& scene, TestPlanes& planes, const Options& options = {});

inline TestPlanes cleared_planes(const TestScene& scene) {
  const size_t pixels = size_t{scene.width} * scene.height * scene.samples;
  TestPlanes planes{.width = scene.width, .samples = scene.samples};
  planes.hits.assign(pixels, 0);
  planes.owner.assign(pixels, kNobody);
  planes.front_facing.assign(pixels, 0);
  planes.depth.assign(pixels, scene.clear_depth);
  planes.smooth.assign(pixels, 0);
  planes.noperspective.assign(pixels, 0);
  planes.centroid.assign(pixels, 0);
  planes.at_sample.assign(pixels, 0);
  planes.flat.assign(pixels, 0);
  planes.point_s.assign(pixels, 0);
  planes.point_t.assign(pixels, 0);
  return planes;
}

inline TestPlanes render(const TestScene& scene, const Options& options = {}) {
  TestPlanes planes = cleared_planes(scene);
  const Result<void> drawn = render_into(scene, planes, options);
  EXPECT_TRUE(drawn) << to_string(drawn.error());
  return planes;
}

inline bool same_bytes(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

inline bool same_bytes(const TestPlanes& a, const TestPlanes& b) {
  return a.hits == b.hits && a.owner == b.owner && a.front_facing == b.front_facing && same_bytes(a.depth, b.depth) &&
         same_bytes(a.smooth, b.smooth) && same_bytes(a.noperspective, b.noperspective) &&
         same_bytes(a.centroid, b.centroid) && same_bytes(a.at_sample, b.at_sample) && same_bytes(a.flat, b.flat) &&
         same_bytes(a.point_s, b.point_s) && same_bytes(a.point_t, b.point_t);
}

inline size_t count_of(const std::vector<uint32_t>& plane, uint32_t value) {
  return static_cast<size_t>(std::count(plane.begin(), plane.end(), value));
}

// Random numbers whose seed a failing test prints. FILLRULE_SEED repeats a run.
class SeededRandom {
 public:
  SeededRandom()
      : seed_(choose_seed()), engine_(seed_), trace_(__FILE__, __LINE__, "FILLRULE_SEED=" + std::to_string(seed_)) {
    ::testing::Test::RecordProperty("seed", std::to_string(seed_));
  }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  uint32_t bits() { return static_cast<uint32_t>(engine_()); }

 private:
  static uint32_t choose_seed() {
    const char* const chosen = std::getenv("FILLRULE_SEED");
    return chosen != nullptr ? static_cast<uint32_t>(std::strtoul(chosen, nullptr, 10)) : std::random_device()();
  }

  uint32_t seed_;
  std::mt19937 engine_;
  ::testing::ScopedTrace trace_;  // every failure while this lives names the seed
};

}  // namespace fillrule::renderer
