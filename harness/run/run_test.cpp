#include "harness/run/run.h"

#include <gtest/gtest.h>

#include <fstream>

#include "cases/format/reader.h"
#include "cases/model/temporary_folder.h"
#include "harness/run/suite_runner.h"
#include "harness/scene/build.h"

namespace fillrule::run {
namespace {

constexpr const char* kTriangles = R"(
title = "t"
why = "w"
spec = "s"
[target]
size = [16, 16]
[varyings]
uv = "smooth"
[sweep]
x = { from = 1, to = 40, step = 1 }
[[draw]]
space = "framebuffer"
positions = [["x / 4", 1], [15, 8], [1, 15]]
varyings.uv = [[0, 0], [1, 0], [0, 1]]
)";

std::vector<Case> cases() {
  const format::CaseFile file = format::parse(kTriangles, "triangles.toml", "run/triangles");
  EXPECT_TRUE(file.errors.empty());
  return file.cases;
}

TEST(Candidate, AnUnknownNameIsAnErrorThatTellsWhatThereIs) {
  const auto candidate = make_candidate("painter", {});
  ASSERT_FALSE(candidate);
  EXPECT_EQ(candidate.error().what.find("there is no candidate 'painter': no Vulkan device of the driver"), 0U);
  EXPECT_EQ(
      candidate.error().hint.find("the candidates are renderer, renderer:scanline, faults:NAME, cheats:NAME and "
                                  "the drivers"),
      0U);
  EXPECT_NE(candidate.error().hint.find("'lavapipe'"), std::string::npos);
}

TEST(Candidate, ADriverCanBeJudgedToo) {
  auto runner = SuiteRunner::create({.candidate = "lavapipe", .reference = kNoReference, .jobs = 2});
  ASSERT_TRUE(runner);
  const RunResult result = runner->run(cases());
  EXPECT_EQ(result.candidate, "lavapipe");
  EXPECT_EQ(result.summary.failed, 0U);
}

TEST(Candidate, BothFillsOfTheRendererDrawTheSame) {
  const auto by_edges = make_candidate("renderer", {});
  const auto by_scanlines = make_candidate("renderer:scanline", {});
  ASSERT_TRUE(by_edges && by_scanlines);
  EXPECT_EQ(by_scanlines->name, "renderer:scanline");
  for (const Case& one : cases()) {
    const Result<Planes> expected = by_edges->draw(one, 0);
    const Result<Planes> planes = by_scanlines->draw(one, 0);
    ASSERT_TRUE(expected && planes);
    EXPECT_EQ(planes->hits, expected->hits);
    EXPECT_EQ(planes->owner, expected->owner);
    EXPECT_EQ(planes->depth, expected->depth);
    EXPECT_EQ(planes->varyings, expected->varyings);
  }
}

TEST(Candidate, AFaultOrACheatIsOneByName) {
  const auto right = make_candidate("faults:none", {});
  const auto faulty = make_candidate("faults:snap_to_pixels", {});
  const auto cheat = make_candidate("cheats:blank", {});
  ASSERT_TRUE(right && faulty && cheat);
  const Case one = cases().front();
  EXPECT_NE(right->draw(one, 0)->hits, faulty->draw(one, 0)->hits);
  EXPECT_EQ(cheat->draw(one, 0)->hits, std::vector<uint32_t>(256, 0));
  EXPECT_EQ(make_candidate("faults:snap_to_pixel", {}).error().hint, "did you mean \"snap_to_pixels\"?");
  EXPECT_EQ(make_candidate("cheats:blink", {}).error().hint, "did you mean \"blank\"?");
}

TEST(SuiteRunner, AMissingReferenceIsAnError) {
  const auto runner = SuiteRunner::create({.reference = "voodoo"});
  ASSERT_FALSE(runner);
  EXPECT_NE(runner.error().what.find("voodoo"), std::string::npos);
}

TEST(SuiteRunner, ResultsAreInTheOrderOfTheCasesForAnyNumberOfJobs) {
  const std::vector<Case> all = cases();
  for (const uint32_t jobs : {1U, 3U}) {
    auto runner = SuiteRunner::create({.jobs = jobs, .validation = true});
    ASSERT_TRUE(runner);
    const RunResult result = runner->run(all);
    ASSERT_EQ(result.cases.size(), all.size());
    for (size_t i = 0; i < all.size(); ++i) EXPECT_EQ(result.cases[i].name, all[i].name);
    EXPECT_EQ(result.summary.passed, all.size());
    EXPECT_EQ(result.summary.candidate_faults, 0U);
    EXPECT_EQ(result.reference.driver, "lavapipe");
    EXPECT_TRUE(runner->validation_messages().empty());
  }
}

// So many that the reference draws with two devices.
TEST(SuiteRunner, TwoDevicesDrawWhatOneDoes) {
  std::vector<Case> many;
  while (many.size() < 300) {
    for (Case& one : cases()) many.push_back(std::move(one));
  }
  std::vector<RunResult> results;
  for (const uint32_t jobs : {1U, 2U}) {
    auto runner = SuiteRunner::create({.checks = false, .jobs = jobs, .validation = true});
    ASSERT_TRUE(runner);
    results.push_back(runner->run(many));
    EXPECT_TRUE(runner->validation_messages().empty());
  }
  for (size_t i = 0; i < many.size(); ++i) {
    const judge::CaseVerdict& one = results[0].cases[i].verdict;
    const judge::CaseVerdict& two = results[1].cases[i].verdict;
    EXPECT_EQ(results[1].cases[i].status, Status::kPassed);
    ASSERT_EQ(one.planes.size(), two.planes.size());
    for (size_t p = 0; p < one.planes.size(); ++p) EXPECT_EQ(one.planes[p].counts, two.planes[p].counts);
  }
}

// It is skipped, but failed by a candidate whose geometry is wrong.
TEST(SuiteRunner, NobodyIsToBlameForAnImageThatCannotBeRead) {
  const TemporaryFolder folder;
  std::ofstream(folder.path("torn.png")) << "no image";
  std::ofstream(folder.path("a.toml")) << "title = 't'\nwhy = 'w'\nspec = 's'\n[target]\nsize = [16, 16]\n"
                                       << "[[scene.object]]\nmesh = 'cube'\nmaterial = { texture = 'torn.png' }\n";
  const format::Suite suite = scene::load_suite(folder.path(), {});
  ASSERT_EQ(suite.cases.size(), 1U);
  const auto result_of = [&](Candidate candidate) {
    auto runner = SuiteRunner::create({.reference = kNoReference}, std::move(candidate));
    EXPECT_TRUE(runner);
    return runner->run(suite.cases).cases.at(0);
  };
  auto right = make_candidate("renderer", {});
  auto blank = make_candidate("cheats:blank", {});
  ASSERT_TRUE(right && blank);
  blank->paint = right->paint;
  const CaseResult of_right = result_of(*right);
  EXPECT_EQ(of_right.status, Status::kSkipped);
  ASSERT_TRUE(of_right.bad_input);
  EXPECT_EQ(of_right.bad_input->file, folder.path("torn.png"));
  EXPECT_NE(of_right.message.find("cannot be read as an image"), std::string::npos);
  EXPECT_EQ(result_of(*blank).status, Status::kFailed);
}

TEST(SuiteRunner, WithoutAReferenceTheOracleJudgesAlone) {
  auto runner = SuiteRunner::create({.reference = kNoReference});
  ASSERT_TRUE(runner);
  const RunResult result = runner->run(cases());
  EXPECT_EQ(result.summary.failed, 0U);
  EXPECT_EQ(result.reference.driver, "none");
  EXPECT_GT(result.summary.identical, 0U);
}

TEST(SuiteRunner, ACaseBeyondTheDeviceIsSkippedWithTheReason) {
  std::vector<Case> all = cases();
  all[0].target.samples = VK_SAMPLE_COUNT_8_BIT;
  auto runner = SuiteRunner::create({});
  ASSERT_TRUE(runner);
  const RunResult result = runner->run(all);
  EXPECT_EQ(result.summary.skipped, 1U);
  EXPECT_EQ(result.cases[0].status, Status::kSkipped);
  EXPECT_NE(result.cases[0].message.find("8 samples (samples)"), std::string::npos) << result.cases[0].message;
}

TEST(SuiteRunner, OtherSubpixelBitsAreStillWithinTheSpecification) {
  auto runner = SuiteRunner::create({.candidate_options = {.subpixel_bits = 4}});
  ASSERT_TRUE(runner);
  EXPECT_EQ(runner->run(cases()).summary.failed, 0U);
}

TEST(SuiteRunner, TellsWhereTheTimeWent) {
  auto runner = SuiteRunner::create({.reference = kNoReference, .jobs = 2});
  ASSERT_TRUE(runner);
  const RunTiming timing = runner->run(cases()).timing.run;
  for (const double part :
       {timing.candidate_seconds, timing.oracle_seconds, timing.judge_seconds, timing.check_seconds}) {
    EXPECT_GT(part, 0);
  }
  EXPECT_GE(timing.reference_seconds(), 0) << "parts of the processor's time are no more than all of it";
}

TEST(SuiteRunner, TheReferenceAloneIsMeasuredOnRequest) {
  auto runner = SuiteRunner::create({.measure_alone = true});
  ASSERT_TRUE(runner);
  EXPECT_TRUE(runner->run(cases()).timing.warm.has_value());
}

TEST(Summary, AddsUpCasesAndSamples) {
  CaseResult failed{.status = Status::kFailed};
  failed.verdict.planes.push_back({});
  failed.verdict.planes[0].counts = {5, 4, 3, 2, 1, 1};
  const Summary summary = summarise({failed, {.status = Status::kSkipped}, {}}, 2);
  EXPECT_EQ(summary.cases, 3U);
  EXPECT_EQ(summary.failed, 1U);
  EXPECT_EQ(summary.skipped, 1U);
  EXPECT_EQ(summary.passed, 1U);
  EXPECT_EQ(summary.identical, 5U);
  EXPECT_EQ(summary.candidate_faults, 2U);
  EXPECT_EQ(summary.reference_faults, 3U);
}

}  // namespace
}  // namespace fillrule::run
