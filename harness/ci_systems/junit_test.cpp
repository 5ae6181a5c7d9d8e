#include "harness/ci_systems/junit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <pugixml.hpp>

#include "cases/model/temporary_folder.h"
#include "harness/ci_systems/failures.h"

namespace fillrule::ci_systems {
namespace {

using testing::HasSubstr;

std::vector<std::string> no_pictures(const run::CaseResult& /*result*/) {
  return {};
}

// Whether xmllint finds that the text keeps to junit.xsd.
bool is_valid(const std::string& text) {
  const TemporaryFolder folder;
  std::ofstream(folder.path("junit.xml"), std::ios::binary) << text;
  const std::string command = "xmllint --noout --schema " FILLRULE_SOURCE_DIR "/harness/ci_systems/junit.xsd " +
                              folder.path("junit.xml") + " 2>" + folder.path("errors");
  const bool valid = std::system(command.c_str()) == 0;  // NOLINT(cert-env33-c): of names that are our own
  std::ifstream errors(folder.path("errors"));
  std::string line;
  while (!valid && std::getline(errors, line)) std::cout << line << "\n";
  return valid;
}

pugi::xml_document parsed(const std::string& text) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(text.c_str())) << text;
  return document;
}

pugi::xml_node test_case(const pugi::xml_document& document, const char* name) {
  const pugi::xpath_node_set all = document.select_nodes("//testcase");
  for (const pugi::xpath_node& one : all) {
    if (one.node().attribute("name").value() == std::string(name)) return one.node();
  }
  ADD_FAILURE() << "no " << name;
  return {};
}

TEST(Junit, KeepsToItsSchema) {
  EXPECT_TRUE(is_valid(to_junit(every_outcome(), no_pictures)));
  EXPECT_TRUE(is_valid(to_junit({}, no_pictures)));
}

TEST(Junit, TheSchemaRefusesWhatIsWrong) {
  const std::string right = to_junit(every_outcome(), no_pictures);
  const auto changed = [&right](const std::string& from, const std::string& to) {
    std::string text = right;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  EXPECT_FALSE(is_valid(changed("coverage/tie", "coverage/wide"))) << "a name that is there twice";
  EXPECT_FALSE(is_valid(changed("<skipped ", "<ignored ")));
  EXPECT_FALSE(is_valid(changed("tests=\"6\"", "tests=\"six\"")));
  EXPECT_FALSE(is_valid(changed("<failure message=\"owner", "<failure text=\"owner")));
}

TEST(Junit, CountsEveryOutcome) {
  const pugi::xml_document document = parsed(to_junit(every_outcome(), no_pictures));
  const pugi::xml_node root = document.child("testsuites");
  EXPECT_EQ(root.attribute("tests").as_int(), 6);
  EXPECT_EQ(root.attribute("failures").as_int(), 3);
  EXPECT_EQ(root.attribute("errors").as_int(), 1);
  EXPECT_EQ(root.attribute("skipped").as_int(), 1);
  std::vector<std::string> suites;
  for (const pugi::xml_node suite : root) suites.emplace_back(suite.attribute("name").value());
  EXPECT_THAT(suites, testing::ElementsAre("clipping", "coverage", "cases"));
  EXPECT_EQ(root.first_child().attribute("failures").as_int(), 2);
}

TEST(Junit, AFailureHoldsTheFullCountsAndTheReason) {
  const pugi::xml_document document = parsed(to_junit(every_outcome(), no_pictures));
  const pugi::xml_node test = test_case(document, "clipping/near[angle=30]");
  EXPECT_STREQ(test.attribute("classname").value(), "clipping");
  EXPECT_STREQ(test.attribute("file").value(), "cases/clipping/near.toml");
  EXPECT_STREQ(test.attribute("time").value(), "0.250000");
  const pugi::xml_node failure = test.child("failure");
  EXPECT_STREQ(failure.attribute("message").value(), "owner: 1 candidate fault, 1 reference fault, 4094 identical");
  EXPECT_STREQ(failure.attribute("type").value(), "candidate fault");
  EXPECT_THAT(failure.text().get(), HasSubstr("The candidate covers a sample 2 subpixels outside of edge v0-v1."));
  EXPECT_THAT(failure.text().get(), HasSubstr("owner: 1 candidate fault, 1 reference fault, 4094 identical"));
  EXPECT_STREQ(test_case(document, "coverage/check").child("failure").attribute("type").value(), "metamorphic check");
  EXPECT_STREQ(test_case(document, "bare").child("error").attribute("message").value(),
               "the candidate cannot draw it: out of memory");
  EXPECT_STREQ(test_case(document, "coverage/wide").child("skipped").attribute("message").value(),
               "the device lacks lines of 7.5 pixels");
}

TEST(Junit, NamesThatNobodyWouldChooseComeThrough) {
  const pugi::xml_document document = parsed(to_junit(every_outcome(), no_pictures));
  test_case(document, R"(clipping/<b>"quoted" & 'single'\x1b[31m\x0a::error::owned\xff\u{ffff}]]>)");
}

TEST(Junit, NamesThatLookTheSameStayDistinct) {
  run::RunResult run;
  run.cases = {{.name = "a/\x1b"}, {.name = "a/\\x1b"}};
  const std::string text = to_junit(run, no_pictures);
  EXPECT_TRUE(is_valid(text));
  EXPECT_THAT(text, HasSubstr("name=\"a/\\x1b #2\""));
}

TEST(Junit, PicturesAreNamedWhereGitLabLooksForThem) {
  const std::string text = to_junit(every_outcome(), [](const run::CaseResult& result) {
    return result.name == "bare" ? std::vector<std::string>{"build/report/a.png", "build/report/b&c.png"}
                                 : std::vector<std::string>{};
  });
  EXPECT_TRUE(is_valid(text));
  const pugi::xml_document document = parsed(text);
  EXPECT_STREQ(test_case(document, "bare").child("system-out").text().get(),
               "[[ATTACHMENT|build/report/a.png]]\n[[ATTACHMENT|build/report/b&c.png]]\n");
  EXPECT_FALSE(test_case(document, "coverage/tie").child("system-out"));
}

}  // namespace
}  // namespace fillrule::ci_systems
