#include "reference/exact/expectation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "reference/exact/random_triangle.h"

namespace fillrule::exact {
namespace {

ClipPosition at(double x, double y) {
  return {static_cast<float>(x / 8 - 1), static_cast<float>(y / 8 - 1), 0.5F, 1};
}

// Two triangles, clockwise as seen, that make the square from (2, 2) to (14, 14) of a target of 16x16 pixels.
Case square() {
  Draw draw{.positions = {at(2, 2), at(14, 2), at(2, 14), at(14, 2), at(14, 14), at(2, 14)}};
  draw.state.viewport = {.x = 0, .y = 0, .width = 16, .height = 16, .minDepth = 0, .maxDepth = 1};
  draw.state.scissor = {.offset = {}, .extent = {.width = 16, .height = 16}};
  return {.target = {.width = 16, .height = 16}, .draws = {draw}};
}

std::vector<Entry> entries_at(const Expectation& expectation, uint32_t x, uint32_t y) {
  std::vector<Entry> entries;
  expectation.collect(size_t{y} * 16 + x, entries);
  return entries;
}

std::vector<uint32_t> primitives_at(const Expectation& expectation, uint32_t x, uint32_t y) {
  std::vector<uint32_t> numbers;
  for (const Entry& entry : entries_at(expectation, x, y)) numbers.push_back(entry.piece);
  return numbers;
}

TEST(Expectation, ListsPrimitivesAtEachSampleInSubmissionOrder) {
  Case twice = square();
  twice.draws.push_back(twice.draws.front());
  const Expectation expectation(twice, 8);
  EXPECT_EQ(primitives_at(expectation, 3, 3), (std::vector<uint32_t>{0, 2}));
  EXPECT_EQ(primitives_at(expectation, 13, 13), (std::vector<uint32_t>{1, 3}));
  EXPECT_TRUE(primitives_at(expectation, 0, 0).empty());
}

TEST(Expectation, ASampleOnTheDiagonalIsInDoubtForBoth) {
  const Expectation expectation(square(), 8);
  // The diagonal x + y = 16 runs through the sample (7.5, 8.5).
  ASSERT_EQ(primitives_at(expectation, 7, 8), (std::vector<uint32_t>{0, 1}));
  EXPECT_EQ(entries_at(expectation, 7, 8)[0].coverage, Coverage::kMay);
}

TEST(Expectation, SamplesOfAClassHaveTheSameEntries) {
  Case twice = square();
  twice.draws.push_back(twice.draws.front());
  const Expectation expectation(twice, 8);
  const std::vector<uint32_t>& classes = expectation.classes();
  const auto at = [&](size_t x, size_t y) { return classes[y * 16 + x]; };
  EXPECT_EQ(at(0, 0), kNothing);
  EXPECT_EQ(at(3, 3), at(4, 5));
  EXPECT_NE(at(3, 3), at(13, 13));
  // The diagonal x + y = 16 runs through the samples (7.5, 8.5) and (8.5, 7.5).
  EXPECT_EQ(at(7, 8), at(8, 7));
  EXPECT_NE(at(7, 8), at(3, 3));
  std::vector<Entry> first;
  std::vector<Entry> other;
  for (size_t a = 0; a < classes.size(); ++a) {
    expectation.collect(a, first);
    EXPECT_EQ(first.empty(), classes[a] == kNothing);
    for (size_t b = 0; b < a; ++b) {
      if (classes[a] != classes[b]) continue;
      expectation.collect(b, other);
      EXPECT_EQ(first, other) << a << " and " << b;
    }
  }
}

TEST(Expectation, TellsWhichPieceCoversAlone) {
  const Expectation once(square(), 8);
  EXPECT_EQ(once.sole(once.classes()[3 * 16 + 3]), 0U);
  EXPECT_EQ(once.sole(once.classes()[13 * 16 + 13]), 1U);
  EXPECT_EQ(once.sole(kNothing), std::nullopt);
  EXPECT_EQ(once.sole(once.classes()[8 * 16 + 7]), std::nullopt) << "on the diagonal";
  Case twice = square();
  twice.draws.push_back(twice.draws.front());
  const Expectation over_itself(twice, 8);
  EXPECT_EQ(over_itself.sole(over_itself.classes()[3 * 16 + 3]), std::nullopt);
}

TEST(Expectation, CullingAndFacing) {
  Case culled = square();
  EXPECT_FALSE(Expectation(culled, 8).pieces()[0].front_facing);
  culled.draws[0].state.front_face = VK_FRONT_FACE_CLOCKWISE;
  EXPECT_TRUE(Expectation(culled, 8).pieces()[0].front_facing);
  culled.draws[0].state.cull_mode = VK_CULL_MODE_BACK_BIT;
  EXPECT_FALSE(primitives_at(Expectation(culled, 8), 5, 5).empty());
  culled.draws[0].state.cull_mode = VK_CULL_MODE_FRONT_BIT;
  EXPECT_TRUE(primitives_at(Expectation(culled, 8), 5, 5).empty());
  culled.draws[0].state.cull_mode = VK_CULL_MODE_FRONT_AND_BACK;
  EXPECT_TRUE(primitives_at(Expectation(culled, 8), 5, 5).empty());
}

TEST(Expectation, TheScissorCutsExactly) {
  Case cut = square();
  cut.draws[0].state.scissor = {.offset = {.x = 4, .y = 5}, .extent = {.width = 3, .height = 2}};
  const Expectation expectation(cut, 8);
  EXPECT_FALSE(primitives_at(expectation, 4, 5).empty());
  EXPECT_FALSE(primitives_at(expectation, 6, 6).empty());
  EXPECT_TRUE(primitives_at(expectation, 3, 5).empty());
  EXPECT_TRUE(primitives_at(expectation, 7, 5).empty());
  EXPECT_TRUE(primitives_at(expectation, 4, 4).empty());
  EXPECT_TRUE(primitives_at(expectation, 4, 7).empty());
}

TEST(Expectation, ASliverThatMayTurnOverIsLeftOpenWhenCulled) {
  Case sliver = square();
  sliver.draws[0].positions = {at(2, 4.5), at(14, 4.5), at(8, 4.5 + 1.0 / 2048)};
  sliver.draws[0].state.cull_mode = VK_CULL_MODE_BACK_BIT;
  const Expectation expectation(sliver, 8);
  EXPECT_TRUE(expectation.pieces()[0].facing_in_doubt);
  EXPECT_TRUE(expectation.pieces()[0].thin);
  ASSERT_FALSE(entries_at(expectation, 8, 4).empty());
  EXPECT_EQ(entries_at(expectation, 8, 4)[0].coverage, Coverage::kMay);
}

TEST(Expectation, AVisibleSampleSettlesTheFacingOfATriangleBehindTheEye) {
  Case behind = square();
  behind.draws[0].positions = {{0, 0.9F, 0.5F, 1}, {-0.9F, -0.9F, 0.5F, 1}, {0.5F, 0, -0.5F, -1}};
  const Expectation expectation(behind, 8);
  EXPECT_FALSE(expectation.pieces()[0].facing_in_doubt);
}

TEST(Expectation, OfSomeSamplesIsTheSameThere) {
  constexpr unsigned kSeed = 11;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937_64 random(kSeed);
  size_t entries_found = 0;
  for (int round = 0; round < 1500; ++round) {
    Case some = square();
    some.target.samples = round % 2 == 0 ? VK_SAMPLE_COUNT_1_BIT : VK_SAMPLE_COUNT_4_BIT;
    Draw& draw = some.draws.front();
    draw.positions.clear();
    draw.state.cull_mode = round % 3 == 0 ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT;
    for (size_t i = 0; i < 3; ++i) {
      // Those with w of both signs are in doubt about their facing until some sample tells.
      const auto family = i < 2 ? Family::kMixedW : static_cast<Family>(random() % kFamilies);
      const RandomTriangle picked = random_triangle(family, random);
      for (const ClipPosition& vertex : picked.vertices) draw.positions.push_back(vertex);
    }
    const Expectation all(some, 8);
    Case unculled = some;
    unculled.draws.front().state.cull_mode = VK_CULL_MODE_NONE;
    const Expectation open(unculled, 8);
    // Those that may be covered, which tell least, and a few others.
    std::vector<size_t> samples;
    std::vector<Entry> entries;
    for (size_t sample = 0; sample < all.classes().size(); ++sample) {
      open.collect(sample, entries);
      const bool is_open = !entries.empty() && std::ranges::all_of(entries, [](const Entry& entry) {
        return entry.coverage == Coverage::kMay;
      });
      if (is_open || random() % 64 == 0) samples.push_back(sample);
    }
    const Expectation few(some, 8, samples);
    for (const size_t sample : samples) {
      std::vector<Entry> expected;
      std::vector<Entry> found;
      all.collect(sample, expected);
      few.collect(sample, found);
      EXPECT_EQ(found, expected) << "round " << round << ", sample " << sample;
      entries_found += expected.size();
    }
  }
  EXPECT_GT(entries_found, 1000U);
}

}  // namespace
}  // namespace fillrule::exact
