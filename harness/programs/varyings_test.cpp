#include "harness/programs/varyings.h"

#include <gmock/gmock.h>

#include <bit>

namespace fillrule::programs {
namespace {

// Two draws of one triangle each over the whole of an 8x8 target, the second nearer.
Case two_draws() {
  Case drawn_case;
  drawn_case.target.width = 8;
  drawn_case.target.height = 8;
  drawn_case.varyings = {{"colour", 2, Interpolation::kSmooth},
                         {"linear", 1, Interpolation::kNoperspective},
                         {"id", 1, Interpolation::kFlat}};
  Draw draw;
  draw.state.viewport = {0, 0, 8, 8, 0, 1};
  draw.state.scissor = {{0, 0}, {8, 8}};
  draw.state.depth_test = true;
  // x from 0 to 16 px at w 1 and 2: 1/w = 1 - x/32.
  draw.positions = {{-1, -1, 0.5F, 1}, {6, -2, 1, 2}, {-1, 3, 0.5F, 1}};
  draw.varyings = {0, 5, 0, std::bit_cast<float>(0x7FC00001U), 1, 5, 1, 0, 0, 5, 0, 0};
  drawn_case.draws = {draw, draw};
  for (ClipPosition& position : drawn_case.draws[1].positions) {
    position[2] /= 2;
  }
  return drawn_case;
}

TEST(DrawCase, WritesEveryPlaneOfTheOutputContract) {
  const Result<Planes> planes = draw_case(two_draws(), {});
  ASSERT_TRUE(planes) << to_string(planes.error());
  EXPECT_THAT(planes->hits, ::testing::Each(2));
  EXPECT_THAT(planes->owner, ::testing::Each(1));
  EXPECT_THAT(planes->front_facing, ::testing::Each(0));
  EXPECT_THAT(planes->depth, ::testing::Each(0.25F));
  ASSERT_EQ(planes->varyings.size(), 4U);
  EXPECT_THAT(planes->varyings[1], ::testing::Each(5.0F));
  for (uint32_t x = 0; x < 8; ++x) {
    const double window_fraction = (x + 0.5) / 16;
    EXPECT_FLOAT_EQ(planes->varyings[0][x], static_cast<float>(window_fraction / 2 / (1 - window_fraction / 2)));
    EXPECT_FLOAT_EQ(planes->varyings[2][x], static_cast<float>(window_fraction));
    EXPECT_EQ(std::bit_cast<uint32_t>(planes->varyings[3][x]), 0x7FC00001U);
  }
}

TEST(DrawCase, ClearedWhereNothingLands) {
  Case drawn_case = two_draws();
  drawn_case.target.clear_depth = 0.125F;
  const Result<Planes> planes = draw_case(drawn_case, {});
  ASSERT_TRUE(planes);
  EXPECT_THAT(planes->hits, ::testing::Each(0));
  EXPECT_THAT(planes->owner, ::testing::Each(kNoOwner));
  EXPECT_THAT(planes->depth, ::testing::Each(0.125F));
  EXPECT_THAT(planes->varyings[1], ::testing::Each(0.0F));
}

TEST(DrawCase, AFixedPointDepthIsClearedToACode) {
  Case drawn_case = two_draws();
  drawn_case.target.depth_format = VK_FORMAT_D16_UNORM;
  drawn_case.target.clear_depth = 0.1F;
  const Result<Planes> planes = draw_case(drawn_case, {});
  ASSERT_TRUE(planes) << to_string(planes.error());
  EXPECT_THAT(planes->depth, ::testing::Each(static_cast<float>(6554 / 65535.0)));
}

TEST(DrawCase, WithoutADepthAttachmentThereIsNoDepthPlane) {
  Case drawn_case = two_draws();
  drawn_case.target.depth_format = VK_FORMAT_UNDEFINED;
  const Result<Planes> planes = draw_case(drawn_case, {});
  ASSERT_TRUE(planes);
  EXPECT_THAT(planes->depth, ::testing::IsEmpty());
  EXPECT_THAT(planes->hits, ::testing::Each(2));
}

TEST(DrawCase, OwnersCountOverAllDrawsWithIndices) {
  Case drawn_case = two_draws();
  drawn_case.draws[0].indices = {{0, 1, 2, 2, 1, 0, 0}};
  const Result<Planes> planes = draw_case(drawn_case, {});
  ASSERT_TRUE(planes);
  EXPECT_THAT(planes->owner, ::testing::Each(2));
}

// The first draw is a strip of a left and, after a restart, a right half of the target; only the offset finds its
// vertices.
TEST(DrawCase, RestartOffsetAndProvokingVertex) {
  Case drawn_case = two_draws();
  drawn_case.varyings = {{"id", 1, Interpolation::kFlat}};
  Draw& draw = drawn_case.draws[0];
  draw.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  draw.positions = {{0, 0, 0, 1},    {-1, -1, 0.5F, 1}, {-1, 1, 0.5F, 1}, {0, -1, 0.5F, 1},
                    {0, 1, 0.5F, 1}, {1, -1, 0.5F, 1},  {1, 1, 0.5F, 1}};
  draw.varyings = {0, 1, 2, 3, 4, 5, 6};
  draw.indices = {{0, 1, 2, 3, 0xFF, 2, 3, 4, 5}};
  draw.index_type = VK_INDEX_TYPE_UINT8_EXT;
  draw.primitive_restart = true;
  draw.vertex_offset = 1;
  drawn_case.draws[1].varyings = {0, 0, 0};
  drawn_case.draws[1].state.depth_compare = VK_COMPARE_OP_NEVER;
  const auto ids = [&](VkProvokingVertexModeEXT mode) {
    draw.state.provoking_vertex = mode;
    const Result<Planes> planes = draw_case(drawn_case, {});
    EXPECT_TRUE(planes) << to_string(planes.error());
    EXPECT_THAT(planes->hits, ::testing::Each(1));
    EXPECT_THAT(planes->front_facing, ::testing::Each(1));
    // A pixel of each of the four triangles.
    const std::array<size_t, 4> pixels{2 * 8 + 1, 5 * 8 + 3, 2 * 8 + 4, 5 * 8 + 7};
    for (uint32_t primitive = 0; primitive < 4; ++primitive) {
      EXPECT_EQ(planes->owner[pixels[primitive]], primitive);
    }
    return std::vector<float>{planes->varyings[0][pixels[0]], planes->varyings[0][pixels[1]],
                              planes->varyings[0][pixels[2]], planes->varyings[0][pixels[3]]};
  };
  EXPECT_THAT(ids(VK_PROVOKING_VERTEX_MODE_FIRST_VERTEX_EXT), ::testing::ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(ids(VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT), ::testing::ElementsAre(3, 4, 5, 6));
}

TEST(DrawCase, FragCoordStandsBetweenVertexVaryings) {
  Case drawn_case = two_draws();
  drawn_case.draws.pop_back();
  drawn_case.varyings = {{"first", 1, Interpolation::kFlat},
                         {"at", 4, Interpolation::kSmooth, Sampling::kCenter, VaryingSource::kFragCoord},
                         {"second", 1, Interpolation::kFlat}};
  Draw& draw = drawn_case.draws[0];
  draw.varyings = {7, 8, 0, 0, 0, 0};
  draw.state.depth_bias = DepthBias{.constant_factor = 0x1p22F};
  draw.state.viewport.maxDepth = 0.75F;
  Result<Planes> planes = draw_case(drawn_case, {});
  ASSERT_TRUE(planes) << to_string(planes.error());
  const size_t pixel = size_t{2} * 8 + 3;
  EXPECT_EQ(planes->varyings[0][pixel], 7);
  EXPECT_EQ(planes->varyings[1][pixel], 3.5F);
  EXPECT_EQ(planes->varyings[2][pixel], 2.5F);
  EXPECT_EQ(planes->varyings[3][pixel], 0.375F + 0.125F);  // of 3/8 the exponent is -2, so 2^-25 is added 2^22 times
  EXPECT_EQ(planes->varyings[4][pixel], 1 - 3.5F / 32);
  EXPECT_EQ(planes->varyings[5][pixel], 8);
  // At samples, if another varying asks for them.
  drawn_case.target.samples = VK_SAMPLE_COUNT_4_BIT;
  drawn_case.varyings[2] = {"second", 1, Interpolation::kSmooth, Sampling::kSample};
  planes = draw_case(drawn_case, {});
  ASSERT_TRUE(planes) << to_string(planes.error());
  EXPECT_EQ(planes->varyings[1][4 * pixel + 1], 3.875F);
  EXPECT_EQ(planes->varyings[2][4 * pixel + 1], 2.375F);
  EXPECT_EQ(planes->varyings[4][4 * pixel + 1], 1 - 3.875F / 32);
}

TEST(DrawCase, PointCoordGoesFromTheLeftTopOfThePoint) {
  Case drawn_case = two_draws();
  drawn_case.draws.pop_back();
  drawn_case.varyings = {{"at", 2, Interpolation::kSmooth, Sampling::kCenter, VaryingSource::kPointCoord},
                         {"value", 1, Interpolation::kSmooth}};
  Draw& draw = drawn_case.draws[0];
  draw.topology = VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
  draw.positions = {{0, 0, 0.5F, 1}};  // the middle of 8x8 pixels
  draw.varyings = {7};
  draw.point_sizes = {4};
  Result<Planes> planes = draw_case(drawn_case, {});
  ASSERT_TRUE(planes) << to_string(planes.error());
  const size_t pixel = size_t{5} * 8 + 2;
  EXPECT_EQ(planes->hits[pixel], 1U);
  EXPECT_EQ(planes->varyings[0][pixel], 0.125F);
  EXPECT_EQ(planes->varyings[1][pixel], 0.875F);
  EXPECT_EQ(planes->varyings[2][pixel], 7);
  // At samples where it is asked for there.
  drawn_case.target.samples = VK_SAMPLE_COUNT_4_BIT;
  drawn_case.varyings[0].sampling = Sampling::kSample;
  planes = draw_case(drawn_case, {});
  ASSERT_TRUE(planes) << to_string(planes.error());
  EXPECT_EQ(planes->varyings[0][4 * pixel + 1], 0.875F / 4);
  EXPECT_EQ(planes->varyings[1][4 * pixel + 1], 3.375F / 4);
  // Nothing else has one.
  draw.topology = VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
  draw.positions = {{-1, 0, 0.5F, 1}, {1, 0, 0.5F, 1}};
  draw.varyings = {7, 7};
  draw.point_sizes.clear();
  planes = draw_case(drawn_case, {});
  ASSERT_TRUE(planes) << to_string(planes.error());
  EXPECT_EQ(planes->hits[4 * pixel], 0U);
  EXPECT_EQ(planes->varyings[0], std::vector<float>(planes->hits.size()));
}

// The window's x as a varying of each kind: where it was evaluated.
TEST(DrawCase, EveryKindOfSamplingWritesAllSamplesOfItsFragment) {
  Case drawn_case = two_draws();
  drawn_case.draws.pop_back();
  drawn_case.target.samples = VK_SAMPLE_COUNT_4_BIT;
  Draw& draw = drawn_case.draws[0];
  draw.state.sample_mask = 0xD;
  drawn_case.varyings = {{"centre", 1, Interpolation::kNoperspective},
                         {"centroid", 1, Interpolation::kNoperspective, Sampling::kCentroid}};
  draw.positions = {{-1, -1, 0.5F, 1}, {3, -1, 0.5F, 1}, {-1, 3, 0.5F, 1}};
  draw.varyings = {0, 0, 16, 16, 0, 0};
  Result<Planes> planes = draw_case(drawn_case, {});
  ASSERT_TRUE(planes) << to_string(planes.error());
  const auto of_pixel = [](const auto& plane, size_t pixel) {
    return std::vector(plane.begin() + static_cast<ptrdiff_t>(4 * pixel),
                       plane.begin() + static_cast<ptrdiff_t>(4 * pixel + 4));
  };
  using ::testing::ElementsAre;
  EXPECT_THAT(of_pixel(planes->hits, 2), ElementsAre(1, 0, 1, 1));
  EXPECT_THAT(of_pixel(planes->owner, 2), ElementsAre(0, kNoOwner, 0, 0));
  EXPECT_THAT(of_pixel(planes->depth, 2), ElementsAre(0.5F, 1, 0.5F, 0.5F));
  EXPECT_THAT(of_pixel(planes->varyings[0], 2), ElementsAre(2.5F, 0, 2.5F, 2.5F));
  EXPECT_THAT(of_pixel(planes->varyings[1], 2), ElementsAre(2.5F, 0, 2.5F, 2.5F));
  // Only the second and fourth sample of each pixel of the first column.
  draw.positions[0][0] = -1 + 0.5F / 4;
  draw.positions[2] = {-1 + 0.5F / 4, 1023, 0.5F, 1};
  draw.varyings = {0.5F, 0.5F, 16, 16, 0.5F, 0.5F};
  planes = draw_case(drawn_case, {});
  ASSERT_TRUE(planes);
  EXPECT_THAT(of_pixel(planes->hits, 0), ElementsAre(0, 0, 0, 1));
  EXPECT_NEAR(planes->varyings[0][3], 0.5, 1e-5);
  EXPECT_NEAR(planes->varyings[1][3], 0.875, 1e-5);
  drawn_case.varyings[1].sampling = Sampling::kSample;
  planes = draw_case(drawn_case, {});
  ASSERT_TRUE(planes);
  EXPECT_NEAR(planes->varyings[1][3], 0.625, 1e-5);
  EXPECT_NEAR(planes->varyings[1][4 * 2 + 2], 2.125, 1e-5);
}

TEST(DrawCase, RefusesWhatItCannotDraw) {
  const auto error_of = [](const auto& change) {
    Case drawn_case = two_draws();
    change(drawn_case);
    const Result<Planes> planes = draw_case(drawn_case, {});
    return planes ? std::string() : planes.error().what;
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(error_of([](Case& c) { c.target.samples = VK_SAMPLE_COUNT_64_BIT; }), HasSubstr("64 samples"));
  EXPECT_THAT(error_of([](Case& c) { c.target.depth_format = VK_FORMAT_S8_UINT; }), HasSubstr("depth format 127"));
  EXPECT_THAT(error_of([](Case& c) { c.target.width = 0; }), HasSubstr("0 x 8"));
  EXPECT_THAT(error_of([](Case& c) { c.draws[1].varyings.pop_back(); }), HasSubstr("11 values"));
  EXPECT_THAT(error_of([](Case& c) { c.draws[1].indices = {{0, 1, 7}}; }), HasSubstr("index 7"));
  EXPECT_THAT(error_of([](Case& c) { c.varyings[0].components = 100; }), HasSubstr("102 components"));
}

}  // namespace
}  // namespace fillrule::programs
