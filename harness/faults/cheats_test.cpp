// Whether a cheat's picture is wrong is decided without the judge: by the picture of the naive rasterizer, at samples
// of which the oracle leaves nothing open.
#include "harness/faults/cheats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "cases/format/suite.h"
#include "harness/faults/rasterizer.h"
#include "harness/judge/judge.h"
#include "harness/scene/build.h"
#include "reference/exact/expectation.h"

namespace fillrule::faults {
namespace {

constexpr uint32_t kSubpixelBits = 8;

// A vertex with w = 0 is infinitely far away in the window, and so far may the values of its triangles be off: the
// oracle calls them "not judged". Coverage, hits and owners are as certain as ever.
bool has_open_values(const Draw& draw) {
  return std::ranges::any_of(draw.positions, [](const ClipPosition& position) { return position[3] == 0; });
}

bool is_certain(const Case& one, const exact::Expectation& expectation, const exact::Entry& entry) {
  const exact::Piece& piece = expectation.pieces()[entry.piece];
  const RasterState& state = one.draws[piece.draw].state;
  return entry.coverage == exact::Coverage::kMust && !piece.facing_in_doubt && !piece.thin && !piece.open &&
         !piece.of_polygon && !state.depth_test && !state.depth_bounds;
}

// Whether the two values are so far apart that no latitude is: a flat one by a bit, any other by a tenth of the
// largest value.
bool far_apart(const std::vector<float>& plane, bool flat, float right, float cheat) {
  if (flat) return std::bit_cast<uint32_t>(right) != std::bit_cast<uint32_t>(cheat);
  float largest = 0;
  for (const float value : plane) {
    if (!std::isfinite(value)) return false;
    largest = std::max(largest, std::abs(value));
  }
  return !(std::abs(right - cheat) <= largest / 10);
}

// Of each plane of varyings: whether it holds a flat one.
std::vector<bool> flat_planes(const Case& one) {
  std::vector<bool> flat;
  for (const Varying& varying : one.varyings) {
    flat.insert(flat.end(), varying.components, varying.interpolation == Interpolation::kFlat);
  }
  return flat;
}

bool differs_at(const Planes& right, const Planes& cheat, const std::vector<bool>& flat, bool has_values,
                size_t index) {
  if (right.hits[index] != cheat.hits[index] || right.owner[index] != cheat.owner[index]) return true;
  // Where nothing may be drawn, or nothing is tested, depth is what it was cleared to.
  if (!right.depth.empty() && right.depth[index] != cheat.depth[index]) return true;
  for (size_t i = 0; has_values && i < right.varyings.size(); ++i) {
    if (far_apart(right.varyings[i], flat[i], right.varyings[i][index], cheat.varyings[i][index])) return true;
  }
  return false;
}

bool is_wrong(const Case& one, const exact::Expectation& expectation, const Planes& right, const Planes& cheat) {
  const std::vector<bool> flat = flat_planes(one);
  std::vector<exact::Entry> entries;
  for (size_t index = 0; index < right.hits.size(); ++index) {
    expectation.collect(index, entries);
    const bool certain =
        std::ranges::all_of(entries, [&](const exact::Entry& entry) { return is_certain(one, expectation, entry); });
    const bool has_values = !entries.empty() && std::ranges::none_of(entries, [&](const exact::Entry& entry) {
      return has_open_values(one.draws[expectation.pieces()[entry.piece].draw]);
    });
    if (certain && differs_at(right, cheat, flat, has_values, index)) return true;
  }
  return false;
}

class CheatTest : public testing::TestWithParam<CheatEntry> {};

// Values are held to the profile `precise`, as the renderer's are: without it they may miss by 64 times their bound.
TEST_P(CheatTest, FailsEveryCaseThatItIsWrongIn) {
  const format::Suite suite = scene::load_suite(FILLRULE_SOURCE_DIR "/cases", {});
  ASSERT_TRUE(suite.errors.empty());
  size_t wrong = 0;
  for (const Case& one : suite.cases) {
    const Planes right = draw_case(one, Fault::kNone, kSubpixelBits);
    const Planes cheat = draw_cheat(one, GetParam().cheat, kSubpixelBits);
    if (!is_wrong(one, exact::Expectation(one, kSubpixelBits), right, cheat)) continue;
    ++wrong;
    const judge::CaseVerdict verdict = judge::judge(one, {.planes = &cheat, .subpixel_bits = kSubpixelBits}, nullptr,
                                                    {.profile = {.precise = true}});
    EXPECT_GT(verdict.candidate_faults(), 0U) << one.name;
  }
  EXPECT_GT(wrong, suite.cases.size() / 20);
}

INSTANTIATE_TEST_SUITE_P(Cheats, CheatTest, testing::ValuesIn(cheats().begin(), cheats().end()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Cheats, AnUnknownNameIsAnErrorThatTellsTheNearest) {
  const auto cheat = cheat_named("blan");
  ASSERT_FALSE(cheat);
  EXPECT_THAT(cheat.error().what, testing::HasSubstr("there is no cheat 'blan'"));
  EXPECT_EQ(cheat.error().hint, "did you mean \"blank\"?");
}

}  // namespace
}  // namespace fillrule::faults
