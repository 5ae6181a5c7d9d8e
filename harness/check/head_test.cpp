#include "harness/check/head.h"

#include <gtest/gtest.h>

#include <string>

namespace fillrule::check {
namespace {

Case good_head() {
  return {.file = "a.toml", .title = "t", .why = "w", .spec = "Polygons; Polygon Mode", .origin = "constructed"};
}

std::string findings(const Case& head) {
  std::string text;
  for (const Error& finding : check_head(head)) text += to_string(finding) + '\n';
  return text;
}

TEST(CheckHead, Good) {
  EXPECT_EQ(findings(good_head()), "");
}

TEST(CheckHead, EmptyWords) {
  Case head = good_head();
  head.title = "  ";
  head.why.clear();
  head.origin = "\n\t";
  EXPECT_EQ(findings(head),
            "a.toml: title is empty\n  hint: Say what is drawn\n"
            "a.toml: why is empty\n  hint: Say what a failure would mean\n"
            "a.toml: origin is empty\n  hint: Say where the idea came from\n");
}

TEST(CheckHead, WordsOfTheTemplate) {
  Case head = good_head();
  head.why = "Say what a failure would mean, and so on";
  EXPECT_EQ(findings(head), "a.toml: why is still the template's\n  hint: Say what a failure would mean\n");
}

TEST(CheckHead, Sections) {
  Case head = good_head();
  head.spec = "Polygons; Polygon Modes ;";
  const std::vector<Error> found = check_head(head);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(to_string(found[0]),
            "a.toml: spec: \"Polygon Modes\" is no section that is known\n  hint: did you mean \"Polygon Mode\"?");
  EXPECT_EQ(found[1].what, "spec: \"\" is no section that is known");
  EXPECT_NE(found[1].hint.find("Depth Bias"), std::string::npos);
}

}  // namespace
}  // namespace fillrule::check
