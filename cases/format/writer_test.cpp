#include "cases/format/writer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <bit>
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

std::vector<uint32_t> bits(const RasterState& state) {
  const VkViewport& viewport = state.viewport;
  const VkRect2D& scissor = state.scissor;
  return {state.cull_mode,
          static_cast<uint32_t>(state.front_face),
          static_cast<uint32_t>(state.depth_test),
          static_cast<uint32_t>(state.depth_write),
          static_cast<uint32_t>(state.depth_compare),
          bits(viewport.x),
          bits(viewport.y),
          bits(viewport.width),
          bits(viewport.height),
          bits(viewport.minDepth),
          bits(viewport.maxDepth),
          static_cast<uint32_t>(scissor.offset.x),
          static_cast<uint32_t>(scissor.offset.y),
          scissor.extent.width,
          scissor.extent.height};
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
    EXPECT_EQ(a.draws[i].topology, b.draws[i].topology);
    EXPECT_EQ(a.draws[i].indices, b.draws[i].indices);
    EXPECT_EQ(bits(a.draws[i].state), bits(b.draws[i].state));
    EXPECT_EQ(bits(a.draws[i].positions), bits(b.draws[i].positions));
    EXPECT_EQ(bits(a.draws[i].varyings), bits(b.draws[i].varyings));
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
    // Names fall, so that a sorted table would show.
    for (uint32_t i = number(kMaxVaryings + 1); i > 0; --i) {
      one.varyings.push_back({fmt::format("v{}", i), 1 + number(kMaxVaryingComponents), pick(kInterpolations)});
    }
    for (uint32_t i = 1 + number(3); i > 0; --i) one.draws.push_back(make_draw(component_count(one.varyings)));
    return one;
  }

 private:
  Draw make_draw(uint32_t components) {
    Draw draw{.topology = pick(kTopologies)};
    draw.state = {.cull_mode = pick(kCullModes),
                  .front_face = pick(kFrontFaces),
                  .depth_test = number(2) == 0,
                  .depth_write = number(2) == 0,
                  .depth_compare = pick(kCompareOps)};
    draw.state.viewport = {.x = 1000 * unit() - 500,
                           .y = -unit(),
                           .width = 0x1p-20F + 16000 * unit(),
                           .height = (number(2) == 0 ? -1.0F : 1.0F) * (0x1p-20F + 16000 * unit()),
                           .minDepth = unit(),
                           .maxDepth = unit()};
    draw.state.scissor = {.offset = {.x = static_cast<int32_t>(number(1U << 30U)), .y = 0},
                          .extent = {.width = number(1U << 30U), .height = 0x7FFFFFFFU}};
    const uint32_t vertices = 1 + number(12);
    for (uint32_t i = 0; i < vertices; ++i) draw.positions.push_back({any(), any(), any(), any()});
    for (uint32_t i = 0; i < vertices * components; ++i) draw.varyings.push_back(any());
    if (number(2) == 0) {
      draw.indices.emplace();
      for (uint32_t i = 1 + number(9); i > 0; --i) draw.indices->push_back(number(vertices));
    }
    return draw;
  }

  uint32_t number(uint32_t below) { return static_cast<uint32_t>(engine_() % below); }
  float unit() { return static_cast<float>(number(1U << 24U)) * 0x1p-24F; }
  // Any bits, and often the special ones.
  float any() {
    constexpr std::array<uint32_t, 10> kSpecial{0x00000000, 0x80000000, 0x7F800000, 0xFF800000, 0x7FC00000,
                                                0xFFC00000, 0x7F800001, 0x00000001, 0x807FFFFF, 0x7F7FFFFF};
    return std::bit_cast<float>(number(4) == 0 ? kSpecial[number(kSpecial.size())]
                                               : static_cast<uint32_t>(engine_()));
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
