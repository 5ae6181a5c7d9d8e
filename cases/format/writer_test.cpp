#include "cases/format/writer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <bit>
#include <cmath>
#include <random>

#include "cases/format/enums.h"
#include "cases/format/test_files.h"

namespace fillrule::format {
namespace {

// Equality to the bit: NaN payloads and the sign of zero count.
uint32_t bits(float value) {
  return std::bit_cast<uint32_t>(value);
}

std::vector<uint32_t> bits(const std::vector<float>& values) {
  std::vector<uint32_t> result;
  result.reserve(values.size());
  for (const float value : values) result.push_back(bits(value));
  return result;
}

std::vector<uint32_t> bits(const std::vector<ClipPosition>& positions) {
  std::vector<uint32_t> result;
  for (const ClipPosition& position : positions) {
    for (const float value : position) result.push_back(bits(value));
  }
  return result;
}

std::vector<uint32_t> bits(const VkViewport& viewport) {
  return {bits(viewport.x),      bits(viewport.y),        bits(viewport.width),
          bits(viewport.height), bits(viewport.minDepth), bits(viewport.maxDepth)};
}

std::vector<uint32_t> bits(const VkRect2D& scissor) {
  return {static_cast<uint32_t>(scissor.offset.x), static_cast<uint32_t>(scissor.offset.y), scissor.extent.width,
          scissor.extent.height};
}

void expect_same_depth_state(const RasterState& a, const RasterState& b) {
  EXPECT_EQ(a.depth_test, b.depth_test);
  EXPECT_EQ(a.depth_write, b.depth_write);
  EXPECT_EQ(a.depth_compare, b.depth_compare);
  const DepthBias none{};
  EXPECT_EQ(a.depth_bias.has_value(), b.depth_bias.has_value());
  EXPECT_EQ(bits(a.depth_bias.value_or(none).constant_factor), bits(b.depth_bias.value_or(none).constant_factor));
  EXPECT_EQ(bits(a.depth_bias.value_or(none).slope_factor), bits(b.depth_bias.value_or(none).slope_factor));
  EXPECT_EQ(bits(a.depth_bias.value_or(none).clamp), bits(b.depth_bias.value_or(none).clamp));
  EXPECT_EQ(a.depth_bounds, b.depth_bounds);
  EXPECT_EQ(a.depth_clamp, b.depth_clamp);
  EXPECT_EQ(a.depth_clip, b.depth_clip);
  EXPECT_EQ(a.negative_one_to_one, b.negative_one_to_one);
}

void expect_same_state(const RasterState& a, const RasterState& b) {
  EXPECT_EQ(bits(a.viewport), bits(b.viewport));
  EXPECT_EQ(bits(a.scissor), bits(b.scissor));
  EXPECT_EQ(a.cull_mode, b.cull_mode);
  EXPECT_EQ(a.front_face, b.front_face);
  expect_same_depth_state(a, b);
  EXPECT_EQ(a.polygon_mode, b.polygon_mode);
  EXPECT_EQ(a.line_mode, b.line_mode);
  EXPECT_EQ(bits(a.line_width), bits(b.line_width));
  EXPECT_EQ(a.provoking_vertex, b.provoking_vertex);
  EXPECT_EQ(a.sample_mask, b.sample_mask);
}

void expect_same_draw(const Draw& a, const Draw& b) {
  EXPECT_EQ(a.topology, b.topology);
  EXPECT_EQ(a.indices, b.indices);
  EXPECT_EQ(a.index_type, b.index_type);
  EXPECT_EQ(a.vertex_offset, b.vertex_offset);
  EXPECT_EQ(a.primitive_restart, b.primitive_restart);
  EXPECT_EQ(bits(a.positions), bits(b.positions));
  EXPECT_EQ(bits(a.varyings), bits(b.varyings));
  EXPECT_EQ(bits(a.point_sizes), bits(b.point_sizes));
  EXPECT_EQ(a.clip_distance_count, b.clip_distance_count);
  EXPECT_EQ(a.cull_distance_count, b.cull_distance_count);
  EXPECT_EQ(bits(a.clip_distances), bits(b.clip_distances));
  EXPECT_EQ(bits(a.cull_distances), bits(b.cull_distances));
  expect_same_state(a.state, b.state);
}

void expect_same(const Case& a, const Case& b) {
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.why, b.why);
  EXPECT_EQ(a.spec, b.spec);
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.tags, b.tags);
  EXPECT_EQ(a.opt_outs, b.opt_outs);
  EXPECT_EQ(a.target.width, b.target.width);
  EXPECT_EQ(a.target.height, b.target.height);
  EXPECT_EQ(a.target.depth_format, b.target.depth_format);
  EXPECT_EQ(a.target.samples, b.target.samples);
  EXPECT_EQ(bits(a.target.clear_depth), bits(b.target.clear_depth));
  EXPECT_EQ(a.varyings, b.varyings);
  ASSERT_EQ(a.draws.size(), b.draws.size());
  for (size_t i = 0; i < a.draws.size(); ++i) {
    expect_same_draw(a.draws[i], b.draws[i]);
  }
}

