#include "renderer/pipeline.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "renderer/test_scene.h"

namespace fillrule::renderer {
namespace {

// Triangles from a pixel to several tiles and the whole target, some clipped: bins of every kind.
TestScene many_triangles(SeededRandom& random, uint32_t triangles) {
  TestScene scene(512, 384);
  scene.state.depth_test = true;
  scene.state.depth_compare = VK_COMPARE_OP_LESS_OR_EQUAL;
  for (uint32_t i = 0; i < triangles; ++i) {
    const double size = std::exp2(random.uniform(0, i % 64 == 0 ? 11 : 6));
    const double x = random.uniform(0, 512);
    const double y = random.uniform(0, 384);
    for (int k = 0; k < 3; ++k) {
      scene.positions.push_back(scene.at(x + random.uniform(-size, size), y + random.uniform(-size, size),
                                         random.uniform(-0.1, 1.05), random.uniform(i % 16 == 0 ? -0.5 : 0.5, 4)));
      scene.values.push_back(static_cast<float>(random.uniform(0, 1)));
    }
  }
  return scene;
}

TEST(Pipeline, SameBytesForAnyNumberOfThreads) {
  SeededRandom random;
  const TestScene scene = many_triangles(random, 40000);
  const TestPlanes expected = render(scene, {.threads = 1});
  EXPECT_GT(*std::max_element(expected.hits.begin(), expected.hits.end()), 3U);
  for (const uint32_t threads : {2U, 3U, 8U}) {
    EXPECT_TRUE(same_bytes(render(scene, {.threads = threads}), expected)) << threads << " threads";
  }
}

TEST(Pipeline, SameBytesOfSeveralBatches) {
  SeededRandom random;
  TestScene scene(512, 384);
  constexpr uint32_t kTriangles = kPrimitivesInChunk * kChunksInBatch + 3000;
  for (uint32_t i = 0; i < kTriangles; ++i) {
    const double x = random.uniform(0, 512);
    const double y = random.uniform(0, 384);
    for (int k = 0; k < 3; ++k) {
      scene.positions.push_back(scene.at(x + random.uniform(-2, 2), y + random.uniform(-2, 2), 0.5, 1));
      scene.values.push_back(static_cast<float>(random.uniform(0, 1)));
    }
  }
  const TestPlanes expected = render(scene, {.threads = 1});
  const auto [least, greatest] = std::minmax_element(expected.owner.begin(), expected.owner.end());
  EXPECT_LT(*least, kPrimitivesInChunk * kChunksInBatch);
  EXPECT_GE(*greatest, kPrimitivesInChunk * kChunksInBatch);
  for (const uint32_t threads : {2U, 3U}) {
    EXPECT_TRUE(same_bytes(render(scene, {.threads = threads}), expected)) << threads << " threads";
  }
}

TEST(Pipeline, GivesThreadsTheChunksOfTheirBands) {
  constexpr uint32_t kChunks = 5;
  const DrawInput input{
      .target_width = 512,
      .target_height = 512,
      .vertices = {.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, .vertex_count = 3 * kPrimitivesInChunk * kChunks},
      .state = {.viewport = {.width = 512, .height = 512, .maxDepth = 1},
                .scissor = {.extent = {.width = 512, .height = 512}}}};
  const PreparedDraw prepared = prepare_draw(input, {});
  const TileGrid grid(prepared.setup.clip_pixels);
  std::vector<WindowVertex> vertices(input.vertices.vertex_count);
  const auto put = [&](uint32_t chunk, int32_t y, ClipCode clip_code) {
    for (uint32_t i = 0; i < 3 * kPrimitivesInChunk; ++i) {
      WindowVertex& vertex = vertices[size_t{chunk} * 3 * kPrimitivesInChunk + i];
      vertex.position.y_fixed = y << prepared.subpixel_bits;
      vertex.clip_code = clip_code;
    }
  };
  put(0, 10, 0);
  put(1, 127, 0);
  put(2, 128, 0);
  put(3, 400, 0);
  put(4, 400, 1);
  EXPECT_THAT(chunks_by_bands(prepared, grid, vertices, {0, kChunks}, 2),
              ::testing::ElementsAre(0, 2, 1, 3, 4, kNoChunk));
  EXPECT_THAT(chunks_by_bands(prepared, grid, vertices, {2, 2}, 2), ::testing::ElementsAre(kNoChunk, 0, kNoChunk, 1));
  EXPECT_THAT(chunks_by_bands(prepared, grid, vertices, {0, kChunks}, 1), ::testing::ElementsAre(0, 1, 2, 3, 4));
}

// Layer upon layer, their edges within a pixel of a tile's corner: beyond all samples of the tile, or not quite. The
// scanlines know of no tiles.
TEST(WholeTiles, EqualScanlinesWhereAnEdgeNearlyMissesTheTile) {
  SeededRandom random;
  for (const uint32_t samples : {1U, 2U, 4U, 8U, 16U}) {
    for (const bool is_bordered : {false, true}) {
      TestScene scene(256, 128);
      scene.samples = samples;
      scene.state.depth_test = true;
      if (is_bordered) {  // not by whole pixels: of some pixels a few samples are within the viewport
        scene.state.viewport = {0.25F, 0.5F, 255.5F, 127, 0, 1};
        scene.state.scissor = {{0, 1}, {192, 127}};
      }
      for (uint32_t i = 0; i < 50; ++i) {
        // The samples that are nearest to a border of pixels are one of these away from it: edges along rows and
        // columns go through them.
        constexpr std::array kNearest{0.0, 1.0 / 16, 2.0 / 16, 4.0 / 16, 8.0 / 16};
        const auto from_corner = [&] {
          return (random.bits() % 2 == 0 ? 1 : -1) * kNearest[random.bits() % kNearest.size()];
        };
        const double x = 64 * std::floor(random.uniform(0, 5)) + from_corner();
        const double y = 64 * std::floor(random.uniform(0, 3)) + from_corner();
        const double dx = i % 4 == 1 ? 0 : random.uniform(-1000, 1000);
        const double dy = i % 4 == 2 ? 0 : random.uniform(-1000, 1000);
        const double side = random.bits() % 2 == 0 ? 1 : -1;
        const double depth = 0.9 - i * 0.015 + random.uniform(-0.03, 0.03);  // most are nearer than those before
        scene.positions.push_back(scene.at(x - dx, y - dy, depth));
        scene.positions.push_back(scene.at(x + dx, y + dy, depth));
        scene.positions.push_back(scene.at(x - side * dy, y + side * dx, depth));
        for (int k = 0; k < 3; ++k) scene.values.push_back(static_cast<float>(random.uniform(0, 1)));
      }
      const TestPlanes expected = render(scene, {.fill = Fill::kScanline});
      EXPECT_GT(*std::max_element(expected.hits.begin(), expected.hits.end()), 3U);
      for (const Isa isa : kAllIsas) {
        if (!is_supported(isa)) continue;
        EXPECT_TRUE(same_bytes(render(scene, {.isa = isa}), expected)) << samples << " samples, " << to_string(isa);
      }
    }
  }
}

TEST(Pipeline, TheLastSubmittedWinsWithoutADepthTest) {
  SeededRandom random;
  TestScene scene = many_triangles(random, 6000);
  scene.state.depth_test = false;
  const TestPlanes all = render(scene, {.threads = 2});
  // Drawn one by one, in order.
  TestPlanes one_by_one = cleared_planes(scene);
  TestScene single = scene;
  constexpr uint32_t kDrawnOneByOne = 301;
  constexpr size_t kVertices = 3;
  for (uint32_t i = 0; i < kDrawnOneByOne; ++i) {
    const auto first_vertex = static_cast<std::ptrdiff_t>(i * kVertices);
    single.positions.assign(scene.positions.begin() + first_vertex, scene.positions.begin() + first_vertex + 3);
    single.values.assign(scene.values.begin() + first_vertex, scene.values.begin() + first_vertex + 3);
    const TestPlanes before = one_by_one;
    ASSERT_TRUE(render_into(single, one_by_one));
    for (size_t pixel = 0; pixel < before.hits.size(); ++pixel) {
      if (one_by_one.hits[pixel] != before.hits[pixel]) {
        one_by_one.owner[pixel] = i;
      }
    }
  }
  TestScene first = scene;
  first.positions.resize(kDrawnOneByOne * kVertices);
  first.values.resize(kDrawnOneByOne * kVertices);
  EXPECT_TRUE(same_bytes(render(first), one_by_one));
  EXPECT_EQ(all.hits.size(), one_by_one.hits.size());
}

TEST(Pipeline, PrimitiveNumbersCountWhatIsNotDrawn) {
  TestScene scene(16, 16);
  scene.state.cull_mode = VK_CULL_MODE_BACK_BIT;
  const auto add = [&](std::initializer_list<ClipPosition> triangle) {
    for (const ClipPosition& position : triangle) {
      scene.positions.push_back(position);
    }
  };
  add({scene.at(1, 1), scene.at(15, 1), scene.at(1, 15)});              // back-facing
  add({scene.at(1, 1), scene.at(1, 1), scene.at(1, 15)});               // no area
  add({scene.at(1, 1, -1), scene.at(1, 15, -1), scene.at(15, 1, -1)});  // clipped away
  add({scene.at(1, 1), scene.at(1, 15), scene.at(15, 1)});
  scene.positions.push_back(scene.at(1, 1));  // incomplete
  EXPECT_EQ(render(scene).owner[3 * 16 + 3], 3U);
}

TEST(Pipeline, IndexedEqualsNotIndexed) {
  SeededRandom random;
  TestScene scene = many_triangles(random, 100);
  const TestPlanes expected = render(scene);
  scene.indices.emplace();
  for (uint32_t i = 0; i < 300; ++i) {
    scene.indices->push_back(299 - i);
  }
  std::reverse(scene.positions.begin(), scene.positions.end());
  std::reverse(scene.values.begin(), scene.values.end());
  EXPECT_TRUE(same_bytes(render(scene), expected));
}

TEST(Pipeline, StripAndFanFillAQuadWithOneWinding) {
  for (const auto topology : {VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN}) {
    TestScene scene(16, 16);
    scene.topology = topology;
    scene.positions = {scene.at(0, 0), scene.at(0, 16), scene.at(16, 0), scene.at(16, 16)};
    if (topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN) {
      std::swap(scene.positions[2], scene.positions[3]);
    }
    const TestPlanes planes = render(scene);
    EXPECT_EQ(planes.hits, std::vector<uint32_t>(256, 1));
    EXPECT_EQ(planes.front_facing, std::vector<uint32_t>(256, 1));
    EXPECT_GT(count_of(planes.owner, 0), 100U);
    EXPECT_GT(count_of(planes.owner, 1), 100U);
  }
}

TestScene everything(uint32_t width, uint32_t height) {
  TestScene scene(width, height);
  scene.positions = {{-9, -9, 0.5F, 1}, {30, -9, 0.5F, 1}, {-9, 30, 0.5F, 1}};
  return scene;
}

PixelRect hit_pixels(const TestPlanes& planes) {
  PixelRect rect{1 << 20, 1 << 20, 0, 0};
  size_t count = 0;
  for (size_t pixel = 0; pixel < planes.hits.size(); ++pixel) {
    if (planes.hits[pixel] != 0) {
      const auto x = static_cast<int32_t>(pixel % planes.width);
      const auto y = static_cast<int32_t>(pixel / planes.width);
      rect = {std::min(rect.left, x), std::min(rect.top, y), std::max(rect.right, x + 1),
              std::max(rect.bottom, y + 1)};
      ++count;
    }
  }
  EXPECT_EQ(count, static_cast<size_t>(rect.width()) * static_cast<size_t>(rect.height()));
  return rect;
}

TEST(Pipeline, FragmentsStayInViewportScissorAndTarget) {
  TestScene scene = everything(70, 50);
  EXPECT_EQ(hit_pixels(render(scene)), (PixelRect{0, 0, 70, 50}));
  scene.state.viewport = {10.25F, 5.75F, 40.5F, 30, 0, 1};
  EXPECT_EQ(hit_pixels(render(scene)), (PixelRect{10, 6, 51, 36}));
  scene.state.viewport = {-20, -30, 60, 60, 0, 1};
  EXPECT_EQ(hit_pixels(render(scene)), (PixelRect{0, 0, 40, 30}));
  scene.state.scissor = {{7, 9}, {11, 0xFFFFFFFFU}};
  EXPECT_EQ(hit_pixels(render(scene)), (PixelRect{7, 9, 18, 30}));
  scene.state.scissor = {{33, 22}, {1, 1}};
  EXPECT_EQ(hit_pixels(render(scene)), (PixelRect{33, 22, 34, 23}));
}

TEST(Pipeline, AnEmptyScissorOrAViewportBesideTheTargetDrawsNothing) {
  TestScene scene = everything(16, 16);
  scene.state.scissor = {{4, 4}, {0, 5}};
  EXPECT_EQ(count_of(render(scene).hits, 0), 256U);
  scene.state.scissor = {{16, 0}, {16, 16}};
  EXPECT_EQ(count_of(render(scene).hits, 0), 256U);
  scene.state.scissor = {{0, 0}, {16, 16}};
  scene.state.viewport.x = 100;
  EXPECT_EQ(count_of(render(scene).hits, 0), 256U);
}

TEST(Pipeline, ScissoringIsCropping) {
  SeededRandom random;
  TestScene scene = many_triangles(random, 300);
  const TestPlanes whole = render(scene);
  scene.state.scissor = {{101, 37}, {203, 155}};
  const TestPlanes part = render(scene);
  for (uint32_t y = 37; y < 37 + 155; ++y) {
    for (uint32_t x = 101; x < 101 + 203; ++x) {
      const size_t pixel = whole.pixel(x, y);
      ASSERT_EQ(part.hits[pixel], whole.hits[pixel]);
      ASSERT_EQ(std::bit_cast<uint32_t>(part.smooth[pixel]), std::bit_cast<uint32_t>(whole.smooth[pixel]));
      ASSERT_EQ(part.depth[pixel], whole.depth[pixel]);
    }
  }
}

TEST(Pipeline, PlaneEquationsDoNotDependOnTheScissorOrTheTarget) {
  const auto anchor_of = [](const VkRect2D& scissor, uint32_t size) {
    TestScene scene = everything(64, 64);
    scene.state.scissor = scissor;
    const PreparedDraw prepared = prepare_draw(
        {.target_width = size, .target_height = size, .vertices = {.vertex_count = 3}, .state = scene.state}, {});
    const std::array<FixedPosition, 3> outline = {{{10 * 256, 300 * 256}, {20 * 256, -5 * 256}, {12 * 256, 0}}};
    const PrimitiveInterpolation interpolation =
        make_interpolation(prepared, {.indices = {0, 1, 2}}, scene.positions, outline);
    return std::pair(interpolation.anchor_x, interpolation.anchor_y);
  };
  const auto whole = anchor_of({{0, 0}, {64, 64}}, 64);
  EXPECT_EQ(whole, std::pair(10, 0));
  EXPECT_EQ(anchor_of({{30, 30}, {4, 4}}, 64), whole);
  EXPECT_EQ(anchor_of({{0, 0}, {64, 64}}, 5), whole);
}

TEST(Pipeline, RefusesWhatItCannotDraw) {
  const auto error_of = [](const auto& change, const Options& options = {}) {
    TestScene scene = everything(16, 16);
    change(scene);
    TestPlanes planes = cleared_planes(scene);
    const Result<void> drawn = render_into(scene, planes, options);
    EXPECT_EQ(count_of(planes.hits, 0), planes.hits.size());
    return drawn ? std::string() : drawn.error().what;
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(error_of([](TestScene& s) { s.state.viewport.width = 0; }), HasSubstr("viewport of 0 x 16"));
  EXPECT_THAT(error_of([](TestScene& s) { s.state.viewport.height = 16385; }), HasSubstr("viewport of 16 x 16385"));
  EXPECT_THAT(error_of([](TestScene& s) { s.state.viewport.height = std::nanf(""); }), HasSubstr("viewport of"));
  EXPECT_THAT(error_of([](TestScene& s) { s.state.viewport.x = -40000; }), HasSubstr("viewport from (-40000"));
  EXPECT_THAT(error_of([](TestScene& s) { s.state.viewport.maxDepth = 2; }), HasSubstr("depth range 0 to 2"));
  EXPECT_THAT(error_of([](TestScene& s) { s.topology = VK_PRIMITIVE_TOPOLOGY_PATCH_LIST; }),
              HasSubstr("topology 10"));
  EXPECT_THAT(error_of([](TestScene& s) { s.indices = {{0, 1, 3}}; }), HasSubstr("index 3 in a draw of 3 vertices"));
  EXPECT_THAT(error_of([](TestScene&) {}, {.subpixel_bits = 3}), HasSubstr("3 subpixel bits"));
  EXPECT_THAT(error_of([](TestScene&) {}, {.subpixel_bits = 9}), HasSubstr("9 subpixel bits"));
}

TEST(Pipeline, RefusesADepthBufferOfAnotherSize) {
  const TestScene scene = everything(16, 16);
  TestPlanes planes = cleared_planes(scene);
  planes.depth.pop_back();
  EXPECT_FALSE(render_into(scene, planes));
}

// A scene in colour with some tiles drawn to, some not, and both attachments.
struct ColoredTarget {
  static constexpr uint32_t kWidth = 203;  // neither whole tiles nor whole blocks
  static constexpr uint32_t kHeight = 150;
  uint32_t samples = 1;
  VkRect2D scissor{{0, 0}, {kWidth, kHeight}};
  bool depth_test = true;
  std::vector<ClipPosition> positions;
};

struct ColoredPlanes {
  std::vector<float> depth;
  std::vector<uint32_t> color;
  // Of the bytes: depths may be NaN.
  bool operator==(const ColoredPlanes& other) const { return same_bytes(depth, other.depth) && color == other.color; }
};

struct OneColor {
  using PrimitiveData = Vec4;
  const ColoredTarget& target;
  uint32_t first_primitive = 0;
  [[nodiscard]] ClipPosition position(uint32_t vertex) const {
    return target.positions[size_t{3} * first_primitive + vertex];
  }
  [[nodiscard]] PrimitiveData primitive_data(const ShadedPrimitive& primitive) const {
    return {1, static_cast<float>((first_primitive + primitive.primitive) % 7) / 7, 0.5F, 1};
  }
  template <typename L>
  [[nodiscard, gnu::always_inline]] Color<L> color(const PrimitiveData& data,
                                                   const FragmentLanes<L>& fragments) const {
    return fragments.flat(data);
  }
};

constexpr float kClearDepth = 0.75F;
constexpr uint32_t kClearColor = 0xFF102030U;

DrawInput input_of(const ColoredTarget& target, ColoredPlanes& planes) {
  return {.target_width = ColoredTarget::kWidth,
          .target_height = ColoredTarget::kHeight,
          .samples = target.samples,
          .vertices = {.vertex_count = static_cast<uint32_t>(target.positions.size())},
          .state = {.viewport = {0, 0, ColoredTarget::kWidth, ColoredTarget::kHeight, 0, 1},
                    .scissor = target.scissor,
                    .depth_test = target.depth_test},
          .depth = {.values = planes.depth},
          .color = {.values = planes.color}};
}

// Cleared by the draw, or before it by a test that fills all of the planes.
ColoredPlanes drawn(const ColoredTarget& target, bool by_draw, const Options& options) {
  const size_t values = size_t{ColoredTarget::kWidth} * ColoredTarget::kHeight * target.samples;
  ColoredPlanes planes{.depth = std::vector(values, by_draw ? 0.125F : kClearDepth),
                       .color = std::vector(values, by_draw ? 0xDEADBEEFU : kClearColor)};
  DrawInput input = input_of(target, planes);
  if (by_draw) {
    input.depth.clear = kClearDepth;
    input.color.clear = kClearColor;
  }
  EXPECT_TRUE(draw(input, OneColor{target}, options));
  return planes;
}

TEST(Clear, IsThatOfAllValuesBeforeTheDraw) {
  SeededRandom random;
  const auto triangles = [&](uint32_t count, double extent) {
    std::vector<ClipPosition> positions;
    for (uint32_t i = 0; i < count; ++i) {
      const double x = random.uniform(-0.5, 0.5);
      const double y = random.uniform(-1, 0.2);
      for (int corner = 0; corner < 3; ++corner) {
        positions.push_back({static_cast<float>(x + random.uniform(-extent, extent)),
                             static_cast<float>(y + random.uniform(-extent, extent)),
                             static_cast<float>(random.uniform(0.1, 1)), 1});
      }
    }
    return positions;
  };
  std::vector<ColoredTarget> targets;
  for (const uint32_t samples : {1U, 2U, 4U}) {
    targets.push_back({.samples = samples, .positions = triangles(20, 0.2)});
    targets.push_back({.samples = samples, .positions = triangles(40, 1)});  // in the border's blocks too
    targets.push_back({.samples = samples, .scissor = {{70, 67}, {60, 40}}, .positions = triangles(20, 0.6)});
    targets.push_back({.samples = samples, .depth_test = false, .positions = triangles(5, 0.3)});
    targets.push_back({.samples = samples, .scissor = {{50, 50}, {0, 9}}, .positions = triangles(5, 0.3)});
    targets.push_back({.samples = samples});  // nothing to draw
  }
  // Several batches: only the first one clears.
  targets.push_back({.positions = triangles(300'000, 0.01)});
  for (const ColoredTarget& target : targets) {
    SCOPED_TRACE(&target - targets.data());
    for (const Isa isa : kAllIsas) {
      if (!is_supported(isa)) continue;
      for (const uint32_t threads : {1U, 3U}) {
        const Options options{.threads = threads, .isa = isa};
        EXPECT_EQ(drawn(target, true, options), drawn(target, false, options)) << to_string(isa) << threads;
      }
    }
  }
}

// Sample by sample: of each triangle drawn by itself, what is nearer than all before it.
ColoredPlanes nearest_of_each(const ColoredTarget& target, ColoredPlanes planes) {
  for (uint32_t triangle = 0; triangle < target.positions.size() / 3; ++triangle) {
    ColoredPlanes alone{.depth = std::vector(planes.depth.size(), 1.0F),
                        .color = std::vector(planes.color.size(), 0U)};
    DrawInput input = input_of(target, alone);
    input.vertices.vertex_count = 3;
    EXPECT_TRUE(draw(input, OneColor{target, triangle}, {.isa = Isa::kScalar}));
    for (size_t i = 0; i < planes.depth.size(); ++i) {
      if (alone.depth[i] < planes.depth[i]) {
        planes.depth[i] = alone.depth[i];
        planes.color[i] = alone.color[i];
      }
    }
  }
  return planes;
}

// Some depths are no numbers: nothing lands there, and they are no limit of a block's depths either.
TEST(HiddenBlocks, LeaveTheNearestOfEachSample) {
  SeededRandom random;
  for (const uint32_t samples : {1U, 4U}) {
    ColoredTarget target{.samples = samples};
    for (uint32_t vertex = 0; vertex < 3 * 120; ++vertex) {
      // Some hardly tilted and close to each other: there the last bit of a depth decides.
      const double depth_range = vertex / 3 % 3 == 0 ? 1e-7 : 0.4;
      target.positions.push_back({static_cast<float>(random.uniform(-2, 2)),
                                  static_cast<float>(random.uniform(-2, 2)),
                                  static_cast<float>(0.5 + random.uniform(-depth_range, depth_range)), 1});
    }
    ColoredPlanes before = drawn(ColoredTarget{.samples = samples}, false, {});
    for (float& depth : before.depth) {
      if (random.bits() % 32 == 0) depth = std::nanf("");
    }
    const ColoredPlanes expected = nearest_of_each(target, before);
    for (const Isa isa : kAllIsas) {
      if (!is_supported(isa)) continue;
      ColoredPlanes planes = before;
      ASSERT_TRUE(draw(input_of(target, planes), OneColor{target}, {.isa = isa}));
      EXPECT_EQ(planes, expected) << to_string(isa) << ", samples: " << samples;
    }
  }
}

}  // namespace
}  // namespace fillrule::renderer
