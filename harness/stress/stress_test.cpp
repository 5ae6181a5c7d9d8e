#include "harness/stress/stress.h"

#include <gtest/gtest.h>

#include "cases/format/reader.h"
#include "cases/model/temporary_folder.h"
#include "harness/programs/varyings.h"

namespace fillrule::stress {
namespace {

class Stress : public testing::Test {
 protected:
  const TemporaryFolder out_;
  const std::string& folder_ = out_.path();
};

Result<Planes> draw(const Case& one, uint32_t /*threads*/) {
  return programs::draw_case(one, {});
}

// Forgets the first sample that it should draw, of triangles that are not tiny.
Result<Planes> draw_without_a_sample(const Case& one, uint32_t threads) {
  Result<Planes> planes = draw(one, threads);
  if (!planes) return planes;
  uint32_t in_a_row = 0;
  for (size_t i = 0; i < planes->hits.size(); ++i) {
    in_a_row = planes->hits[i] != 0 ? in_a_row + 1 : 0;
    if (in_a_row < 8) continue;
    planes->hits[i - 4] = 0;
    break;
  }
  return planes;
}

Result<run::SuiteRunner> runner_with(Result<Planes> (*draw_case)(const Case&, uint32_t), const std::string& reference,
                                     uint32_t jobs = 2) {
  return run::SuiteRunner::create(
      {.reference = reference, .checks = false, .jobs = jobs},
      {.name = "test", .check = [](const Case&) { return Result<void>(); }, .draw = draw_case});
}

TEST_F(Stress, TheRendererIsRightAboutEveryFamilyAndTheCountsAreThoseOfAnyNumberOfJobs) {
  const StressOptions options{.seed = 5, .triangles = 1600, .folder = folder_};
  std::vector<std::string> counts;
  for (const uint32_t jobs : {1U, 3U}) {
    auto runner = runner_with(draw, run::kNoReference, jobs);
    ASSERT_TRUE(runner);
    uint64_t judged = 0;
    StressResult result = run_stress(options, *runner, [&judged](uint64_t triangles) { judged = triangles; });
    EXPECT_EQ(result.total().failed_cases, 0U);
    EXPECT_TRUE(result.findings.empty());
    EXPECT_EQ(result.families.size(), kFamilyCount);
    EXPECT_EQ(judged, result.total().triangles);
    for (const FamilyCounts& family : result.families) {
      EXPECT_GE(family.triangles, 96U) << name_of(family.family);
      EXPECT_LE(family.triangles, 112U) << name_of(family.family);
    }
    result.wall_seconds = 1;
    counts.push_back(summary_text(result));
  }
  EXPECT_EQ(counts[0], counts[1]);
}

TEST_F(Stress, OnlyTheFamiliesAskedForAreDrawn) {
  auto runner = runner_with(draw, run::kNoReference);
  ASSERT_TRUE(runner);
  const StressResult result =
      run_stress({.triangles = 40, .families = {Family::kTies, Family::kHuge}, .folder = folder_}, *runner, nullptr);
  ASSERT_EQ(result.families.size(), 2U);
  EXPECT_EQ(result.families[0].family, Family::kTies);
  EXPECT_EQ(result.total().triangles, 40U);
}

TEST_F(Stress, ALostSampleIsFoundAndItsCaseReadsBackAndFailsAgain) {
  auto runner = runner_with(draw_without_a_sample, run::kNoReference);
  ASSERT_TRUE(runner);
  const StressResult result = run_stress(
      {.triangles = 160, .families = {Family::kOnGrid}, .folder = folder_, .files_per_family = 3}, *runner, nullptr);
  EXPECT_GT(result.total().failed_cases, 3U);
  EXPECT_GT(result.total().candidate_faults, 0U);
  ASSERT_EQ(result.findings.size(), 3U);
  for (const Finding& finding : result.findings) {
    EXPECT_EQ(finding.message, "");
    const format::CaseFile file = format::read_file(finding.result.file, "again");
    ASSERT_EQ(file.cases.size(), 1U) << finding.result.file;
    EXPECT_EQ(file.cases[0].draws.size(), 1U);
    EXPECT_EQ(primitive_count(file.cases[0].draws[0]), 1U) << "is not reduced";
    EXPECT_GT(runner->run(file.cases).summary.candidate_faults, 0U);
  }
}

TEST_F(Stress, AFaultOfTheReferenceAloneFailsNoCase) {
  auto runner = runner_with(draw, "lavapipe");
  ASSERT_TRUE(runner);
  const StressResult result = run_stress(
      {.triangles = 400, .families = {Family::kBig, Family::kMixedW}, .folder = folder_}, *runner, nullptr);
  // Lavapipe: noperspective varyings after clipping.
  EXPECT_EQ(result.total().failed_cases, 0U);
  EXPECT_GT(result.total().unexpected_deviation_cases, 0U);
  ASSERT_FALSE(result.findings.empty());
  EXPECT_GT(result.findings[0].result.verdict.reference_faults(), 0U);
}

TEST_F(Stress, KnownDeviationsAreCountedAndNotTold) {
  auto runner = runner_with(draw, "lavapipe");
  ASSERT_TRUE(runner);
  const StressOptions options{
      .triangles = 400,
      .families = {Family::kMixedW},
      .folder = folder_,
      .known = {{.cases = {"stress/*"}, .planes = {"noperspective"}, .reason = "r", .source = "s"}}};
  const StressResult result = run_stress(options, *runner, nullptr);
  EXPECT_TRUE(result.findings.empty());
  EXPECT_EQ(result.total().unexpected_deviation_cases, 0U);
  EXPECT_GT(result.total().known_deviation_cases, 0U);
}

TEST_F(Stress, AFolderThatCannotBeMadeIsTold) {
  auto runner = runner_with(draw_without_a_sample, run::kNoReference);
  ASSERT_TRUE(runner);
  const StressResult result =
      run_stress({.triangles = 80, .families = {Family::kOnGrid}, .folder = "/dev/null/folder"}, *runner, nullptr);
  ASSERT_FALSE(result.findings.empty());
  EXPECT_NE(result.findings[0].message.find("cannot be written"), std::string::npos);
}

}  // namespace
}  // namespace fillrule::stress
