// The planes of single cases against values worked out by hand.
#include "reference/vulkan/reference.h"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <limits>

#include "reference/vulkan/test_support.h"

namespace fillrule::vulkan {
namespace {

using testing::Each;

// Two triangles, (0, 0) (s, 0) (0, s) and its complement, that cover the viewport of s x s pixels.
std::vector<ClipPosition> quad_list(uint32_t s, float z = 0.5F) {
  const auto f = static_cast<float>(s);
  return {at(s, 0, 0, z), at(s, f, 0, z), at(s, 0, f, z), at(s, f, 0, z), at(s, f, f, z), at(s, 0, f, z)};
}

ClipPosition with_w(const ClipPosition& position, float w) {
  return {position[0] * w, position[1] * w, position[2] * w, w};
}

TEST(Reference, DrawsOneTriangle) {
  // The edge from (8.5, 0) to (0, 8.5) passes between pixel centres.
  Case drawn = empty_case(16);
  drawn.draws = {draw_of(drawn, {at(16, 0, 0), at(16, 8.5F, 0), at(16, 0, 8.5F)})};
  const Planes planes = draw_one(drawn);
  ASSERT_EQ(planes.width, 16U);
  ASSERT_EQ(planes.height, 16U);
  EXPECT_TRUE(planes.varyings.empty());
  for (uint32_t y = 0; y < 16; ++y) {
    for (uint32_t x = 0; x < 16; ++x) {
      const bool inside = x + y < 8;
      const size_t i = pixel(planes, x, y);
      EXPECT_EQ(planes.hits[i], inside ? 1U : 0U) << x << ' ' << y;
      EXPECT_EQ(planes.owner[i], inside ? 0U : kNoOwner) << x << ' ' << y;
      EXPECT_EQ(planes.depth[i], 1.0F) << x << ' ' << y;  // no depth test, so nothing is written
    }
  }
}

TEST(Reference, InterpolatesEveryKind) {
  // Window barycentric coordinates of v1 and v2 at pixel (4, 2): b1 = 4.5 / 16, b2 = 2.5 / 16, b0 = 0.5625.
  Case drawn = empty_case(16, {{.name = "s", .interpolation = Interpolation::kSmooth},
                               {.name = "n", .interpolation = Interpolation::kNoperspective},
                               {.name = "f", .interpolation = Interpolation::kFlat}});
  drawn.draws = {draw_of(drawn,
                         {at(16, 0, 0, 0.25F), with_w(at(16, 16, 0, 0.75F), 2), with_w(at(16, 0, 16, 0.5F), 4)},
                         {0, 0, 7, 1, 1, 8, 0, 0, 9})};
  drawn.draws[0].state.depth_test = true;
  const Planes planes = draw_one(drawn);
  const size_t i = pixel(planes, 4, 2);
  ASSERT_EQ(planes.hits[i], 1U);
  ASSERT_EQ(planes.varyings.size(), 3U);
  EXPECT_NEAR(planes.depth[i], 0.4296875, 1e-6);
  EXPECT_NEAR(planes.varyings[0][i], 0.18947368421, 1e-6);  // (b1 / 2) / (b0 + b1 / 2 + b2 / 4)
  EXPECT_NEAR(planes.varyings[1][i], 0.28125, 1e-6);
  EXPECT_EQ(planes.varyings[2][i], 7.0F);
  // Beyond the triangle everything is cleared.
  const size_t outside = pixel(planes, 15, 15);
  EXPECT_EQ(planes.depth[outside], 1.0F);
  EXPECT_EQ(planes.varyings[1][outside], 0.0F);
}

TEST(Reference, TellsFrontFromBack) {
  Case drawn = empty_case(16);
  drawn.draws = {draw_of(drawn, quad_list(16))};  // clockwise on a y that points down
  EXPECT_THAT(draw_one(drawn).front_facing, Each(0U));
  drawn.draws[0].state.front_face = VK_FRONT_FACE_CLOCKWISE;
  EXPECT_THAT(draw_one(drawn).front_facing, Each(1U));
  drawn.draws[0].state.cull_mode = VK_CULL_MODE_FRONT_BIT;
  EXPECT_THAT(draw_one(drawn).hits, Each(0U));
}

TEST(Reference, CountsHitsAndKeepsTheLastOwner) {
  Case drawn = empty_case(16);
  drawn.draws = {draw_of(drawn, quad_list(16)), draw_of(drawn, quad_list(16)), draw_of(drawn, quad_list(16))};
  const Planes planes = draw_one(drawn);
  EXPECT_THAT(planes.hits, Each(3U));
  EXPECT_EQ(planes.owner[pixel(planes, 1, 1)], 4U);
  EXPECT_EQ(planes.owner[pixel(planes, 14, 14)], 5U);
}

TEST(Reference, AssemblesStripsFansAndIndices) {
  const std::vector<ClipPosition> corners = {at(16, 0, 0), at(16, 0, 16), at(16, 16, 0), at(16, 16, 16)};
  Case drawn = empty_case(16, {{.name = "f", .interpolation = Interpolation::kFlat}});
  const auto flat_values = [&](VkPrimitiveTopology topology, std::optional<std::vector<uint32_t>> indices) {
    drawn.draws = {draw_of(drawn, corners, {10, 11, 12, 13})};
    drawn.draws[0].topology = topology;
    drawn.draws[0].indices = std::move(indices);
    const Planes planes = draw_one(drawn);
    EXPECT_THAT(planes.hits, Each(1U));
    EXPECT_EQ(planes.owner[pixel(planes, 1, 1)], 0U);
    EXPECT_EQ(planes.owner[pixel(planes, 14, 14)], 1U);
    return std::pair(planes.varyings[0][pixel(planes, 1, 1)], planes.varyings[0][pixel(planes, 14, 14)]);
  };
  // The provoking vertex of primitive i is vertex i of a strip, i + 1 of a fan and 3 i of a list.
  EXPECT_EQ(flat_values(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, std::nullopt), std::pair(10.0F, 11.0F));
  EXPECT_EQ(flat_values(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN, {{1, 0, 2, 3}}), std::pair(10.0F, 12.0F));
  EXPECT_EQ(flat_values(VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, {{0, 1, 2, 3, 2, 1}}), std::pair(10.0F, 13.0F));
}

TEST(Reference, SetsTheStateOfEachDraw) {
  Case drawn = empty_case(16);
  drawn.target.clear_depth = 0.75F;
  drawn.draws = {draw_of(drawn, quad_list(16, 0.5F)), draw_of(drawn, quad_list(16, 0.25F)),
                 draw_of(drawn, quad_list(16, 0.25F)), draw_of(drawn, quad_list(16, 0.125F))};
  for (Draw& draw : drawn.draws) draw.state.depth_test = true;
  drawn.draws[0].state.scissor = {.offset = {2, 0}, .extent = {14, 16}};
  drawn.draws[1].state.depth_compare = VK_COMPARE_OP_GREATER;  // fails against 0.5 and against the clear
  drawn.draws[2].state.scissor = {.offset = {3, 0}, .extent = {2, 16}};
  drawn.draws[3].state.depth_write = false;
  drawn.draws[3].state.scissor = {.offset = {4, 0}, .extent = {2, 16}};
  const Planes planes = draw_one(drawn);
  const auto expect = [&](uint32_t x, uint32_t hits, uint32_t owner, float depth) {
    const size_t i = pixel(planes, x, 1);
    EXPECT_EQ(planes.hits[i], hits) << x;
    EXPECT_EQ(planes.owner[i], owner) << x;
    EXPECT_EQ(planes.depth[i], depth) << x;
  };
  expect(1, 0, kNoOwner, 0.75F);
  expect(2, 1, 0, 0.5F);
  expect(3, 2, 4, 0.25F);
  expect(4, 3, 6, 0.25F);
  expect(5, 2, 6, 0.5F);
}

TEST(Reference, AppliesTheViewport) {
  Case drawn = empty_case(16);
  drawn.draws = {draw_of(drawn, quad_list(16, 0.5F))};
  drawn.draws[0].state.viewport = {.x = 4, .y = 2, .width = 8, .height = 10, .minDepth = 0.75F, .maxDepth = 0.25F};
  drawn.draws[0].state.depth_test = true;
  drawn.draws[0].state.scissor = {.offset = {0, 0}, .extent = {16, 8}};
  const Planes planes = draw_one(drawn);
  for (uint32_t y = 0; y < 16; ++y) {
    for (uint32_t x = 0; x < 16; ++x) {
      const bool inside = x >= 4 && x < 12 && y >= 2 && y < 8;
      EXPECT_EQ(planes.hits[pixel(planes, x, y)], inside ? 1U : 0U) << x << ' ' << y;
      EXPECT_EQ(planes.depth[pixel(planes, x, y)], inside ? 0.5F : 1.0F) << x << ' ' << y;
    }
  }
}

TEST(Reference, DrawsWithoutADepthAttachment) {
  Case drawn = empty_case(16);
  drawn.target.depth_format = VK_FORMAT_UNDEFINED;
  drawn.draws = {draw_of(drawn, quad_list(16))};
  const Planes planes = draw_one(drawn);
  EXPECT_THAT(planes.hits, Each(1U));
  EXPECT_TRUE(planes.depth.empty());
}

// A quad whose component k is k at the left edge and k + 1 at the right one; flat ones are k at the provoking vertex.
Case ramps(const std::vector<Varying>& varyings) {
  Case drawn = empty_case(16, varyings);
  drawn.draws = {draw_of(drawn, quad_list(16))};
  drawn.draws[0].topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  drawn.draws[0].positions = {at(16, 0, 0), at(16, 0, 16), at(16, 16, 0), at(16, 16, 16)};
  const uint32_t components = component_count(varyings);
  for (uint32_t vertex = 0; vertex < 4; ++vertex) {
    for (uint32_t k = 0; k < components; ++k) {
      drawn.draws[0].varyings.push_back(static_cast<float>(k + (vertex < 2 ? 0U : 1U)));
    }
  }
  return drawn;
}

void expect_ramps(const Planes& planes, const std::vector<Varying>& varyings) {
  ASSERT_EQ(planes.varyings.size(), component_count(varyings));
  const uint32_t x = 10;
  size_t k = 0;
  for (const Varying& varying : varyings) {
    for (uint32_t i = 0; i < varying.components; ++i, ++k) {
      const bool is_flat = varying.interpolation == Interpolation::kFlat;
      const float expected = static_cast<float>(k) + (is_flat ? 0.0F : (x + 0.5F) / 16);
      EXPECT_NEAR(planes.varyings[k][pixel(planes, x, 3)], expected, 1e-5) << varying.name << ' ' << i;
    }
  }
}

TEST(Reference, TakesMoreSlotsThanOnePassHas) {
  using enum Interpolation;
  for (const auto& kinds :
       {std::array{kSmooth, kSmooth, kSmooth}, std::array{kFlat, kFlat, kFlat},
        std::array{kNoperspective, kNoperspective, kNoperspective}, std::array{kFlat, kSmooth, kNoperspective}}) {
    std::vector<Varying> varyings;
    for (size_t i = 0; i < kMaxVaryings; ++i) {
      varyings.push_back({.name = "v", .components = 4, .interpolation = kinds[i % 3]});
    }
    expect_ramps(draw_one(ramps(varyings)), varyings);
  }
}

TEST(Reference, KeepsTheOrderOfOddlySizedVaryings) {
  const std::vector<Varying> varyings = {
      {.name = "a", .components = 3, .interpolation = Interpolation::kFlat},
      {.name = "b", .components = 1, .interpolation = Interpolation::kSmooth},
      {.name = "c", .components = 3, .interpolation = Interpolation::kNoperspective},
      {.name = "d", .components = 2, .interpolation = Interpolation::kSmooth},
      {.name = "e", .components = 3, .interpolation = Interpolation::kNoperspective},
      {.name = "f", .components = 3, .interpolation = Interpolation::kSmooth},
      {.name = "g", .components = 2, .interpolation = Interpolation::kFlat},
      {.name = "h", .components = 1, .interpolation = Interpolation::kNoperspective}};
  expect_ramps(draw_one(ramps(varyings)), varyings);
}

TEST(Reference, HandsFlatBitsThrough) {
  const std::array<uint32_t, 6> bits = {0x7FC12345U, 0xFFC00001U, 0x80000000U, 0x00000001U, 0x807FFFFFU, 0x7F800000U};
  Case drawn = empty_case(16);
  for (size_t i = 0; i < bits.size(); ++i) {
    drawn.varyings.push_back({.name = "v", .interpolation = Interpolation::kFlat});
  }
  std::vector<float> values;
  for (uint32_t vertex = 0; vertex < 6; ++vertex) {
    for (const uint32_t value : bits) values.push_back(std::bit_cast<float>(value));
  }
  drawn.draws = {draw_of(drawn, quad_list(16), values)};
  const Planes planes = draw_one(drawn);
  for (size_t i = 0; i < bits.size(); ++i) {
    EXPECT_EQ(std::bit_cast<uint32_t>(planes.varyings[i][pixel(planes, 5, 5)]), bits[i]) << i;
  }
}

TEST(Reference, DrawsNothingOutOfNothing) {
  Case drawn = empty_case(16);
  EXPECT_THAT(draw_one(drawn).hits, Each(0U));
  drawn.draws = {draw_of(drawn, {}), draw_of(drawn, {at(16, 0, 0), at(16, 16, 0)}), draw_of(drawn, quad_list(16)),
                 draw_of(drawn, quad_list(16))};
  drawn.draws[2].indices.emplace();
  const Planes planes = draw_one(drawn);
  EXPECT_THAT(planes.hits, Each(1U));
  EXPECT_EQ(planes.owner[0], 0U);
}

TEST(Reference, SurvivesPositionsThatAreNoNumbers) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  Case drawn = empty_case(16);
  drawn.draws = {draw_of(drawn, {{nan, 0, 0, 1}, at(16, 16, 0), at(16, 0, 16)}),
                 draw_of(drawn, {{inf, -inf, inf, inf}, at(16, 16, 0), at(16, 0, 16)}),
                 draw_of(drawn, {{0, 0, 0, nan}, {0, 0, 0, 0}, {0, 0, 0, 0}}), draw_of(drawn, quad_list(16))};
  const Planes planes = draw_one(drawn);
  EXPECT_EQ(planes.owner[pixel(planes, 14, 14)], 4U);
}

}  // namespace
}  // namespace fillrule::vulkan
