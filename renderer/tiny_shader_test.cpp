#include "renderer/tiny_shader.h"

#include <gtest/gtest.h>

#include <functional>

#include "renderer/pipeline.h"
#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

// A smooth and a flat varying, of one primitive or of several.
struct TwoVaryings {
  std::span<const ClipPosition> positions;
  std::span<const Vec4> values;

  template <typename L>
  struct Data {
    VaryingPlanes<L> smooth;
    Color<L> flat;
  };

  [[nodiscard]] ClipPosition position(uint32_t vertex) const { return positions[vertex]; }
  template <typename Primitives>
  [[nodiscard, gnu::always_inline]] auto primitive_data(const Primitives& primitives) const {
    const auto of = [&](uint32_t vertex) -> const Vec4& { return values[vertex]; };
    return Data<typename Primitives::Lanes>{.smooth = primitives.smooth(of), .flat = primitives.flat(of)};
  }
  template <typename L, typename Varyings>
  [[nodiscard, gnu::always_inline]] Color<L> color(const Varyings& data, const FragmentLanes<L>& fragments) const {
    const Color<L> smooth = fragments.smooth(data.smooth);
    const Color<L> flat = fragments.flat(data.flat);
    return {smooth[0], smooth[1] * flat[1], smooth[2], flat[3]};
  }
};
static_assert(LaneProgram<TwoVaryings>);

struct TinyScene {
  std::vector<ClipPosition> positions;
  std::vector<Vec4> values;
};

// Triangles of up to `extent` pixels, now and then a large one among them; some behind the eye in part, and some
// whose corners are on one line, so that only snapping gives them an area and plane equations say nothing of them.
TinyScene tiny_triangles(SeededRandom& random, const TestScene& target, uint32_t count, double extent) {
  TinyScene scene;
  const auto channel = [&] { return static_cast<float>(random.uniform(0, 1)); };
  for (uint32_t i = 0; i < count; ++i) {
    const double x = random.uniform(0, target.width);
    const double y = random.uniform(0, target.height);
    const double own_extent = i % 50 == 0 ? 40 : extent;
    for (uint32_t corner = 0; corner < 3; ++corner) {
      const double w = random.uniform(i % 20 == 0 ? -0.5 : 0.5, 4);
      scene.positions.push_back(target.at(x + random.uniform(-own_extent, own_extent),
                                          y + random.uniform(-own_extent, own_extent), random.uniform(0.2, 0.8), w));
      scene.values.push_back({channel(), channel(), channel(), channel()});
    }
    if (i % 5 == 0) {
      const std::span corners = std::span{scene.positions}.last(3);
      for (size_t component = 0; component < 4; ++component) {
        const auto rounded = [](float value) { return std::round(value * 4096) / 4096; };  // so that the sum is exact
        corners[0][component] = rounded(corners[0][component]);
        corners[1][component] = rounded(corners[1][component]);
        corners[2][component] = corners[0][component] + corners[1][component];
      }
    }
  }
  return scene;
}

struct Drawn {
  std::vector<float> depth;
  std::vector<uint32_t> color;
  bool operator==(const Drawn& other) const { return same_bytes(depth, other.depth) && color == other.color; }
};

Drawn drawn(const TinyScene& scene, const TestScene& target, const Options& options) {
  const size_t pixels = size_t{target.width} * target.height;
  Drawn result{.depth = std::vector(pixels, target.clear_depth), .color = std::vector(pixels, 0xFF102030U)};
  const DrawInput input{.target_width = target.width,
                        .target_height = target.height,
                        .vertices = {.vertex_count = static_cast<uint32_t>(scene.positions.size())},
                        .state = target.state,
                        .depth = {.values = result.depth, .format = target.depth_format},
                        .color = {.values = result.color}};
  EXPECT_TRUE(draw(input, TwoVaryings{scene.positions, scene.values}, options));
  return result;
}

// One at a time there are no lanes: another way to the same values.
TEST(TinyShader, GivesTheBytesOfOneTriangleAtATime) {
  const std::vector<std::function<void(TestScene&)>> variants{
      [](TestScene&) {},
      [](TestScene& target) { target.state.depth_test = false; },
      [](TestScene& target) { target.state.depth_compare = VK_COMPARE_OP_GREATER; },
      [](TestScene& target) { target.state.depth_write = false; },
      [](TestScene& target) { target.depth_format = VK_FORMAT_D16_UNORM; },
      [](TestScene& target) { target.state.depth_bounds = DepthBounds{.min = 0.3F, .max = 0.8F}; },
      [](TestScene& target) { target.state.depth_bias = DepthBias{.constant_factor = 3}; },
      [](TestScene& target) {
        target.state.scissor = {{13, 60}, {57, 41}};
      },
      [](TestScene& target) { target.state.cull_mode = VK_CULL_MODE_BACK_BIT; },
      [](TestScene& target) { target.state.provoking_vertex = VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT; },
  };
  SeededRandom random;
  for (const auto& variant : variants) {
    SCOPED_TRACE(&variant - variants.data());
    TestScene target(150, 131);  // neither whole tiles nor whole blocks
    target.state.depth_test = true;
    target.clear_depth = 0.5F;
    variant(target);
    for (const double extent : {0.6, 1.5, 4.0}) {
      const TinyScene scene = tiny_triangles(random, target, 12000, extent);
      // On a coarse grid more of the triangles without an area get one.
      const uint32_t subpixel_bits = extent > 1 ? kMinSubpixelBits : kMaxSubpixelBits;
      const Drawn expected = drawn(scene, target, {.subpixel_bits = subpixel_bits, .isa = Isa::kScalar});
      EXPECT_GT(std::ranges::count_if(expected.color, [](uint32_t color) { return color != 0xFF102030U; }), 20);
      for (const Isa isa : kAllIsas) {
        if (!is_supported(isa)) continue;
        for (const uint32_t threads : {1U, 3U}) {
          EXPECT_EQ(drawn(scene, target, {.subpixel_bits = subpixel_bits, .threads = threads, .isa = isa}), expected)
              << to_string(isa) << ", threads: " << threads << ", extent: " << extent;
        }
      }
    }
  }
}

}  // namespace
}  // namespace fillrule::renderer
