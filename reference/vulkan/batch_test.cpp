// Many cases in one call, cases that cannot be drawn among others, and both ways to number primitives.
#include <gmock/gmock.h>

#include <filesystem>
#include <random>

#include "reference/vulkan/test_support.h"

namespace fillrule::vulkan {
namespace {

using testing::HasSubstr;

constexpr std::array kTopologies = {VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
                                    VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN,  VK_PRIMITIVE_TOPOLOGY_LINE_LIST,
                                    VK_PRIMITIVE_TOPOLOGY_LINE_STRIP,    VK_PRIMITIVE_TOPOLOGY_POINT_LIST};

bool is_strip_or_fan(VkPrimitiveTopology topology) {
  return topology == VK_PRIMITIVE_TOPOLOGY_LINE_STRIP || topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP ||
         topology == VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN;
}

// Random primitives, clipped ones among them, in two draws. Deterministic for a seed.
Case random_case(uint32_t seed) {
  std::mt19937 random(seed);
  const auto number = [&](uint32_t low, uint32_t high) {
    return low + static_cast<uint32_t>(random() % (high - low + 1));
  };
  const auto real = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(random() >> 8U) / 16777216.0F;
  };
  Case drawn = empty_case(number(1, 70));
  drawn.target.height = number(1, 70);
  for (uint32_t i = number(0, 8); i > 0; --i) {
    drawn.varyings.push_back(
        {.name = "v", .components = number(1, 4), .interpolation = static_cast<Interpolation>(number(0, 2))});
  }
  for (uint32_t i = 0; i < 2; ++i) {
    std::vector<ClipPosition> positions(number(3, 12));
    for (ClipPosition& position : positions) {
      position = {real(-1.5F, 1.5F), real(-1.5F, 1.5F), real(0, 1), real(0.5F, 2)};
    }
    std::vector<float> varyings(positions.size() * component_count(drawn.varyings));
    for (float& value : varyings) value = real(-10, 10);
    drawn.draws.push_back(draw_of(drawn, positions, varyings));
    Draw& draw = drawn.draws.back();
    draw.topology = kTopologies[number(0, kTopologies.size() - 1)];
    draw.state.depth_test = number(0, 1) == 1;
    draw.state.polygon_mode = static_cast<VkPolygonMode>(number(0, 2));
    draw.state.provoking_vertex = static_cast<VkProvokingVertexModeEXT>(number(0, 1));
    if (number(0, 1) == 0) continue;
    draw.indices.emplace(number(0, 20));
    draw.vertex_offset = -static_cast<int32_t>(number(0, 5));
    for (uint32_t& index : *draw.indices) {
      index = number(0, static_cast<uint32_t>(positions.size()) - 1) - static_cast<uint32_t>(draw.vertex_offset);
    }
    draw.primitive_restart = is_strip_or_fan(draw.topology);
    for (uint32_t& index : *draw.indices) {
      if (draw.primitive_restart && number(0, 4) == 0) index = restart_index(draw.index_type);
    }
  }
  return drawn;
}

std::vector<Case> random_cases(uint32_t count) {
  std::vector<Case> cases;
  for (uint32_t i = 0; i < count; ++i) cases.push_back(random_case(i));
  return cases;
}

std::vector<Result<Planes>> draw_all(Reference& reference, const std::vector<Case>& cases) {
  std::vector<const Case*> pointers;
  pointers.reserve(cases.size());
  for (const Case& drawn : cases) pointers.push_back(&drawn);
  return reference.draw(pointers);
}

void expect_same(const std::vector<Result<Planes>>& a, const std::vector<Result<Planes>>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    ASSERT_TRUE(a[i] && b[i]) << i;
    EXPECT_TRUE(same_bytes(*a[i], *b[i])) << "case " << i;
  }
}

std::vector<Result<Planes>> draw_one_by_one(Reference& reference, const std::vector<Case>& cases) {
  std::vector<Result<Planes>> planes;
  planes.reserve(cases.size());
  for (const Case& drawn : cases) planes.emplace_back(draw_one(reference, drawn));
  return planes;
}

TEST(Batch, EqualsTheCasesDrawnOneByOne) {
  const std::vector<Case> cases = random_cases(60);
  const auto together = draw_all(shared_reference(), cases);
  expect_same(together, draw_one_by_one(shared_reference(), cases));
  expect_same(together, draw_all(shared_reference(), cases));
  expect_no_messages(shared_reference());
  const auto landed = std::ranges::count_if(together, [](const Result<Planes>& planes) {
    return std::ranges::any_of(planes->hits, [](uint32_t hits) { return hits > 0; });
  });
  EXPECT_GT(landed, 40);
}

