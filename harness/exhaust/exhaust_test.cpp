#include "harness/exhaust/exhaust.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "cases/model/temporary_folder.h"
#include "reference/vulkan/hit_draw.h"

namespace fillrule::exhaust {
namespace {

// 15,625 triangles, and a target so small that they take 18 batches.
constexpr uint32_t kTargetSize = 64;
constexpr uint64_t kTriangles = 15'625;

Options tiny_world() {
  return {.world = {.grid = 2, .size = 2}, .target_size = kTargetSize};
}

constexpr auto kGoOn = [](const Progress&) { return true; };

Outcome exhaust_or_fail(const Options& options, const Parties& parties, const OnProgress& on_progress = kGoOn) {
  Result<Outcome> outcome = exhaust(options, parties, on_progress);
  if (!outcome) {
    ADD_FAILURE() << to_string(outcome.error());
    return {};
  }
  return *outcome;
}

Progress without_time(Progress progress) {
  progress.seconds = 0;
  return progress;
}

Party lavapipe() {
  const Options options = tiny_world();
  Result<Party> party = make_device("lavapipe", {}, CellLayout(options.world, options.target_size));
  if (!party) {
    ADD_FAILURE() << to_string(party.error());
    return {};
  }
  return *party;
}

// The renderer with something done to what goes in, or to what comes out.
Party renderer_with(const std::function<void(std::vector<PlanePosition>&)>& change_positions,
                    const std::function<void(std::span<uint8_t>)>& change_hits) {
  Party party = make_renderer(8);
  party.draw = [=, draw_well = party.draw](const HitDraw& draw, std::span<uint8_t> hits) {
    std::vector<PlanePosition> positions(draw.positions_clip.begin(), draw.positions_clip.end());
    if (change_positions) change_positions(positions);
    HitDraw changed = draw;
    changed.positions_clip = positions;
    Result<void> drawn = draw_well(changed, hits);
    if (change_hits) change_hits(hits);
    return drawn;
  };
  return party;
}

// Counts a sample on an edge for both sides of it.
Result<void> draw_inclusively(const HitDraw& draw, std::span<uint8_t> hits) {
  std::fill(hits.begin(), hits.end(), uint8_t{0});
  const auto size = static_cast<int>(draw.target_size);
  for (size_t i = 0; i < draw.positions_clip.size(); i += 3) {
    std::array<std::array<double, 2>, 3> v{};
    for (size_t k = 0; k < 3; ++k) {
      for (size_t axis = 0; axis < 2; ++axis) v[k][axis] = (draw.positions_clip[i + k][axis] + 1.0) * size / 2;
    }
    const auto side = [](const auto& a, const auto& b, double x, double y) {
      return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    };
    const double area = side(v[0], v[1], v[2][0], v[2][1]);
    const auto first_x = static_cast<int>(std::min({v[0][0], v[1][0], v[2][0]}));
    const auto first_y = static_cast<int>(std::min({v[0][1], v[1][1], v[2][1]}));
    for (int pixel = 0; area != 0 && pixel < 9; ++pixel) {
      const int x = first_x + pixel % 3;
      const int y = first_y + pixel / 3;
      const bool is_inside = side(v[0], v[1], x + 0.5, y + 0.5) * area >= 0 &&
                             side(v[1], v[2], x + 0.5, y + 0.5) * area >= 0 &&
                             side(v[2], v[0], x + 0.5, y + 0.5) * area >= 0;
      if (is_inside)
        hits[static_cast<size_t>(y) * draw.target_size + static_cast<size_t>(x)] =
            area < 0 ? vulkan::kFrontHit : vulkan::kHit;
    }
  }
  return {};
}

Party inclusive_party() {
  return {.name = "inclusive", .draw = draw_inclusively};
}

TEST(Exhaust, RendererLavapipeAndOracleAreEqualOnATinyWorld) {
  const Party reference = lavapipe();
  for (const VkCullModeFlags cull_mode : {VK_CULL_MODE_NONE, VK_CULL_MODE_FRONT_BIT, VK_CULL_MODE_BACK_BIT}) {
    Options options = tiny_world();
    options.cull_mode = cull_mode;
    const Outcome outcome = exhaust_or_fail(options, {.candidate = make_renderer(8), .reference = reference});
    EXPECT_TRUE(outcome.finished);
    EXPECT_EQ(outcome.progress.triangles, kTriangles);
    EXPECT_GT(outcome.progress.covering, 5'000U);
    EXPECT_EQ(outcome.progress.candidate, Findings{});
    EXPECT_EQ(outcome.progress.reference, Findings{});
  }
}

TEST(Exhaust, OneOrderOfTheVerticesCoversAsMuchAsItsShare) {
  Options options = tiny_world();
  options.world.triples = Triples::kUnordered;
  const Outcome outcome = exhaust_or_fail(options, {.candidate = make_renderer(4)});
  EXPECT_EQ(outcome.progress.triangles, 25U * 26 * 27 / 6);
  EXPECT_EQ(outcome.progress.candidate, Findings{});
  const Outcome ordered = exhaust_or_fail(tiny_world(), {.candidate = make_renderer(4)});
  // Triangles with an area have six orders.
  EXPECT_EQ(outcome.progress.covering * 6, ordered.progress.covering);
  EXPECT_EQ(asymmetric_triangles(tiny_world().world), 0U);
}

TEST(Exhaust, InclusiveEdgesAreTiesAndNoFaults) {
  const Outcome outcome = exhaust_or_fail(tiny_world(), {.candidate = inclusive_party()});
  const Findings& findings = outcome.progress.candidate;
  EXPECT_GT(findings.tally.ties, 1'000U);
  EXPECT_EQ(findings.tally.faults, 0U);
  EXPECT_EQ(findings.tally.latitude, 0U);
  EXPECT_EQ(findings.tally.strays, 0U);
  ASSERT_EQ(findings.first.size(), tiny_world().max_differences);
  EXPECT_TRUE(std::ranges::is_sorted(findings.first, {}, &Difference::number));
  for (const Difference& difference : findings.first) EXPECT_EQ(difference.tally.triangles, 1U);
}

TEST(Exhaust, CoarseSnappingIsAFault) {
  const Party truncating = renderer_with(
      [](std::vector<PlanePosition>& positions) {
        for (PlanePosition& position : positions) {
          for (float& coordinate : position) {
            coordinate = std::floor((coordinate + 1) * kTargetSize / 2) * 2 / kTargetSize - 1;
          }
        }
      },
      nullptr);
  const Outcome outcome = exhaust_or_fail(tiny_world(), {.candidate = truncating});
  EXPECT_GT(outcome.progress.candidate.tally.faults, 100U);
}

TEST(Exhaust, SecondHitsWrongFacingAndStraysAreFound) {
  const auto tally_of = [](const std::function<void(std::span<uint8_t>)>& change_hits) {
    const Parties parties{.candidate = renderer_with(nullptr, change_hits)};
    return exhaust_or_fail(tiny_world(), parties).progress.candidate.tally;
  };
  const Tally twice = tally_of([](std::span<uint8_t> hits) {
    for (uint8_t& hit : hits) hit = static_cast<uint8_t>(hit * 2);
  });
  EXPECT_GT(twice.faults, 8'000U);
  EXPECT_EQ(twice.ties + twice.latitude, 0U);
  const Tally turned = tally_of([](std::span<uint8_t> hits) {
    for (uint8_t& hit : hits) hit = static_cast<uint8_t>(hit == 0 ? 0 : hit ^ 0x10U);
  });
  EXPECT_EQ(turned.faults, twice.faults);
  const Tally stray = tally_of([](std::span<uint8_t> hits) { hits[0] = 1; });
  EXPECT_EQ(stray.strays, 18U);
  EXPECT_EQ(stray.triangles, 0U);
  EXPECT_TRUE(stray.any());
}

TEST(Exhaust, AnErrorOfAPartyIsTheResult) {
  const Party broken{.name = "broken", .draw = [](const HitDraw&, std::span<uint8_t>) -> Result<void> {
                       return failure("out of paint");
                     }};
  Options options = tiny_world();
  options.threads = 3;
  const Result<Outcome> outcome = exhaust(options, {.candidate = broken}, kGoOn);
  ASSERT_FALSE(outcome.has_value());
  EXPECT_EQ(outcome.error().what, "out of paint");
}

TEST(Exhaust, FindsTheSameWithAnyNumberOfThreads) {
  Options options = tiny_world();
  const Parties parties{.candidate = inclusive_party(), .reference = make_renderer(8)};
  const Progress alone = without_time(exhaust_or_fail(options, parties).progress);
  options.threads = 4;
  EXPECT_EQ(without_time(exhaust_or_fail(options, parties).progress), alone);
}

class StateFile : public testing::Test {
 protected:
  [[nodiscard]] Options options() const {
    Options options = tiny_world();
    options.state_file = path_;
    return options;
  }
  // A session that is told to stop after a few batches.
  [[nodiscard]] Outcome interrupted() const {
    return exhaust_or_fail(options(), parties_, [](const Progress& progress) { return progress.triangles < 4'000; });
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.path("state.json");
  Parties parties_{.candidate = inclusive_party(), .reference = make_renderer(8)};
};

TEST_F(StateFile, ResumingFindsTheSameTotals) {
  const Outcome first = interrupted();
  EXPECT_FALSE(first.finished);
  EXPECT_LT(first.progress.triangles, kTriangles / 2);
  ASSERT_TRUE(std::filesystem::exists(path_));
  uint64_t draws = 0;
  Parties counted = parties_;
  counted.candidate.draw = [&draws, draw = parties_.candidate.draw](const HitDraw& input, std::span<uint8_t> hits) {
    ++draws;
    return draw(input, hits);
  };
  const Outcome second = exhaust_or_fail(options(), counted);
  EXPECT_TRUE(second.finished);
  const uint64_t batch = CellLayout(tiny_world().world, kTargetSize).capacity();
  EXPECT_EQ(draws, (kTriangles - first.progress.triangles + batch - 1) / batch) << "nothing is drawn twice";
  EXPECT_EQ(second.resumed_from, first.progress.triangles);
  EXPECT_GE(second.progress.seconds, first.progress.seconds);
  EXPECT_FALSE(std::filesystem::exists(path_)) << "nothing is left to resume";
  EXPECT_EQ(without_time(second.progress), without_time(exhaust_or_fail(tiny_world(), parties_).progress));
}

TEST_F(StateFile, FreshIgnoresIt) {
  ASSERT_FALSE(interrupted().finished);
  Options fresh = options();
  fresh.fresh = true;
  const Outcome outcome = exhaust_or_fail(fresh, parties_);
  EXPECT_EQ(outcome.resumed_from, 0U);
  EXPECT_EQ(outcome.progress.triangles, kTriangles);
}

TEST_F(StateFile, ThatOfAnotherWorldOrOfNoneIsNotTakenUp) {
  ASSERT_FALSE(interrupted().finished);
  Options other = options();
  other.cull_mode = VK_CULL_MODE_BACK_BIT;
  const Outcome outcome = exhaust_or_fail(other, parties_);
  EXPECT_EQ(outcome.resumed_from, 0U);
  EXPECT_NE(outcome.note.find("another world"), std::string::npos);
  std::ofstream(path_) << "{\"identity\": 3";
  EXPECT_NE(exhaust_or_fail(options(), parties_).note.find("no state file"), std::string::npos);
}

TEST_F(StateFile, ThatCannotBeWrittenIsAnError) {
  Options unwritable = options();
  unwritable.state_file = "/proc/no/such/file.json";
  const auto outcome = exhaust(unwritable, parties_, [](const Progress&) { return false; });
  ASSERT_FALSE(outcome.has_value());
  EXPECT_NE(outcome.error().what.find("cannot be written"), std::string::npos);
}

}  // namespace
}  // namespace fillrule::exhaust
