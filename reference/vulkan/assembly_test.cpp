// What vertices become primitives, on each driver: topologies, indices, restart, provoking vertex, user distances.
#include <gmock/gmock.h>

#include <numeric>

#include "reference/vulkan/test_support.h"

namespace fillrule::vulkan {
namespace {

using testing::ElementsAre;

class Assembly : public OnEachDriver {};
INSTANTIATE_TEST_SUITE_P(Drivers, Assembly, testing::ValuesIn(kDrivers));

const Varying kId{.name = "id", .interpolation = Interpolation::kFlat};

// Points in pixels (x, 2) of a row, x = 2, 4, 6 ...; each with its number as flat value.
Case row_of_points(uint32_t count) {
  Case drawn = empty_case(16, {kId});
  std::vector<ClipPosition> positions;
  std::vector<float> ids;
  for (uint32_t i = 0; i < count; ++i) {
    positions.push_back(at(16, 2.5F + 2 * static_cast<float>(i), 2.5F));
    ids.push_back(static_cast<float>(i));
  }
  drawn.draws = {draw_of(drawn, positions, ids)};
  return drawn;
}

// Corners of squares of 4 x 4 pixels, side by side from the left, in the order of a strip: top left, bottom left, top
// right, bottom right of the first one, then the right two of the next one.
Case strip_of_squares(uint32_t squares) {
  Case drawn = empty_case(16, {kId});
  std::vector<ClipPosition> positions;
  std::vector<float> ids;
  for (uint32_t i = 0; i < 2 * (squares + 1); ++i) {
    const uint32_t x = i / 2 * 4;
    positions.push_back(at(16, static_cast<float>(x), i % 2 == 0 ? 0.0F : 4.0F));
    ids.push_back(static_cast<float>(i));
  }
  drawn.draws = {draw_of(drawn, positions, ids)};
  drawn.draws[0].topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
  return drawn;
}

// In the upper left and lower right triangle of each square.
template <typename T>
std::vector<T> in_halves(const Planes& planes, const std::vector<T>& plane, uint32_t squares) {
  std::vector<T> values;
  for (uint32_t i = 0; i < squares; ++i) {
    values.push_back(plane[pixel(planes, 4 * i, 1)]);
    values.push_back(plane[pixel(planes, 4 * i + 3, 3)]);
  }
  return values;
}

TEST_P(Assembly, DrawsPoints) {
  Case drawn = row_of_points(3);
  drawn.draws[0].topology = VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
  drawn.draws[0].indices = {2, 0, 1};
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  EXPECT_EQ(std::accumulate(planes->hits.begin(), planes->hits.end(), 0U), 3U);
  for (uint32_t i = 0; i < 3; ++i) {
    const size_t at_point = pixel(*planes, 2 + 2 * i, 2);
    EXPECT_EQ(planes->hits[at_point], 1U) << i;
    EXPECT_EQ(planes->owner[at_point], (i + 1) % 3) << i;
    EXPECT_EQ(planes->varyings[0][at_point], static_cast<float>(i)) << i;
    EXPECT_EQ(planes->front_facing[at_point], 1U) << i;
  }
}

TEST_P(Assembly, DrawsLineListsAndStrips) {
  Case drawn = row_of_points(5);
  Draw& draw_lines = drawn.draws[0];
  const auto owners = [&](VkPrimitiveTopology topology) {
    draw_lines.topology = topology;
    const auto planes = draw(drawn);
    std::vector<uint32_t> found;
    for (uint32_t x = 3; planes && x < 11; x += 2) found.push_back(planes->owner[pixel(*planes, x, 2)]);
    return found;
  };
  EXPECT_THAT(owners(VK_PRIMITIVE_TOPOLOGY_LINE_LIST), ElementsAre(0, kNoOwner, 1, kNoOwner));
  EXPECT_THAT(owners(VK_PRIMITIVE_TOPOLOGY_LINE_STRIP), ElementsAre(0, 1, 2, 3));
}

TEST_P(Assembly, TakesTheLastVertexAsProvoking) {
  const auto flats = [&](Case drawn, VkPrimitiveTopology topology, const std::vector<uint32_t>& xs, uint32_t y) {
    drawn.draws[0].topology = topology;
    drawn.draws[0].state.provoking_vertex = VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
    std::vector<float> found;
    const auto planes = draw(drawn);
    for (size_t i = 0; planes && i < xs.size(); ++i) {
      EXPECT_EQ(planes->owner[pixel(*planes, xs[i], y)], i) << topology;
      found.push_back(planes->varyings[0][pixel(*planes, xs[i], y)]);
    }
    return found;
  };
  EXPECT_THAT(flats(row_of_points(4), VK_PRIMITIVE_TOPOLOGY_LINE_LIST, {3, 7}, 2), ElementsAre(1, 3));
  EXPECT_THAT(flats(row_of_points(4), VK_PRIMITIVE_TOPOLOGY_LINE_STRIP, {3, 5, 7}, 2), ElementsAre(1, 2, 3));
  EXPECT_THAT(flats(strip_of_squares(2), VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP, {0, 3, 4, 7}, 2),
              ElementsAre(2, 3, 4, 5));
  Case triangles = strip_of_squares(2);
  triangles.draws[0].indices = {0, 1, 2, 1, 2, 3};
  EXPECT_THAT(flats(triangles, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, {0, 3}, 2), ElementsAre(2, 3));
  triangles.draws[0].indices = {1, 0, 2, 3};
  EXPECT_THAT(flats(triangles, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_FAN, {0, 3}, 2), ElementsAre(2, 3));
}

TEST_P(Assembly, RestartsStripsWithEveryIndexType) {
  for (const VkIndexType type : {VK_INDEX_TYPE_UINT8_EXT, VK_INDEX_TYPE_UINT16, VK_INDEX_TYPE_UINT32}) {
    Case drawn = strip_of_squares(3);
    Draw& strips = drawn.draws[0];
    const uint32_t restart = restart_index(type);
    // The first square; a triangle that lacks a vertex; the last square in a strip of odd length; nothing.
    strips.indices = {{restart, 10, 11, 12, 13, restart, 12, 13, restart, restart, 14, 15, 16, 17, restart}};
    strips.index_type = type;
    strips.vertex_offset = -10;
    strips.primitive_restart = true;
    drawn.draws.push_back(strips);
    const auto planes = draw(drawn);
    if (!planes) GTEST_SKIP() << planes.error().what;
    EXPECT_THAT(in_halves(*planes, planes->hits, 3), ElementsAre(2, 2, 0, 0, 2, 2)) << type;
    EXPECT_THAT(in_halves(*planes, planes->owner, 3), ElementsAre(4, 5, kNoOwner, kNoOwner, 6, 7)) << type;
    EXPECT_THAT(in_halves(*planes, planes->varyings[0], 3), ElementsAre(0, 1, 0, 0, 4, 5)) << type;
    EXPECT_THAT(in_halves(*planes, planes->front_facing, 3), ElementsAre(1, 1, 0, 0, 1, 1)) << type;
  }
}

TEST_P(Assembly, ClipsAtUserDistances) {
  Case drawn = strip_of_squares(3);
  Draw& clipped = drawn.draws[0];
  // Two half-spaces: x >= 2 and x <= 9.
  clipped.clip_distance_count = 2;
  for (const float x : {0.0F, 0.0F, 4.0F, 4.0F, 8.0F, 8.0F, 12.0F, 12.0F}) {
    clipped.clip_distances.insert(clipped.clip_distances.end(), {x - 2, 9 - x});
  }
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  for (uint32_t x = 0; x < 16; ++x) EXPECT_EQ(planes->hits[pixel(*planes, x, 2)], x >= 2 && x < 9 ? 1U : 0U) << x;
}

TEST_P(Assembly, CullsAtUserDistances) {
  Case drawn = strip_of_squares(3);
  Draw& culled = drawn.draws[0];
  culled.clip_distance_count = 1;
  culled.clip_distances.assign(8, 1.0F);
  culled.cull_distance_count = 2;
  // Vertices 0 to 2 are behind the second plane, so the first triangle alone goes; the first plane takes none.
  culled.cull_distances = {-1, -1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1};
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  EXPECT_THAT(in_halves(*planes, planes->hits, 3), ElementsAre(0, 1, 1, 1, 1, 1));
  EXPECT_THAT(in_halves(*planes, planes->owner, 3), ElementsAre(kNoOwner, 1, 2, 3, 4, 5));
}

TEST_P(Assembly, DrawsEachDrawWithItsOwnPipeline) {
  Case drawn = strip_of_squares(1);
  drawn.draws.push_back(row_of_points(3).draws[0]);
  drawn.draws[1].topology = VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
  drawn.draws.push_back(strip_of_squares(1).draws[0]);
  drawn.draws[2].state.sample_mask = 0xFFFFFFFEU;  // not the only sample there is
  drawn.draws.push_back(row_of_points(2).draws[0]);
  drawn.draws[3].topology = VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
  const auto planes = draw(drawn);
  if (!planes) GTEST_SKIP() << planes.error().what;
  EXPECT_EQ(planes->hits[pixel(*planes, 0, 0)], 1U);
  EXPECT_EQ(planes->owner[pixel(*planes, 2, 0)], 0U);
  EXPECT_EQ(planes->owner[pixel(*planes, 6, 2)], 4U);
  EXPECT_EQ(planes->hits[pixel(*planes, 2, 2)], 3U);
  EXPECT_EQ(planes->owner[pixel(*planes, 3, 2)], 7U);
}

}  // namespace
}  // namespace fillrule::vulkan
