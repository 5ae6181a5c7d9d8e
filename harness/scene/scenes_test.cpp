// Scenes of each kind, drawn in colour by the renderer and by lavapipe, both judged; and faults that are found. The
// whole suite's scenes are judged by conformance_test.
#include <gmock/gmock.h>

#include "harness/scene/check.h"
#include "harness/scene/test_scenes.h"

namespace fillrule::scene {
namespace {

using ::testing::HasSubstr;

PaintingParty renderer_party() {
  return {renderer_painter({})};
}

TEST(Scenes, AgreeWithLavapipe) {
  Assets assets;
  const PaintingParty reference{lavapipe()};
  uint64_t compared = 0;
  uint64_t apart = 0;
  std::vector<Case> scenes;
  for (const char* const name : {"textured_cube", "source_e_textured", "source_c_bresenham", "transformed_by_both"}) {
    for (Case& one : suite_scenes(std::string("scenes/") + name, assets)) scenes.push_back(std::move(one));
  }
  for (const Case& built : scenes) {
    const Result<SceneVerdict> verdict = judge_scene(built, assets, renderer_party(), &reference);
    ASSERT_TRUE(verdict) << built.name << ": " << to_string(verdict.error());
    EXPECT_EQ(verdict->colors.candidate.outside, 0U) << built.name << ' ' << verdict->colors.candidate.first;
    EXPECT_EQ(verdict->colors.reference.outside, 0U) << built.name << ' ' << verdict->colors.reference.first;
    EXPECT_TRUE(verdict->colors.alike()) << built.name << ": " << verdict->colors.apart;
    EXPECT_GT(verdict->colors.candidate.judged, 0U) << built.name;
    EXPECT_EQ(verdict->planes.candidate_faults(), 0U) << built.name;
    EXPECT_EQ(verdict->planes.reference_faults(), 0U) << built.name;
    compared += verdict->colors.compared;
    apart += verdict->colors.apart;
  }
  EXPECT_GT(compared, 10000U);
  EXPECT_LE(apart * 1000, compared);
}

// A party whose colours are changed.
PaintingParty altered(void (*alter)(Planes&)) {
  return {[alter](const Case& built, const programs::CaseShading& shading) {
    Result<Planes> planes = renderer_painter({})(built, shading);
    if (planes) alter(*planes);
    return planes;
  }};
}

judge::CheckResult check_cube(const PaintingParty& candidate, const PaintingParty* reference = nullptr) {
  Assets assets;
  const std::vector<Case> scenes = suite_scenes("scenes/textured_cube", assets);
  const Result<judge::CheckResult> result = check_scene(scenes.at(0), assets, candidate, reference);
  EXPECT_TRUE(result) << to_string(result.error());
  return result.value_or(judge::CheckResult{});
}

TEST(SceneCheck, PassesTheRenderer) {
  const judge::CheckResult result = check_cube(renderer_party());
  EXPECT_EQ(result.outcome, judge::CheckResult::Outcome::kPassed) << result.message;
  EXPECT_EQ(result.name, "scene_colors");
}

TEST(SceneCheck, FindsAColourThatIsWrongAtOnePixel) {
  const judge::CheckResult result =
      check_cube(altered([](Planes& planes) { planes.varyings[1][64 * 128 + 64] += 0.02F; }));
  EXPECT_EQ(result.outcome, judge::CheckResult::Outcome::kFailed);
  EXPECT_THAT(result.message, ::testing::AllOf(HasSubstr("1 of "), HasSubstr("(64, 64): colour")));
}

TEST(SceneCheck, FindsACoverageThatIsWrong) {
  const judge::CheckResult result = check_cube(altered([](Planes& planes) { planes.hits[64 * 128 + 64] = 0; }));
  EXPECT_EQ(result.outcome, judge::CheckResult::Outcome::kFailed);
  EXPECT_THAT(result.message, HasSubstr("coverage"));
}

// Geometry that has been judged already, and only that, is not judged again.
TEST(SceneCheck, JudgesNoGeometryTwice) {
  Assets assets;
  const Case cube = suite_scenes("scenes/textured_cube", assets).at(0);
  const Result<Planes> faultless = paint_scene(cube, assets, renderer_painter({}));
  ASSERT_TRUE(faultless);
  const KnownCase known{.faultless = &*faultless};
  const Result<SceneVerdict> same = judge_scene(cube, assets, renderer_party(), nullptr, known);
  ASSERT_TRUE(same);
  EXPECT_TRUE(same->planes.planes.empty());
  constexpr size_t kMiddle = 64 * 128 + 64;
  const std::array<void (*)(Planes&), 4> faults{[](Planes& planes) { planes.hits[kMiddle] += 1; },
                                                [](Planes& planes) { planes.owner[kMiddle] += 1; },
                                                [](Planes& planes) { planes.front_facing[kMiddle] ^= 1U; },
                                                [](Planes& planes) { planes.depth[kMiddle] -= 0.125F; }};
  for (const auto& fault : faults) {
    const Result<SceneVerdict> wrong = judge_scene(cube, assets, altered(fault), nullptr, known);
    ASSERT_TRUE(wrong);
    EXPECT_GT(wrong->planes.candidate_faults(), 0U);
  }
  // Where everything is judged with less subpixel bits, what was judged with all of them says nothing.
  const Case moved = suite_scenes("scenes/transformed_by_both", assets).at(0);
  const Result<Planes> painted = paint_scene(moved, assets, renderer_painter({}));
  ASSERT_TRUE(painted);
  const Result<SceneVerdict> coarser =
      judge_scene(moved, assets, renderer_party(), nullptr, {.faultless = &*painted});
  ASSERT_TRUE(coarser);
  EXPECT_FALSE(coarser->planes.planes.empty());
}

TEST(SceneCheck, BlamesTheReferenceForItsOwnFault) {
  const PaintingParty reference = altered([](Planes& planes) {
    for (float& red : planes.varyings[0]) red *= 0.9F;
  });
  const judge::CheckResult result = check_cube(renderer_party(), &reference);
  EXPECT_EQ(result.outcome, judge::CheckResult::Outcome::kPassed);
  EXPECT_THAT(result.message, HasSubstr("reference fault"));
}

// Draws every vertex 1/40 pixel further down: as a driver of 4 subpixel bits may, which rounds by up to 1/32. Down,
// since that is where a floor's texture coordinates change most.
Result<Planes> drawn_further_down(const Case& built, const programs::CaseShading& shading) {
  Case moved = built;
  for (Draw& draw : moved.draws) {
    const float ndc = 2 / draw.state.viewport.height / 40;
    for (ClipPosition& position : draw.positions) position[1] += ndc * position[3];
  }
  return renderer_painter({})(moved, shading);
}

TEST(SceneCheck, DoesNotHoldACandidateToAReferenceOfOtherSubpixelBits) {
  Assets assets;
  const Case built = suite_scenes("scenes/mipmaps[mipmaps=none,filter=bilinear]", assets).at(0);
  const PaintingParty coarse{drawn_further_down, 4};
  const Result<judge::CheckResult> result = check_scene(built, assets, renderer_party(), &coarse);
  ASSERT_TRUE(result) << to_string(result.error());
  EXPECT_EQ(result->outcome, judge::CheckResult::Outcome::kPassed) << result->message;
  EXPECT_EQ(result->message, "") << "nor is the reference at fault";
  // Who claims 8 bits may not draw so.
  const PaintingParty fine{drawn_further_down, 8};
  const Result<SceneVerdict> claimed = judge_scene(built, assets, renderer_party(), &fine);
  ASSERT_TRUE(claimed) << to_string(claimed.error());
  EXPECT_FALSE(claimed->colors.alike());
  EXPECT_GT(claimed->colors.reference.outside, 0U);
}

TEST(SceneCheck, RefusesToJudgeWhatItHasNoBoundFor) {
  Assets assets;
  const Case built = built_scene(parsed_scene("[scene]\ntransform_on = 'both'\ncamera = { eye = [0, 0, 1.0001] }\n"
                                              "projection = { near = 1e-5 }\n[[scene.object]]\nmesh = 'cube'\n"),
                                 assets);
  const Result<SceneVerdict> verdict = judge_scene(built, assets, renderer_party(), nullptr);
  ASSERT_FALSE(verdict);
  EXPECT_THAT(verdict.error().what, HasSubstr("where the vertex stage transforms"));
  EXPECT_FALSE(check_scene(built, assets, renderer_party(), nullptr)) << "nobody has failed";
}

}  // namespace
}  // namespace fillrule::scene
