#include "harness/report/html_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/report/html_explanation.h"
#include "harness/report/test_drawing.h"
#include "harness/report/unpack.h"

namespace fillrule::report {
namespace {

class HtmlCaseTest : public testing::Test {
 protected:
  void SetUp() override {
    const Case test_case = small_case();
    drawing_ = drawing_of(test_case, [](Planes& planes) { planes.depth[2 * 8 + 2] += 0.125F; });
    const run::CaseResult result{.status = run::Status::kFailed, .explain_command = "fillrule explain x --pixel 2,2"};
    const HtmlCase encoded = html_case(test_case, result, drawing_, {.candidate = "c", .reference = "r"});
    const nlohmann::json packed = nlohmann::json::parse(encoded.json);
    details_ = nlohmann::json::parse(unpacked(packed["details"].get<std::string>()));
    planes_ = unpacked(packed["planes"].get<std::string>());
  }
  run::Drawing drawing_;
  nlohmann::json details_;
  std::vector<uint8_t> planes_;
};

TEST_F(HtmlCaseTest, TheHeadIsGolden) {
  nlohmann::json head = details_;
  for (const char* const long_part : {"worst", "explanations", "outlines", "planes"}) head.erase(long_part);
  const char* const golden = R"({
    "name": "small/<triangle>", "file": "", "title": "", "why": "", "spec": "", "status": "failed", "message": "",
    "show": "", "explain": "fillrule explain x --pixel 2,2",
    "sentence": "The candidate stores a wrong depth at 1 sample.", "class": "depth",
    "class_counts": [63, 0, 0, 0, 1, 0, 0, 0, 0, 0], "checks": [], "width": 8, "height": 8, "samples": 1,
    "locations": [[0.5, 0.5]], "has_reference": true,
    "channels": ["hits", "owner", "front_facing", "depth", "uv.x", "uv.y"]})";
  EXPECT_EQ(head, nlohmann::json::parse(golden)) << head.dump(1);
}

TEST_F(HtmlCaseTest, TheWorstSampleIsListedAndExplained) {
  ASSERT_EQ(details_["worst"].size(), 1U);
  const nlohmann::json& worst = details_["worst"][0];
  EXPECT_EQ(worst["plane"], "depth");
  EXPECT_EQ(worst["x"], 2);
  EXPECT_EQ(worst["y"], 2);
  EXPECT_EQ(worst["verdict"], "candidate fault");
  EXPECT_EQ(worst["candidate"], double{drawing_.candidate.depth[18]});
  ASSERT_EQ(details_["explanations"].size(), 1U);
  const nlohmann::json& explanation = details_["explanations"][0];
  const nlohmann::json& depth = explanation["parties"][0]["values"]["depth"];
  EXPECT_EQ(depth["level"], "outside");
  EXPECT_NEAR(depth["expected"].get<double>(), double{drawing_.reference->depth[18]}, 1e-6);
  EXPECT_GT(depth["snapping"].get<double>(), 0);
  const nlohmann::json& primitive = explanation["views"][0]["primitives"][0];
  EXPECT_EQ(primitive["answer"], "must");
  EXPECT_EQ(primitive["boundaries"].size(), 4U);
  double sum = 0;
  for (const nlohmann::json& weight : primitive["barycentric"]) sum += weight.get<double>();
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST_F(HtmlCaseTest, PlanesAreInTheOrderOfTheChannels) {
  constexpr size_t kSamples = 64;
  // Six channels of both parties, six planes of verdicts, classes, the oracle's answers, its owners.
  ASSERT_EQ(planes_.size(), kSamples * (6 * 2 * 4 + 6 + 1 + 1 + 4));
  const auto byte = [this](size_t index) { return planes_[index]; };
  EXPECT_EQ(byte(18), 1);                 // the reference hits it once
  EXPECT_EQ(byte(kSamples * 4 + 18), 0);  // ... and so does the candidate
  const size_t depth = kSamples * 4 * 2 * 3;
  const size_t difference = depth + kSamples * 4;
  EXPECT_NE(byte(difference + 3 * kSamples + 18) | byte(difference + 2 * kSamples + 18), 0);
  EXPECT_EQ(byte(difference + 3 * kSamples + 19) | byte(difference + 2 * kSamples + 19), 0);
  const size_t classes = kSamples * (6 * 2 * 4 + 6);
  EXPECT_EQ(byte(classes + 18), static_cast<uint8_t>(SampleClass::kDepth));
  EXPECT_EQ(byte(classes + kSamples + 18), 2);  // must be covered
}

TEST(JsonNumber, WhatJsonLacksIsText) {
  EXPECT_EQ(json_number(0.5).dump(), "0.5");
  EXPECT_EQ(json_number(NAN).dump(), "\"nan\"");
  EXPECT_EQ(json_number(-INFINITY).dump(), "\"-inf\"");
}

}  // namespace
}  // namespace fillrule::report
