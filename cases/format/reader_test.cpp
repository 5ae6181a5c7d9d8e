// What each keyword does.
#include "cases/format/reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <limits>

#include "cases/format/test_files.h"
#include "cases/model/temporary_folder.h"

namespace fillrule::format {
namespace {

using ::testing::ElementsAre;

std::vector<uint32_t> bits_of(const std::vector<float>& values) {
  std::vector<uint32_t> bits;
  bits.reserve(values.size());
  for (const float value : values) bits.push_back(std::bit_cast<uint32_t>(value));
  return bits;
}

TEST(Reader, Head) {
  const CaseFile file = parse("title = 'a'\nwhy = 'b'\nspec = 'c'\norigin = 'd'\ntags = ['e', 'f']\n" + kDraw,
                              "folder/x.toml", "topic/x");
  ASSERT_EQ(file.cases.size(), 1U);
  const Case& one = file.cases[0];
  EXPECT_EQ(one.name, "topic/x");
  EXPECT_EQ(one.file, "folder/x.toml");
  EXPECT_EQ(one.title, "a");
  EXPECT_EQ(one.why, "b");
  EXPECT_EQ(one.spec, "c");
  EXPECT_EQ(one.origin, "d");
  EXPECT_THAT(one.tags, ElementsAre("e", "f"));
  EXPECT_EQ(case_of(kDraw).origin, "constructed");
}

TEST(Reader, TargetDefaults) {
  const Case one = case_of(kDraw);
  EXPECT_EQ(one.target.width, 64U);
  EXPECT_EQ(one.target.height, 64U);
  EXPECT_EQ(one.target.depth_format, VK_FORMAT_D32_SFLOAT);
  EXPECT_EQ(one.target.samples, VK_SAMPLE_COUNT_1_BIT);
  EXPECT_EQ(one.target.clear_depth, 1.0F);
}

TEST(Reader, Target) {
  const Case one = case_of(
      "[target]\nsize = [128, '2^5']\ndepth_format = 'd32_sfloat'\nsamples = 1\nclear_depth = 0.25\n" + kDraw);
  EXPECT_EQ(one.target.width, 128U);
  EXPECT_EQ(one.target.height, 32U);
  EXPECT_EQ(one.target.clear_depth, 0.25F);
}

TEST(Reader, StateDefaults) {
  const RasterState state = case_of("target.size = [128, 32]\n" + kDraw).draws.at(0).state;
  EXPECT_EQ(state.cull_mode, VkCullModeFlags{VK_CULL_MODE_NONE});
  EXPECT_EQ(state.front_face, VK_FRONT_FACE_COUNTER_CLOCKWISE);
  EXPECT_FALSE(state.depth_test);
  EXPECT_TRUE(state.depth_write);
  EXPECT_EQ(state.depth_compare, VK_COMPARE_OP_LESS);
  EXPECT_EQ(state.viewport.x, 0.0F);
  EXPECT_EQ(state.viewport.y, 0.0F);
  EXPECT_EQ(state.viewport.width, 128.0F);
  EXPECT_EQ(state.viewport.height, 32.0F);
  EXPECT_EQ(state.viewport.minDepth, 0.0F);
  EXPECT_EQ(state.viewport.maxDepth, 1.0F);
  EXPECT_EQ(state.scissor.offset.x, 0);
  EXPECT_EQ(state.scissor.offset.y, 0);
  EXPECT_EQ(state.scissor.extent.width, 128U);
  EXPECT_EQ(state.scissor.extent.height, 32U);
}

TEST(Reader, State) {
  const RasterState state =
      case_of(
          "[state]\ncull_mode = 'back'\nfront_face = 'clockwise'\ndepth_test = true\ndepth_write = false\n"
          "depth_compare = 'greater_or_equal'\n"
          "viewport = { x = -1.5, y = 2, width = 32, height = -16, min_depth = 1, max_depth = 0.5 }\n"
          "scissor = { x = 1, y = 2, width = 0, height = 4 }\n" +
          kDraw)
          .draws.at(0)
          .state;
  EXPECT_EQ(state.cull_mode, VkCullModeFlags{VK_CULL_MODE_BACK_BIT});
  EXPECT_EQ(state.front_face, VK_FRONT_FACE_CLOCKWISE);
  EXPECT_TRUE(state.depth_test);
  EXPECT_FALSE(state.depth_write);
  EXPECT_EQ(state.depth_compare, VK_COMPARE_OP_GREATER_OR_EQUAL);
  EXPECT_EQ(state.viewport.x, -1.5F);
  EXPECT_EQ(state.viewport.y, 2.0F);
  EXPECT_EQ(state.viewport.width, 32.0F);
  EXPECT_EQ(state.viewport.height, -16.0F);
  EXPECT_EQ(state.viewport.minDepth, 1.0F);
  EXPECT_EQ(state.viewport.maxDepth, 0.5F);
  EXPECT_EQ(state.scissor.offset.x, 1);
  EXPECT_EQ(state.scissor.offset.y, 2);
  EXPECT_EQ(state.scissor.extent.width, 0U);
  EXPECT_EQ(state.scissor.extent.height, 4U);
}

TEST(Reader, ADrawOverridesSingleKeysOfTheState) {
  const Case one = case_of("[state]\ncull_mode = 'back'\ndepth_test = true\n" + kDraw +
                           "state = { cull_mode = 'front', viewport = { x = 8 } }\n" + kDraw);
  ASSERT_EQ(one.draws.size(), 2U);
  EXPECT_EQ(one.draws[0].state.cull_mode, VkCullModeFlags{VK_CULL_MODE_FRONT_BIT});
  EXPECT_TRUE(one.draws[0].state.depth_test);
  EXPECT_EQ(one.draws[0].state.viewport.x, 8.0F);
  EXPECT_EQ(one.draws[0].state.viewport.width, 64.0F);
  EXPECT_EQ(one.draws[1].state.cull_mode, VkCullModeFlags{VK_CULL_MODE_BACK_BIT});
  EXPECT_EQ(one.draws[1].state.viewport.x, 0.0F);
}

TEST(Reader, VaryingsKeepTheOrderOfTheFile) {
  const Case one = case_of(
      "[varyings]\nzeta = { components = 2, interpolation = 'flat' }\nalpha = 'noperspective'\n"
      "mu = { interpolation = 'smooth' }\nnu = { components = 1 }\n[[draw]]\n"
      "positions = [[0, 0, 0, 1], [1, 0, 0, 1]]\n[draw.varyings]\n"
      "alpha = [7, 8]\nnu = [[9], 10]\nmu = [[1, 2, 3], [4, 5, 6]]\nzeta = [[11, 12], [13, 14]]\n");
  EXPECT_THAT(
      one.varyings,
      ElementsAre(Varying{"zeta", 2, Interpolation::kFlat}, Varying{"alpha", 1, Interpolation::kNoperspective},
                  Varying{"mu", 3, Interpolation::kSmooth}, Varying{"nu", 1, Interpolation::kSmooth}));
  EXPECT_THAT(one.draws.at(0).varyings, ElementsAre(11, 12, 7, 1, 2, 3, 9, 13, 14, 8, 4, 5, 6, 10));
}

TEST(Reader, TopologyAndIndices) {
  const Case one = case_of(kDraw + "topology = 'triangle_fan'\nindices = [0, '1 - 1', 0]\n" + kDraw);
  EXPECT_EQ(one.draws.at(0).topology, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN);
  EXPECT_EQ(one.draws.at(0).indices, (std::vector<uint32_t>{0, 0, 0}));
  EXPECT_EQ(one.draws.at(1).topology, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST);
  EXPECT_EQ(one.draws.at(1).indices, std::nullopt);
}

TEST(Reader, DepthFormatsAndSamples) {
  const std::vector<std::pair<std::string, VkFormat>> formats{{"none", VK_FORMAT_UNDEFINED},
                                                              {"d16_unorm", VK_FORMAT_D16_UNORM},
                                                              {"x8_d24_unorm_pack32", VK_FORMAT_X8_D24_UNORM_PACK32},
                                                              {"d32_sfloat", VK_FORMAT_D32_SFLOAT}};
  for (const auto& [name, format] : formats) {
    EXPECT_EQ(case_of(fmt::format("target.depth_format = '{}'\n", name) + kDraw).target.depth_format, format);
  }
  for (const uint32_t samples : {1U, 2U, 4U, 8U, 16U}) {
    const Case one = case_of(fmt::format("target.samples = {}\n", samples) + kDraw);
    EXPECT_EQ(static_cast<uint32_t>(one.target.samples), samples);
  }
}

TEST(Reader, DepthState) {
  const RasterState usual = case_of(kDraw).draws.at(0).state;
  EXPECT_FALSE(usual.depth_bias || usual.depth_bounds || usual.depth_clamp || usual.negative_one_to_one);
  EXPECT_TRUE(usual.depth_clip);
  const RasterState state =
      case_of(
          "[state]\ndepth_bias = { constant = 2, slope = -1.5, clamp = 0.25 }\n"
          "depth_bounds = { min = 0.25, max = 0.5 }\ndepth_clamp = true\nnegative_one_to_one = true\n" +
          kDraw)
          .draws.at(0)
          .state;
  EXPECT_EQ(state.depth_bias, (DepthBias{.constant_factor = 2, .slope_factor = -1.5F, .clamp = 0.25F}));
  EXPECT_EQ(state.depth_bounds, (DepthBounds{.min = 0.25F, .max = 0.5F}));
  EXPECT_TRUE(state.depth_clamp);
  EXPECT_TRUE(state.negative_one_to_one);
  const RasterState empty = case_of("[state]\ndepth_bias = {}\ndepth_bounds = {}\n" + kDraw).draws.at(0).state;
  EXPECT_EQ(empty.depth_bias, DepthBias{});
  EXPECT_EQ(empty.depth_bounds, DepthBounds{});
}

TEST(Reader, DepthClipFollowsDepthClampUnlessItIsGiven) {
  const auto clips = [](const std::string& state, const std::string& of_draw) {
    return case_of("state = {" + state + "}\n" + kDraw + "state = {" + of_draw + "}\n").draws.at(0).state.depth_clip;
  };
  EXPECT_FALSE(clips("depth_clamp = true", ""));
  EXPECT_TRUE(clips("depth_clamp = true, depth_clip = true", ""));
  EXPECT_FALSE(clips("depth_clip = false", ""));
  EXPECT_FALSE(clips("", "depth_clamp = true"));
  EXPECT_TRUE(clips("depth_clamp = true", "depth_clamp = false"));
  EXPECT_TRUE(clips("depth_clip = false, depth_clamp = false", "depth_clip = true"));
}

TEST(Reader, LinesPolygonsAndSamples) {
  const RasterState state = case_of(
                                "[state]\npolygon_mode = 'line'\nline_mode = 'bresenham'\nline_width = 1.5\n"
                                "provoking_vertex = 'last'\nsample_mask = 0xFFFFFFFE\n" +
                                kDraw)
                                .draws.at(0)
                                .state;
  EXPECT_EQ(state.polygon_mode, VK_POLYGON_MODE_LINE);
  EXPECT_EQ(state.line_mode, VK_LINE_RASTERIZATION_MODE_BRESENHAM_EXT);
  EXPECT_EQ(state.line_width, 1.5F);
  EXPECT_EQ(state.provoking_vertex, VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT);
  EXPECT_EQ(state.sample_mask, 0xFFFFFFFEU);
  const RasterState usual = case_of(kDraw).draws.at(0).state;
  EXPECT_EQ(usual.polygon_mode, VK_POLYGON_MODE_FILL);
  EXPECT_EQ(usual.line_mode, VK_LINE_RASTERIZATION_MODE_RECTANGULAR_EXT);
  EXPECT_EQ(usual.line_width, 1.0F);
  EXPECT_EQ(usual.provoking_vertex, VK_PROVOKING_VERTEX_MODE_FIRST_VERTEX_EXT);
  EXPECT_EQ(usual.sample_mask, 0xFFFFFFFFU);
}

TEST(Reader, SamplingAndBuiltIns) {
  const Case one = case_of(
      "[varyings]\na = { sampling = 'centroid' }\nwhere = { source = 'frag_coord' }\n"
      "b = { interpolation = 'noperspective', sampling = 'sample', source = 'vertices' }\n"
      "st = { source = 'point_coord' }\n"
      "[[draw]]\ntopology = 'point_list'\npositions = [[0, 0, 0, 1], [1, 0, 0, 1]]\n"
      "varyings = { a = [1, 2], b = [[3, 4], [5, 6]] }\n");
  EXPECT_THAT(one.varyings,
              ElementsAre(Varying{"a", 1, Interpolation::kSmooth, Sampling::kCentroid},
                          Varying{"where", 4, Interpolation::kSmooth, Sampling::kCenter, VaryingSource::kFragCoord},
                          Varying{"b", 2, Interpolation::kNoperspective, Sampling::kSample},
                          Varying{"st", 2, Interpolation::kSmooth, Sampling::kCenter, VaryingSource::kPointCoord}));
  EXPECT_THAT(one.draws.at(0).varyings, ElementsAre(1, 3, 4, 2, 5, 6));
}

TEST(Reader, PointCoordIsForPolygonsDrawnAsPointsToo) {
  const Case one = case_of("varyings.st = { source = 'point_coord' }\n" + kDraw + "state.polygon_mode = 'point'\n");
  EXPECT_EQ(one.varyings.at(0).components, 2U);
}

TEST(Reader, PointSizes) {
  EXPECT_TRUE(case_of(kDraw).draws.at(0).point_sizes.empty());
  const std::string two = "[[draw]]\npositions = [[0, 0, 0, 1], [1, 0, 0, 1]]\nrepeat = { i = 2 }\n";
  EXPECT_THAT(case_of(two + "point_sizes = [1.5, '2 + i']\n").draws.at(0).point_sizes, ElementsAre(1.5F, 2, 1.5F, 3));
  EXPECT_THAT(case_of(two + "point_sizes = '2 + i'\n").draws.at(0).point_sizes, ElementsAre(2, 2, 3, 3));
}

TEST(Reader, ClipAndCullDistances) {
  const Draw draw = case_of(
                        "[[draw]]\npositions = [[0, 0, 0, 1], [1, 0, 0, 1]]\nrepeat = { i = 2 }\n"
                        "clip_distances = [['i', -1, 2], [3, inf, -0.0]]\ncull_distances = [4, [-5]]\n")
                        .draws.at(0);
  EXPECT_EQ(draw.clip_distance_count, 3U);
  EXPECT_EQ(draw.cull_distance_count, 1U);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_THAT(draw.clip_distances, ElementsAre(0, -1, 2, 3, infinity, 0, 1, -1, 2, 3, infinity, 0));
  EXPECT_TRUE(std::signbit(draw.clip_distances.at(5)));
  EXPECT_THAT(draw.cull_distances, ElementsAre(4, -5, 4, -5));
  const Draw eight = case_of(kDraw + "clip_distances = [[1, 2, 3, 4, 5, 6, 7, 8]]\n").draws.at(0);
  EXPECT_EQ(eight.clip_distance_count, 8U);
  EXPECT_EQ(eight.cull_distance_count, 0U);
}

TEST(Reader, IndexTypesOffsetsAndRestarts) {
  const Draw usual = case_of(kDraw + "indices = [0]\n").draws.at(0);
  EXPECT_EQ(usual.index_type, VK_INDEX_TYPE_UINT32);
  EXPECT_EQ(usual.vertex_offset, 0);
  EXPECT_FALSE(usual.primitive_restart);
  const std::string strip = "[[draw]]\ntopology = 'line_strip'\npositions = [[0, 0, 0, 1], [1, 0, 0, 1]]\n";
  const Draw moved = case_of(strip + "indices = [7, 8]\nvertex_offset = -7\nindex_type = 'uint16'\n").draws.at(0);
  EXPECT_EQ(moved.index_type, VK_INDEX_TYPE_UINT16);
  EXPECT_EQ(moved.vertex_offset, -7);
  EXPECT_EQ(moved.indices, (std::vector<uint32_t>{7, 8}));
  // The restart index may be written as a number, is compared before the offset is added, and no copy moves it.
  const Draw restarts = case_of(strip +
                                "indices = [7, 'restart', 8, 255]\nvertex_offset = -7\nindex_type = 'uint8'\n"
                                "primitive_restart = true\nrepeat = { i = 2 }\n")
                            .draws.at(0);
  EXPECT_EQ(restarts.indices, (std::vector<uint32_t>{7, 255, 8, 255, 9, 255, 10, 255}));
  EXPECT_TRUE(restarts.primitive_restart);
}

TEST(Reader, TheLargestIndexIsAVertexUnlessItRestarts) {
  const std::string vertices = "[[draw]]\npositions = [[0, 0, 0, 1]]\nrepeat = { i = 256 }\nindex_type = 'uint8'\n";
  const Draw draw = case_of(vertices + "topology = 'triangle_strip'\nindices = [0]\n").draws.at(0);
  EXPECT_EQ(draw.indices->back(), 255U);
  EXPECT_EQ(element_runs(draw).size(), 1U);
}

TEST(Reader, PositionsOfEverySpace) {
  const Case one = case_of(
      "[[draw]]\npositions = [[1, 2, 3, 4]]\n"
      "[[draw]]\nspace = 'clip'\npositions = [[1, 2, 3, 4]]\n"
      "[[draw]]\nspace = 'ndc'\npositions = [[0.5, -0.5], [0.5, -0.5, 0.25], [0.5, -0.5, 0.25, 2]]\n"
      "[[draw]]\nspace = 'framebuffer'\npositions = [[16, 48], [16, 48, 0.25], [16, 48, 0.25, 2]]\n"
      "[[draw]]\nspace = 'framebuffer'\npositions = [[16, 48], [16, 48, 0.25, 2]]\n"
      "state.viewport = { x = 16, y = 16, width = 32, height = 32, min_depth = 0.2, max_depth = 0.3 }\n");
  using Positions = std::vector<ClipPosition>;
  EXPECT_EQ(one.draws.at(0).positions, (Positions{{1, 2, 3, 4}}));
  EXPECT_EQ(one.draws.at(1).positions, (Positions{{1, 2, 3, 4}}));
  const Positions expected{{0.5F, -0.5F, 0.5F, 1}, {0.5F, -0.5F, 0.25F, 1}, {1, -1, 0.5F, 2}};
  EXPECT_EQ(one.draws.at(2).positions, expected);
  const Positions of_framebuffer{{-0.5F, 0.5F, 0.5F, 1}, {-0.5F, 0.5F, 0.25F, 1}, {-1, 1, 0.5F, 2}};
  EXPECT_EQ(one.draws.at(3).positions, of_framebuffer);
  const double depth_ndc = (0.25 - double{0.2F}) / (double{0.3F} - double{0.2F});
  const Positions of_viewport{{-1, 1, 0.5F, 1}, {-2, 2, static_cast<float>(depth_ndc * 2.0), 2}};
  EXPECT_EQ(one.draws.at(4).positions, of_viewport);
}

TEST(Reader, ASubpixelIsExactInClipSpace) {
  for (int shift = -256; shift <= 256; ++shift) {
    const Case one =
        case_of(fmt::format("[[draw]]\nspace = 'framebuffer'\npositions = [['10.5 + ({})/256', 24.5]]\n", shift));
    const ClipPosition expected{static_cast<float>(10.5 + shift / 256.0) / 32.0F - 1.0F, -0.234375F, 0.5F, 1.0F};
    EXPECT_EQ(one.draws.at(0).positions.at(0), expected);
  }
}

TEST(Reader, EveryKindOfNumber) {
  const Case one = case_of(
      "varyings.v = 'flat'\n[[draw]]\npositions = [[nan, inf, -inf, -0.0], [0, 0, 0, 0], [0, 0, 0, 0]]\n"
      "varyings.v = [['0x1.8p-3', 'bits:0x7f800001', 'nan', '-inf'], ['-0', '1/3', 0.1, 1_000], "
      "['ulp(1, 1)', 'random(1, 2) < 1', '-nan', 1e-45]]\n");
  const ClipPosition& position = one.draws.at(0).positions.at(0);
  EXPECT_EQ(bits_of({position.begin(), position.end()}),
            (std::vector<uint32_t>{0x7FC00000, 0x7F800000, 0xFF800000, 0x80000000}));
  EXPECT_EQ(bits_of(one.draws.at(0).varyings),
            (std::vector<uint32_t>{0x3E400000, 0x7F800001, 0x7FC00000, 0xFF800000, 0x80000000, 0x3EAAAAAB, 0x3DCCCCCD,
                                   0x447A0000, 0x3F800001, 0x3F800000, 0xFFC00000, 0x00000001}));
}

TEST(Reader, NonFiniteVerticesSurviveTheirConversion) {
  const Case one = case_of("[[draw]]\nspace = 'framebuffer'\npositions = [[nan, inf], [0, 0, 0, -inf]]\n");
  const auto& positions = one.draws.at(0).positions;
  EXPECT_TRUE(std::isnan(positions.at(0)[0]));
  EXPECT_EQ(positions.at(0)[1], std::numeric_limits<float>::infinity());
  EXPECT_EQ(positions.at(1)[3], -std::numeric_limits<float>::infinity());
}

TEST(Reader, ReadsAFile) {
  const TemporaryFolder folder;
  const std::string path = folder.path("x.toml");
  std::ofstream(path) << kHead << kDraw;
  const CaseFile file = read_file(path, "x");
  ASSERT_EQ(file.errors.size(), 0U);
  ASSERT_EQ(file.cases.size(), 1U);
  EXPECT_EQ(file.cases[0].file, path);
  EXPECT_EQ(file.cases[0].name, "x");
}

TEST(Reader, AnEmptyFileIsReadAsOne) {
  const TemporaryFolder folder;
  const std::string path = folder.path("empty.toml");
  std::ofstream(path).close();
  const CaseFile file = read_file(path, "x");
  ASSERT_FALSE(file.errors.empty());
  EXPECT_EQ(file.errors[0].what, "missing key \"title\"");
}

}  // namespace
}  // namespace fillrule::format