TEST(Batch, IsSplitWhereMemoryIsShort) {
  Options options = validated_options();
  options.bytes_in_flight = 300000;  // some cases alone need more
  Reference reference = create_or_throw(options);
  const std::vector<Case> cases = random_cases(20);
  expect_same(draw_all(reference, cases), draw_all(shared_reference(), cases));
  expect_no_messages(reference);
}

TEST(Batch, NumbersPrimitivesAlikeOnBothWays) {
  Options options = validated_options();
  options.primitive_number = PrimitiveNumber::kProvokingVertex;
  Reference reference = create_or_throw(options);
  const std::vector<Case> cases = random_cases(60);
  expect_same(draw_all(reference, cases), draw_all(shared_reference(), cases));
  expect_no_messages(reference);
}

TEST(Batch, DrawsTheOthersWhereOneCannotBeDrawn) {
  std::vector<Case> cases = random_cases(5);
  cases[0].target.width = 20000;
  cases[2].target.width = 16384;
  cases[2].target.height = 16384;
  // Each buffer would be within the limits, but not all memory together.
  cases[4] = empty_case(8192, {{.name = "v"}});
  const auto results = draw_all(shared_reference(), cases);
  expect_no_messages(shared_reference());
  ASSERT_FALSE(results[0]);
  EXPECT_THAT(results[0].error().what, HasSubstr("target.size: 20000 x"));
  EXPECT_THAT(results[0].error().what, HasSubstr("beyond the 16384 pixels that lavapipe can draw to"));
  ASSERT_FALSE(results[2]);
  EXPECT_THAT(results[2].error().what, HasSubstr("target.size: drawing 16384 x 16384 pixels"));
  ASSERT_FALSE(results[4]);
  EXPECT_EQ(results[4].error().what,
            "target.size: drawing 8192 x 8192 pixels with 1 varying components takes 3584 MiB");
  EXPECT_EQ(results[4].error().hint, "lavapipe has 2048 MiB, and at most 4095 MiB for a buffer");
  ASSERT_TRUE(results[1]);
  ASSERT_TRUE(results[3]);
  EXPECT_TRUE(same_bytes(*results[3], draw_one(cases[3])));
}

TEST(Batch, OfNothingIsNothing) {
  EXPECT_TRUE(shared_reference().draw({}).empty());
}

// Needs the driver that ci/swiftshader fetches.
TEST(Swiftshader, DrawsLikeLavapipeOnItsOwnGrid) {
  const std::string manifest = FILLRULE_SOURCE_DIR "/build/swiftshader/vk_swiftshader_icd.json";
  if (!std::filesystem::exists(manifest)) GTEST_SKIP() << "SwiftShader is not here; ci/swiftshader fetches it";
  Options options = validated_options();
  options.driver = "swiftshader";
  options.driver_files = {manifest};
  Reference reference = create_or_throw(options);
  EXPECT_FALSE(reference.device().has_primitive_id);
  EXPECT_EQ(reference.device().subpixel_bits, 4U);

  // Vertices on multiples of 1/16 pixel inside the viewport: both drivers must cover the same pixels.
  std::mt19937 random(1);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same triangles on every run
  std::vector<Case> cases;
  for (int i = 0; i < 20; ++i) {
    Case drawn = empty_case(32, {{.name = "f", .interpolation = Interpolation::kFlat}});
    std::vector<ClipPosition> positions;
    std::vector<float> varyings;
    for (int vertex = 0; vertex < 9; ++vertex) {
      const auto coordinate = [&] { return static_cast<float>(random() % 513) / 16.0F; };
      positions.push_back(at(32, coordinate(), coordinate()));
      varyings.push_back(static_cast<float>(vertex));
    }
    drawn.draws = {draw_of(drawn, positions, varyings)};
    drawn.draws[0].topology = kTopologies[static_cast<size_t>(i) % 3];
    if (i % 2 == 1) drawn.draws[0].indices = {0, 1, 2, 8, 7, 6, 2, 3, 4, 5};
    cases.push_back(drawn);
  }
  const auto swiftshader = draw_all(reference, cases);
  const auto lavapipe = draw_all(shared_reference(), cases);
  for (size_t i = 0; i < cases.size(); ++i) {
    ASSERT_TRUE(swiftshader[i]) << to_string(swiftshader[i].error());
    EXPECT_EQ(swiftshader[i]->hits, lavapipe[i]->hits) << i;
    EXPECT_EQ(swiftshader[i]->owner, lavapipe[i]->owner) << i;
    EXPECT_EQ(swiftshader[i]->front_facing, lavapipe[i]->front_facing) << i;
    EXPECT_EQ(swiftshader[i]->varyings, lavapipe[i]->varyings) << i;
  }
  expect_no_messages(reference);
}

}  // namespace
}  // namespace fillrule::vulkan
