#include "harness/ci_systems/annotations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cases/model/temporary_folder.h"
#include "harness/ci_systems/failures.h"

namespace fillrule::ci_systems {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(PlaceOf, TheSweepOfACaseThatIsOneOfSeveralElseTheFirstDraw) {
  const TemporaryFolder folder;
  const std::string file = folder.path("case.toml");
  std::ofstream(file) << "title = \"t\"\n[sweep]\nx = [1, 2]\n\n[[draw]]\n[[draw]]\n";
  run::CaseResult result{.name = "a/case[x=1]", .file = file};
  EXPECT_EQ(place_of(result, folder.path()).line, 2U);
  EXPECT_EQ(place_of(result, folder.path()).path, "case.toml");
  result.name = "a/case";
  EXPECT_EQ(place_of(result, folder.path()).line, 5U);
  EXPECT_EQ(place_of(result, folder.path("elsewhere")).path, file);
  result.file = folder.path("gone.toml");
  EXPECT_EQ(place_of(result, folder.path()).line, 1U);
}

TEST(GithubCommands, OneErrorACaseAndTheTotal) {
  const std::string text = github_commands(every_outcome(), ".");
  EXPECT_THAT(text,
              HasSubstr("::error file=cases/clipping/near.toml,line=1,title=clipping/near[angle=30]::The candidate "
                        "covers a sample 2 subpixels outside of edge v0-v1. owner: 1 candidate fault, 1 "
                        "reference fault, 4094 identical%0Afillrule explain 'x' --pixel 1,2\n"));
  EXPECT_THAT(text, HasSubstr("\n::error title=Fillrule::4 of 6 cases failed\n"));
  EXPECT_EQ(std::ranges::count(text, '\n'), 4 + 1);
}

TEST(GithubCommands, NoNameEndsAPropertyOrALine) {
  run::RunResult run;
  run.cases = {failure("a/50%,b:c" + kHostileName)};
  run.summary = run::summarise(run.cases, 1);
  const std::string text = github_commands(run, ".");
  EXPECT_THAT(text, HasSubstr("title=a/50%25%2Cb%3Acclipping/<b>"));
  EXPECT_THAT(text, Not(HasSubstr("\n::error::owned")));
  EXPECT_EQ(std::ranges::count(text, '\n'), 2);
}

TEST(GithubCommands, NoMoreThanAStepShows) {
  run::RunResult run;
  for (int i = 0; i < 30; ++i) run.cases.push_back(failure("a/" + std::to_string(i)));
  run.summary = run::summarise(run.cases, 1);
  const std::string text = github_commands(run, ".");
  EXPECT_EQ(std::ranges::count(text, '\n'), 10);
  EXPECT_THAT(text, HasSubstr("title=a/8::"));
  EXPECT_THAT(text, Not(HasSubstr("title=a/9::")));
  EXPECT_THAT(text, HasSubstr("30 of 30 cases failed"));
}

TEST(GithubCommands, NothingIsSaidOfARunWithoutFailures) {
  run::RunResult run;
  run.cases = {{.name = "a/b"}};
  EXPECT_EQ(github_commands(run, "."), "");
}

TEST(GithubSummary, CountsAndATable) {
  const std::string text = github_summary(every_outcome(), "build/report");
  EXPECT_THAT(text, HasSubstr("## Fillrule: 4 of 6 cases failed\n"));
  EXPECT_THAT(text, HasSubstr("| 1 | 4 | 1 | 2 | 2 |\n"));
  EXPECT_THAT(text, HasSubstr("The report: build/report\n"));
  EXPECT_THAT(text, HasSubstr("| coverage/check | check scissor&#95;crop&#58; depth differs at &#40;1, 2&#41; |\n"));
}

TEST(GithubSummary, NamesAreNoMarkup) {
  const std::string text = github_summary(every_outcome(), "");
  EXPECT_THAT(text, HasSubstr("| clipping/&#60;b&#62;&#34;quoted&#34;"));
  EXPECT_THAT(text, Not(HasSubstr("<b>")));
}

TEST(GithubSummary, AHundredRowsAreEnough) {
  run::RunResult run;
  for (int i = 0; i < 5000; ++i) run.cases.push_back(failure(std::string(5000, '|') + std::to_string(i)));
  run.summary = run::summarise(run.cases, 1);
  const std::string text = github_summary(run, "");
  EXPECT_THAT(text, HasSubstr("The first 100 of 5000.\n"));
  EXPECT_LT(text.size(), 1024U * 1024);
}

TEST(GitlabCodeQuality, AnEntryForEachFailure) {
  const auto json = nlohmann::json::parse(gitlab_code_quality(every_outcome(), "."));
  ASSERT_EQ(json.size(), 4U);
  EXPECT_EQ(json[0]["location"]["path"], "cases/clipping/near.toml");
  EXPECT_EQ(json[0]["location"]["lines"]["begin"], 1);
  EXPECT_EQ(json[0]["severity"], "major");
  EXPECT_EQ(json[0]["check_name"], "fillrule");
  EXPECT_THAT(json[0]["description"].get<std::string>(), HasSubstr("clipping/near[angle=30]: The candidate covers"));
  EXPECT_NE(json[0]["fingerprint"], json[1]["fingerprint"]);
}

}  // namespace
}  // namespace fillrule::ci_systems
