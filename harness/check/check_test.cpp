// Files that are refused, and why; each beside one that is not.
#include "harness/check/check.h"

#include <gtest/gtest.h>

#include <string>

#include "cases/format/reader.h"

namespace fillrule::check {
namespace {

const std::string kHead = "title = 't'\nwhy = 'w'\nspec = 'Polygons'\n";
const std::string kTriangle = "[[draw]]\npositions = [[-0.5, -0.5, 0.5, 1], [0.5, -0.5, 0.5, 1], [0, 'y', 0.5, 1]]\n";

std::vector<Case> cases_of(const std::string& text, const std::string& name) {
  format::CaseFile file = format::parse(text, name + ".toml", name);
  for (const Error& error : file.errors) ADD_FAILURE() << to_string(error);
  return std::move(file.cases);
}

std::string findings(const std::vector<Case>& cases, const std::vector<Case>& controls = {}) {
  std::string text;
  for (const Error& finding : check_files(cases, controls)) text += finding.file + ": " + finding.what + '\n';
  return text;
}

std::string findings_of(const std::string& body, const std::vector<Case>& controls = {}) {
  return findings(cases_of(kHead + body, "a"), controls);
}

TEST(CheckFiles, AFileWithAControlThatLooksDifferentIsGood) {
  EXPECT_EQ(findings_of("control = { y = 0.5 }\n[sweep]\ny = [0.5, 0.75]\n" + kTriangle), "");
}

TEST(CheckFiles, NoControl) {
  EXPECT_EQ(findings_of("[sweep]\ny = [0.5, 0.75]\n" + kTriangle), "a.toml: no control is named\n");
}

TEST(CheckFiles, ControlInAnotherFile) {
  const std::string body = "[let]\ny = 0.5\n" + kTriangle;
  const std::vector<Case> other = cases_of(kHead + "[let]\ny = 0.75\n" + kTriangle, "b");
  EXPECT_EQ(findings_of("control = 'b'\n" + body, other), "");
  EXPECT_EQ(findings_of("control = 'c'\n" + body, other), "a.toml: a: its control is no other case: \"c\"\n");
  EXPECT_EQ(findings_of("control = 'a'\n" + body), "a.toml: a: its control is no other case: \"a\"\n");
}

TEST(CheckFiles, ControlInAFileThatIsCheckedToo) {
  std::vector<Case> cases = cases_of(kHead + "control = 'b'\n[let]\ny = 0.5\n" + kTriangle, "a");
  for (Case& one : cases_of(kHead + "control = 'a'\n[let]\ny = 0.75\n" + kTriangle, "b")) {
    cases.push_back(std::move(one));
  }
  EXPECT_EQ(findings(cases), "");
}

TEST(CheckFiles, WhatIsTestedHasNoEffect) {
  const std::string body = "control = { y = 0.5 }\n[sweep]\ny = [0.5, '0.5 + 0', '0.25 + 0.25']\n" + kTriangle;
  EXPECT_EQ(findings_of(body),
            "a.toml: y=0.25 + 0.25: no case looks other than its control: what is tested has no effect\n"
            "a.toml: y=0.5 + 0: no case looks other than its control: what is tested has no effect\n");
  EXPECT_EQ(findings_of("expect = 'same'\n" + body), "");
}

TEST(CheckFiles, OneCaseThatShowsTheEffectIsEnough) {
  // The scissor hides what ulp(0.75, 0) does, but only for one value of x.
  const std::string body =
      "control = { y = 0.5 }\n[target]\nsize = [16, 16]\n[sweep]\ny = [0.5, 'ulp(0.75, 0)']\nx = [0, 8]\n"
      "[state]\nscissor = { x = 0, y = 'x', width = 16, height = 5 }\n" +
      kTriangle;
  EXPECT_EQ(findings_of(body), "");
}

TEST(CheckFiles, TheSameCoverageIsExpected) {
  EXPECT_EQ(findings_of("expect = 'same'\ncontrol = { y = 0.5 }\n[sweep]\ny = [0.5, 0.75]\n" + kTriangle),
            "a.toml: a[y=0.75]: covers other samples than its control, although the same are expected\n");
}

TEST(CheckFiles, NothingIsDrawn) {
  const std::string body = "control = { y = 0.5 }\n[sweep]\ny = [0.5, -0.5]\n" + kTriangle;
  EXPECT_EQ(findings_of(body), "a.toml: a[y=-0.5]: draws nothing\n");
  EXPECT_EQ(findings_of("expect = { nothing = [{ y = -0.5 }] }\n" + body), "");
}

TEST(CheckFiles, SomethingIsDrawnAlthoughNothingIsExpected) {
  EXPECT_EQ(findings_of("expect = 'nothing'\ncontrol = { y = 0.5 }\n[sweep]\ny = [0.5, 0.75]\n" + kTriangle),
            "a.toml: a[y=0.75]: draws something, although nothing is expected\n");
}

TEST(CheckFiles, AllSamplesAreLeftOpen) {
  // A NaN leaves open what the triangle covers.
  const std::string body = "control = { y = 0.5 }\n[sweep]\ny = [0.5, nan]\n" + kTriangle;
  EXPECT_EQ(findings_of(body), "a.toml: a[y=nan]: a blank picture passes\n");
  EXPECT_EQ(findings_of(body + "[[draw]]\npositions = [[-1, -1, 0.5, 1], [0, -1, 0.5, 1], [-1, 0, 0.5, 1]]\n"), "");
}

TEST(CheckFiles, HeadsAreChecked) {
  std::vector<Case> cases = cases_of(kHead + "control = { y = 0.5 }\n[sweep]\ny = [0.5, 0.75]\n" + kTriangle, "a");
  for (Case& one : cases) one.spec = "Polygon";
  EXPECT_EQ(findings(cases), "a.toml: spec: \"Polygon\" is no section that is known\n");
}

TEST(CheckFiles, ACaseThatCannotBeDrawn) {
  std::vector<Case> cases = cases_of(kHead + "control = { y = 0.5 }\n[sweep]\ny = [0.5, 0.75]\n" + kTriangle, "a");
  cases[1].draws[0].indices = {7, 8, 9};
  const std::vector<Error> found = check_files(cases, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].what.starts_with("a[y=0.75]: cannot be drawn: ")) << found[0].what;
}

}  // namespace
}  // namespace fillrule::check
