#include "harness/stress/generate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cases/format/reader.h"
#include "cases/format/writer.h"
#include "reference/exact/expectation.h"

namespace fillrule::stress {
namespace {

constexpr uint64_t kSeed = 7;
constexpr uint64_t kCases = 30;  // of each family

// How many triangles of the family `predicate` holds for.
template <typename Predicate>
uint64_t count_triangles(Family family, Predicate predicate) {
  uint64_t count = 0;
  for (uint64_t number = 0; number < kCases; ++number) {
    const Case one = random_case(kSeed, family, number);
    const exact::Expectation expectation(one, 8);
    for (const exact::Piece& piece : expectation.pieces()) count += predicate(*piece.triangle()) ? 1 : 0;
  }
  return count;
}

uint64_t total(Family family) {
  return kCases * triangles_per_case(family);
}

bool any_vertex(const exact::Triangle& triangle, bool (*predicate)(const ClipPosition&)) {
  return std::ranges::any_of(triangle.vertices(), predicate);
}

TEST(RandomCase, IsTheSameForTheSameArguments) {
  for (const Family family : all_families()) {
    EXPECT_EQ(format::write(random_case(1, family, 2)), format::write(random_case(1, family, 2)));
    EXPECT_NE(format::write(random_case(1, family, 2)), format::write(random_case(1, family, 3)));
    EXPECT_NE(format::write(random_case(1, family, 2)), format::write(random_case(2, family, 2)));
  }
}

TEST(RandomCase, HasTheTrianglesItSaysAndIsWithinTheFormat) {
  for (const Family family : all_families()) {
    for (uint64_t number = 0; number < kCases; ++number) {
      const Case one = random_case(kSeed, family, number);
      uint32_t triangles = 0;
      for (const Draw& draw : one.draws) triangles += primitive_count(draw);
      EXPECT_EQ(triangles, triangles_per_case(family)) << one.name;
      const std::string text = format::write(one);
      const format::CaseFile file = format::parse(text, "case.toml", one.name);
      ASSERT_THAT(file.errors, testing::IsEmpty()) << text;
      EXPECT_EQ(format::write(file.cases.front()), text);
    }
  }
}

TEST(RandomCase, IsNamedAfterFamilySeedAndNumber) {
  EXPECT_EQ(random_case(3, Family::kNearAndFar, 12).name, "stress/near_and_far/3-12");
}

TEST(Family, NamesAreFoundAgain) {
  for (const Family family : all_families()) EXPECT_EQ(family_named(name_of(family)), family);
  EXPECT_FALSE(family_named("medium").has_value());
}

TEST(Family, MixedWHasBothSignsInEveryTriangle) {
  const auto mixed = [](const exact::Triangle& t) {
    return any_vertex(t, [](const ClipPosition& p) { return p[3] < 0; }) &&
           any_vertex(t, [](const ClipPosition& p) { return p[3] > 0; });
  };
  EXPECT_EQ(count_triangles(Family::kMixedW, mixed), total(Family::kMixedW));
}

TEST(Family, ZeroWHasAVertexAtInfinityAndIsDefined) {
  const auto zero = [](const exact::Triangle& t) {
    return any_vertex(t, [](const ClipPosition& p) { return p[3] == 0; }) && !t.undefined();
  };
  EXPECT_EQ(count_triangles(Family::kZeroW, zero), total(Family::kZeroW));
}

TEST(Family, NearAndFarAreCrossed) {
  const auto near = [](const exact::Triangle& t) {
    return any_vertex(t, [](const ClipPosition& p) { return p[2] < 0; });
  };
  const auto far = [](const exact::Triangle& t) {
    return any_vertex(t, [](const ClipPosition& p) { return p[2] > p[3]; });
  };
  EXPECT_EQ(count_triangles(Family::kNear, near), total(Family::kNear));
  EXPECT_EQ(count_triangles(Family::kNear, far), 0U);
  EXPECT_EQ(count_triangles(Family::kFar, far), total(Family::kFar));
  EXPECT_EQ(count_triangles(Family::kFar, near), 0U);
  EXPECT_EQ(count_triangles(Family::kNearAndFar, near), total(Family::kNearAndFar));
  EXPECT_EQ(count_triangles(Family::kNearAndFar, far), total(Family::kNearAndFar));
}

TEST(Family, VerticesOnTheGridAreExactlyThere) {
  const auto on_grid = [](const exact::Triangle& t) { return t.on_grid(8); };
  EXPECT_GT(count_triangles(Family::kOnGrid, on_grid), total(Family::kOnGrid) * 9 / 10);
  EXPECT_LT(count_triangles(Family::kSmall, on_grid), total(Family::kSmall) / 10);
  const auto half_way = [](const exact::Triangle& t) { return t.on_grid(9) && !t.on_grid(8); };
  EXPECT_GT(count_triangles(Family::kTies, half_way), total(Family::kTies) / 5);
}

TEST(Family, CollinearHasNoAreaMostlyAndSliversAreThin) {
  const auto flat = [](const exact::Triangle& t) { return t.orientation() == 0; };
  EXPECT_GT(count_triangles(Family::kCollinear, flat), total(Family::kCollinear) / 3);
  const auto thin = [](const exact::Triangle& t) { return t.thinner_than(0.1) && t.orientation() != 0; };
  EXPECT_GT(count_triangles(Family::kSliver, thin), total(Family::kSliver) * 9 / 10);
}

TEST(Family, PerspectiveReachesItsRatio) {
  const auto ratio = [](const exact::Triangle& t) {
    const auto [least, most] = std::minmax({t.w(0), t.w(1), t.w(2)});
    return most / least;
  };
  const auto moderate = [&](const exact::Triangle& t) { return ratio(t) > 100 && ratio(t) <= 1003; };
  const auto steep = [&](const exact::Triangle& t) { return ratio(t) > 1e4 && ratio(t) <= 1.001e6; };
  EXPECT_GT(count_triangles(Family::kPerspective, moderate), 0U);
  EXPECT_GT(count_triangles(Family::kSteep, steep), 0U);
}

TEST(Family, HugeGoesFarBeyondTheViewport) {
  const auto far_away = [](const exact::Triangle& t) {
    return any_vertex(t, [](const ClipPosition& p) { return std::abs(p[0]) > 1e7F * std::abs(p[3]); });
  };
  EXPECT_GT(count_triangles(Family::kHuge, far_away), total(Family::kHuge) / 10);
}

TEST(Family, ViewportsAreOddAndOthersAreNot) {
  uint64_t fractional = 0;
  uint64_t upside_down = 0;
  uint64_t inverted_depth = 0;
  for (uint64_t number = 0; number < kCases; ++number) {
    for (const Draw& draw : random_case(kSeed, Family::kViewport, number).draws) {
      const VkViewport& viewport = draw.state.viewport;
      fractional += viewport.x != std::floor(viewport.x) ? 1 : 0;
      upside_down += viewport.height < 0 ? 1 : 0;
      inverted_depth += viewport.minDepth > viewport.maxDepth ? 1 : 0;
    }
    for (const Draw& draw : random_case(kSeed, Family::kNear, number).draws) {
      EXPECT_EQ(draw.state.viewport.x, std::floor(draw.state.viewport.x));
    }
  }
  EXPECT_GT(fractional, 100U);
  EXPECT_GT(upside_down, 10U);
  EXPECT_GT(inverted_depth, 10U);
}

TEST(Family, SharedEdgesAreSharedToTheBit) {
  for (uint64_t number = 0; number < kCases; ++number) {
    const Case one = random_case(kSeed, Family::kSharedEdges, number);
    ASSERT_EQ(one.draws.size(), 1U);
    EXPECT_LE(one.draws[0].positions.size(), triangles_per_case(Family::kSharedEdges) + 2);
  }
}

}  // namespace
}  // namespace fillrule::stress