class RandomCase {
 public:
  explicit RandomCase(uint32_t seed) : engine_(seed) {}

  Case make() {
    Case one{.title = text(), .why = text(), .spec = text(), .origin = text()};
    for (uint32_t i = number(3); i > 0; --i) one.tags.push_back(text());
    for (const auto check : kChecks) {
      if (number(3) == 0) one.opt_outs.push_back({.check = std::string(check), .reason = fmt::format("r{}", text())});
    }
    one.target.width = 1 + number(kMaxTargetSize);
    one.target.height = 1 + number(kMaxTargetSize);
    one.target.clear_depth = unit();
    one.target.depth_format = pick(kDepthFormats);
    one.target.samples = static_cast<VkSampleCountFlagBits>(1U << number(5));
    // gl_PointCoord is for points alone.
    const bool only_points = flip();
    // Names fall, so that a sorted table would show.
    for (uint32_t i = number(kMaxVaryings + 1); i > 0; --i) {
      one.varyings.push_back(make_varying(fmt::format("v{}", i), only_points));
    }
    const uint32_t components = vertex_component_count(one.varyings);
    for (uint32_t i = 1 + number(3); i > 0; --i) {
      const auto topology = only_points ? VK_PRIMITIVE_TOPOLOGY_POINT_LIST : pick(kTopologies);
      one.draws.push_back(make_draw(topology, components));
    }
    return one;
  }

 private:
  Varying make_varying(const std::string& name, bool only_points) {
    const auto source = pick(kVaryingSources);
    if (source == VaryingSource::kFragCoord) return {.name = name, .components = 4, .source = source};
    if (source == VaryingSource::kPointCoord && only_points) {
      return {.name = name, .components = 2, .source = source};
    }
    Varying varying{name, 1 + number(kMaxVaryingComponents), pick(kInterpolations)};
    if (varying.interpolation != Interpolation::kFlat) varying.sampling = pick(kSamplings);
    return varying;
  }

  RasterState make_state() {
    RasterState state{.cull_mode = pick(kCullModes), .front_face = pick(kFrontFaces)};
    state.viewport = {.x = 1000 * unit() - 500,
                      .y = -unit(),
                      .width = 0x1p-20F + 16000 * unit(),
                      .height = (flip() ? -1.0F : 1.0F) * (0x1p-20F + 16000 * unit()),
                      .minDepth = unit(),
                      .maxDepth = unit()};
    state.scissor = {.offset = {.x = static_cast<int32_t>(number(1U << 30U)), .y = 0},
                     .extent = {.width = number(1U << 30U), .height = 0x7FFFFFFFU}};
    state.depth_test = flip();
    state.depth_write = flip();
    state.depth_compare = pick(kCompareOps);
    if (flip())
      state.depth_bias = DepthBias{.constant_factor = finite(), .slope_factor = finite(), .clamp = finite()};
    if (flip()) state.depth_bounds = DepthBounds{.min = unit() / 2, .max = 0.5F + unit() / 2};
    state.depth_clamp = flip();
    state.depth_clip = flip();
    state.negative_one_to_one = flip();
    state.polygon_mode = pick(kPolygonModes);
    state.line_mode = pick(kLineModes);
    if (flip()) state.line_width = std::fabs(finite()) + 0x1p-149F;
    state.provoking_vertex = pick(kProvokingVertices);
    if (flip()) state.sample_mask = static_cast<uint32_t>(engine_());
    return state;
  }

  Draw make_draw(VkPrimitiveTopology topology, uint32_t components) {
    Draw draw{.topology = topology, .state = make_state()};
    const uint32_t vertices = 1 + number(12);
    for (uint32_t i = 0; i < vertices; ++i) draw.positions.push_back({any(), any(), any(), any()});
    for (uint32_t i = 0; i < vertices * components; ++i) draw.varyings.push_back(any());
    for (uint32_t i = flip() ? vertices : 0; i > 0; --i) draw.point_sizes.push_back(std::fabs(finite()) + 0x1p-149F);
    draw.clip_distance_count = number(kMaxClipAndCullDistances + 1);
    draw.cull_distance_count = number(kMaxClipAndCullDistances + 1 - draw.clip_distance_count);
    for (uint32_t i = 0; i < vertices * draw.clip_distance_count; ++i) draw.clip_distances.push_back(any());
    for (uint32_t i = 0; i < vertices * draw.cull_distance_count; ++i) draw.cull_distances.push_back(any());
    if (flip()) make_indices(vertices, draw);
    return draw;
  }

