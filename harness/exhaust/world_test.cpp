#include "harness/exhaust/world.h"

#include <gtest/gtest.h>

namespace fillrule::exhaust {
namespace {

TEST(World, TheTriplesAreAsMany) {
  EXPECT_EQ(position_count({.grid = 4, .size = 4}), 289U);
  EXPECT_EQ(triple_count({.grid = 4, .size = 4}), 24'137'569U);
  // One order of each three of 1089 positions, 214,652,064, and those with equal ones: 1089 * 1088 + 1089.
  EXPECT_EQ(triple_count({.grid = 16, .size = 2, .triples = Triples::kUnordered}), 214'652'064U + 1'185'921U);
  EXPECT_EQ(default_triples(4, 4), Triples::kOrdered);
  EXPECT_EQ(default_triples(16, 2), Triples::kUnordered);
}

TEST(World, WalkingAndNumberingAgree) {
  for (const Triples triples : {Triples::kOrdered, Triples::kUnordered}) {
    const World world{.grid = 2, .size = 2, .triples = triples};
    Triple triple{};
    for (uint64_t i = 0; i < triple_count(world); ++i) {
      ASSERT_EQ(triple_at(world, i), triple);
      ASSERT_TRUE(triples == Triples::kOrdered || (triple[0] <= triple[1] && triple[1] <= triple[2]));
      advance(triples, position_count(world), triple);
    }
  }
  EXPECT_EQ(triple_at({.grid = 2, .size = 2}, 25U * 25U * 25U - 1), (Triple{24, 24, 24}));
  const World unordered{.grid = 2, .size = 2, .triples = Triples::kUnordered};
  EXPECT_EQ(triple_at(unordered, triple_count(unordered) - 1), (Triple{24, 24, 24}));
}

TEST(World, RefusesWhatHasNoTable) {
  EXPECT_TRUE(check_world(1, 1).has_value());
  EXPECT_TRUE(check_world(16, 4).has_value());
  for (const uint32_t grid : {0U, 3U, 12U, 32U}) EXPECT_FALSE(check_world(grid, 2).has_value()) << grid;
  for (const uint32_t size : {0U, 5U}) EXPECT_FALSE(check_world(4, size).has_value()) << size;
}

}  // namespace
}  // namespace fillrule::exhaust
