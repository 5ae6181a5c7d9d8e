#include "harness/report/json.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace fillrule::report {
namespace {

run::RunResult one_failure() {
  judge::PlaneVerdict depth{.name = "depth", .kind = judge::PlaneKind::kDepth};
  depth.counts = {10, 3, 0, 1, 2, 0};
  depth.first = judge::SampleRecord{.x = 3,
                                    .y = 4,
                                    .verdict = judge::Verdict::kCandidateFault,
                                    .candidate = std::numeric_limits<double>::quiet_NaN(),
                                    .reference = 0.5,
                                    .expected = 0.5,
                                    .tolerance = 1e-7};
  depth.worst = depth.first;
  depth.bounds = judge::Bounds{.min_x = 3, .min_y = 4, .max_x = 5, .max_y = 6};
  run::CaseResult result{.name = "depth/\"quoted\" <b>", .file = "\xff.toml", .status = run::Status::kFailed};
  result.verdict.planes.push_back(depth);
  run::RunResult run{.candidate = "renderer",
                     .candidate_subpixel_bits = 8,
                     .reference = {.driver = "lavapipe", .name = "llvmpipe", .version = "Mesa 1", .subpixel_bits = 8},
                     .cases = {result}};
  run.summary = run::summarise(run.cases, 0.25);
  return run;
}

run::DeviationReport one_unexpected() {
  return {.unexpected = {{.case_name = "a/b", .plane = "depth", .samples = 3}},
          .gone = {{.cases = {"a/*"}, .planes = {"owner"}}}};
}

TEST(Json, HoldsTheDeviations) {
  const auto json = nlohmann::json::parse(to_json(one_failure(), one_unexpected()));
  EXPECT_EQ(json["deviations"]["unexpected"][0]["case"], "a/b");
  EXPECT_EQ(json["deviations"]["unexpected"][0]["samples"], 3);
  EXPECT_EQ(json["deviations"]["gone"][0]["planes"][0], "owner");
  EXPECT_TRUE(json["deviations"]["known"].empty());
}

TEST(Json, HoldsTheSummaryThePartiesAndEveryCase) {
  const auto json = nlohmann::json::parse(to_json(one_failure(), one_unexpected()));
  EXPECT_EQ(json["summary"]["cases"], 1);
  EXPECT_EQ(json["summary"]["failed"], 1);
  EXPECT_EQ(json["summary"]["candidate_faults"], 2);
  EXPECT_EQ(json["summary"]["reference_faults"], 1);
  EXPECT_EQ(json["summary"]["wall_seconds"], 0.25);
  EXPECT_EQ(json["candidate"]["name"], "renderer");
  EXPECT_EQ(json["reference"]["driver"], "lavapipe");
  EXPECT_EQ(json["reference"]["subpixel_bits"], 8);
  const auto& depth = json["cases"][0]["planes"]["depth"];
  EXPECT_EQ(depth["identical"], 10);
  EXPECT_EQ(depth["permitted"], 3);
  EXPECT_EQ(depth["candidate_faults"], 2);
  EXPECT_EQ(depth["bounds"], nlohmann::json({3, 4, 5, 6}));
  EXPECT_EQ(json["cases"][0]["status"], "failed");
}

TEST(Json, NanAndHostileNamesStayValidJson) {
  const auto json = nlohmann::json::parse(to_json(one_failure(), one_unexpected()));
  EXPECT_EQ(json["cases"][0]["name"], "depth/\"quoted\" <b>");
  EXPECT_EQ(json["cases"][0]["planes"]["depth"]["first"]["candidate"], "nan");
}

TEST(WriteText, AFolderThatIsNotThereIsAnErrorWithItsName) {
  const auto written = write_text("/nonexistent/folder/results.json", "{}");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().file, "/nonexistent/folder/results.json");
}

}  // namespace
}  // namespace fillrule::report
