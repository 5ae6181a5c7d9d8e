#include "harness/report/json.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "cases/model/temporary_folder.h"

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
                     .profile = "top_left,precise",
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
  EXPECT_EQ(json["profile"], "top_left,precise");
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

TEST(ReadResults, WhatWasWrittenIsReadAgain) {
  run::RunResult run = one_failure();
  run.shard = {.index = 1, .total = 3, .suite_cases = 2};
  run.cases[0].reason = "The candidate's depth is NaN.";
  run.cases[0].checks = {
      {.name = "rotated", .outcome = judge::CheckResult::Outcome::kOptedOut, .message = "its order matters"}};
  run.cases[0].verdict.planes.push_back({.name = "uv",
                                         .kind = judge::PlaneKind::kVarying,
                                         .first_component = 0,
                                         .components = 2,
                                         .counts = {1, 2, 3, 4, 5, 6}});
  run.cases[0].verdict.planes.push_back(
      {.name = "w", .kind = judge::PlaneKind::kVarying, .first_component = 2, .counts = {9, 0, 0, 0, 0, 0}});
  run.cases.push_back({.name = "a/b", .status = run::Status::kSkipped, .message = "the device lacks it"});
  run.summary = run::summarise(run.cases, 0.25);
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text(folder.path("results.json"), to_json(run, {})));
  const auto read = read_results(folder.path("results.json"));
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(to_json(*read, {}), to_json(run, {}));
  EXPECT_EQ(read->cases[0].verdict.planes[2].first_component, 2U);
  EXPECT_EQ(read->cases[0].verdict.planes[0].counts, run.cases[0].verdict.planes[0].counts);
}

TEST(ReadResults, AnotherFileIsAnErrorWithItsName) {
  const TemporaryFolder folder;
  const std::string path = folder.path("results.json");
  EXPECT_EQ(read_results(path).error().what, "cannot be read");
  for (const char* const text : {"", "{}", "[1]", "{\"summary\": 1}", "{\"cases\": [{}]}"}) {
    ASSERT_TRUE(write_text(path, text));
    const auto read = read_results(path);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().file, path);
  }
  std::string spoiled = to_json(one_failure(), {});
  spoiled.replace(spoiled.find("\"failed\","), 9, "\"broken\",");
  ASSERT_TRUE(write_text(path, spoiled));
  EXPECT_NE(read_results(path).error().what.find("\"broken\" is not known"), std::string::npos);
}

TEST(WriteText, AFolderThatIsNotThereIsAnErrorWithItsName) {
  const auto written = write_text("/nonexistent/folder/results.json", "{}");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().file, "/nonexistent/folder/results.json");
}

}  // namespace
}  // namespace fillrule::report