  void make_indices(uint32_t vertices, Draw& draw) {
    draw.index_type = pick(kIndexTypes);
    const bool list = draw.topology == VK_PRIMITIVE_TOPOLOGY_POINT_LIST ||
                      draw.topology == VK_PRIMITIVE_TOPOLOGY_LINE_LIST ||
                      draw.topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    draw.primitive_restart = !list && flip();
    const uint32_t first = number(100);  // the index of vertex 0
    draw.vertex_offset = -static_cast<int32_t>(first);
    draw.indices.emplace();
    for (uint32_t i = 1 + number(9); i > 0; --i) {
      const bool restarts = draw.primitive_restart && number(4) == 0;
      draw.indices->push_back(restarts ? restart_index(draw.index_type) : first + number(vertices));
    }
  }

  uint32_t number(uint32_t below) { return static_cast<uint32_t>(engine_() % below); }
  bool flip() { return number(2) == 0; }
  float unit() { return static_cast<float>(number(1U << 24U)) * 0x1p-24F; }
  // Any bits, and often the special ones.
  float any() {
    constexpr std::array<uint32_t, 10> kSpecial{0x00000000, 0x80000000, 0x7F800000, 0xFF800000, 0x7FC00000,
                                                0xFFC00000, 0x7F800001, 0x00000001, 0x807FFFFF, 0x7F7FFFFF};
    return std::bit_cast<float>(number(4) == 0 ? kSpecial[number(kSpecial.size())]
                                               : static_cast<uint32_t>(engine_()));
  }
  float finite() {
    const float value = any();
    return std::isfinite(value) ? value : 0.0F;
  }
  std::string text() {
    std::string result = "t";
    for (uint32_t i = number(12); i > 0; --i) result += static_cast<char>(1 + number(127));
    return result + "\xC3\xA4";
  }
  template <typename T, size_t N>
  T pick(const std::array<EnumName<T>, N>& names) {
    return names[number(N)].value;
  }

  std::mt19937 engine_;
};

TEST(Writer, WhatIsWrittenReadsBackToTheBit) {
  const uint32_t first_seed = std::random_device()();
  for (uint32_t i = 0; i < 500; ++i) {
    SCOPED_TRACE(fmt::format("seed {}", first_seed + i));
    const Case one = RandomCase(first_seed + i).make();
    const std::string written = write(one);
    const CaseFile file = parse(written, "written.toml", "written");
    for (const Error& error : file.errors) ADD_FAILURE() << to_string(error);
    ASSERT_EQ(file.cases.size(), 1U) << written;
    expect_same(file.cases[0], one);
    EXPECT_EQ(write(file.cases[0]), written);
    if (HasFailure()) break;
  }
}

TEST(Writer, ManyFloatsReadBackToTheBit) {
  const uint32_t seed = std::random_device()();
  SCOPED_TRACE(fmt::format("seed {}", seed));
  std::mt19937 engine(seed);
  const auto any = [&] { return std::bit_cast<float>(static_cast<uint32_t>(engine())); };
  Case one = case_of(kDraw);
  for (int i = 0; i < 50000; ++i) one.draws.at(0).positions.push_back({any(), any(), any(), any()});
  const CaseFile file = parse(write(one), "written.toml", "written");
  for (const Error& error : file.errors) ADD_FAILURE() << to_string(error);
  ASSERT_EQ(file.cases.size(), 1U);
  EXPECT_TRUE(bits(file.cases[0].draws.at(0).positions) == bits(one.draws.at(0).positions));
}

TEST(Writer, Text) {
  Case one = case_of(
      "tags = ['x', \"a\\\"b\\\\\\n\"]\nvaryings.c = 'flat'\nvaryings.uv = 'noperspective'\n[[draw]]\n"
      "positions = [[0.1, -0.0, nan, 'bits:0x7f800001'], [0, 0, inf, 1e-45]]\nindices = [1, 0]\n"
      "varyings = { c = [3, 4], uv = [[0, 1], [1, 0]] }\n");
  EXPECT_EQ(write(one), R"(title = "t"
why = "w"
spec = "s"
origin = "constructed"
tags = ["x", "a\"b\\\n"]

[target]
size = [64, 64]
depth_format = "d32_sfloat"
samples = 1
clear_depth = 1

[varyings]
c = { components = 1, interpolation = "flat" }
uv = { components = 2, interpolation = "noperspective" }

[[draw]]
topology = "triangle_list"
positions = [
  [0.1, -0.0, nan, "bits:0x7f800001"],
  [0, 0, inf, 1e-45],
]
indices = [1, 0]

[draw.state]
cull_mode = "none"
front_face = "counter_clockwise"
depth_test = false
depth_write = true
depth_compare = "less"
viewport = { x = 0, y = 0, width = 64, height = 64, min_depth = 0, max_depth = 1 }
scissor = { x = 0, y = 0, width = 64, height = 64 }

[draw.varyings]
c = [
  3,
  4,
]
uv = [
  [0, 1],
  [1, 0],
]
)");
}

}  // namespace
}  // namespace fillrule::format
