#include "harness/run/merge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fillrule::run {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> names(const std::vector<CaseResult>& cases) {
  std::vector<std::string> result;
  result.reserve(cases.size());
  for (const CaseResult& one : cases) result.push_back(one.name);
  return result;
}

NamedResult shard(uint32_t index, uint32_t total, const std::vector<std::string>& cases) {
  NamedResult part{.file = "shard-" + std::to_string(index) + "/results.json"};
  part.result.candidate = "renderer";
  part.result.reference = {.driver = "lavapipe", .name = "llvmpipe", .version = "Mesa 1", .subpixel_bits = 8};
  part.result.shard = {.index = index, .total = total, .suite_cases = 5};
  part.result.timing.run.judge_seconds = 1 + index;
  part.result.summary.wall_seconds = 3 - index;
  for (const std::string& name : cases) part.result.cases.push_back({.name = name});
  return part;
}

std::string error_of(const std::vector<NamedResult>& parts) {
  const Result<RunResult> merged = merge_results(parts);
  return merged ? "merged" : to_string(merged.error());
}

TEST(CasesOf, EveryNthAsGoogleTestSplitsTests) {
  std::vector<Case> suite;
  for (const char* const name : {"a", "b", "c", "d", "e"}) suite.push_back({.name = name});
  const auto split = [&suite](uint32_t index, uint32_t total) {
    std::string result;
    for (const Case& one : cases_of({.index = index, .total = total}, suite)) result += one.name;
    return result;
  };
  EXPECT_EQ(split(0, 1), "abcde");
  EXPECT_EQ(split(0, 2), "ace");
  EXPECT_EQ(split(1, 2), "bd");
  EXPECT_EQ(split(6, 7), "");
}

TEST(MergeResults, TheCasesAreInTheOrderOfTheSuite) {
  // Not that of their names: selectors have an order of their own.
  const auto merged = merge_results(std::vector{shard(1, 2, {"d", "b"}), shard(0, 2, {"e", "c", "a"})});
  ASSERT_TRUE(merged) << to_string(merged.error());
  EXPECT_THAT(names(merged->cases), ElementsAre("e", "d", "c", "b", "a"));
  EXPECT_EQ(merged->summary.cases, 5U);
  EXPECT_EQ(merged->timing.run.judge_seconds, 3);
  EXPECT_EQ(merged->summary.wall_seconds, 3);
  EXPECT_EQ(merged->shard.total, 1U);
  EXPECT_EQ(merged->reference.version, "Mesa 1");
}

TEST(MergeResults, RunsThatWereNotSplitAreJoinedByName) {
  const auto merged = merge_results(std::vector{shard(0, 1, {"b", "c"}), shard(0, 1, {"a", "d"})});
  ASSERT_TRUE(merged) << to_string(merged.error());
  EXPECT_THAT(names(merged->cases), ElementsAre("a", "b", "c", "d"));
}

TEST(MergeResults, OtherPartiesAreRefused) {
  NamedResult other = shard(1, 2, {"b", "d"});
  other.result.reference.version = "Mesa 2";
  EXPECT_THAT(error_of({shard(0, 2, {"a", "c", "e"}), other}),
              HasSubstr("shard-1/results.json: is of other parties: renderer (0 subpixel bits) against lavapipe"));
  other = shard(1, 2, {"b", "d"});
  other.result.candidate = "painter";
  EXPECT_THAT(error_of({shard(0, 2, {"a", "c", "e"}), other}), HasSubstr("is of other parties: painter"));
}

TEST(MergeResults, OtherProfilesAreRefused) {
  NamedResult first = shard(0, 2, {"a", "c", "e"});
  first.result.profile = "top_left";
  NamedResult second = shard(1, 2, {"b", "d"});
  EXPECT_THAT(error_of({first, second}), HasSubstr("shard-1/results.json: is judged by no profile"));
  EXPECT_THAT(error_of({first, second}), HasSubstr("shard-0/results.json is judged by profile top_left"));
  second.result.profile = "top_left";
  const auto merged = merge_results(std::vector{first, second});
  ASSERT_TRUE(merged) << to_string(merged.error());
  EXPECT_EQ(merged->profile, "top_left");
}

TEST(MergeResults, ACaseThatIsThereTwiceIsRefused) {
  EXPECT_THAT(error_of({shard(0, 2, {"a", "c", "e"}), shard(1, 2, {"b", "c"})}),
              HasSubstr("shard-1/results.json: holds the case \"c\" a second time"));
}

TEST(MergeResults, EveryShardMustBeThereOnce) {
  EXPECT_THAT(error_of({shard(0, 2, {"a", "c", "e"})}), HasSubstr("shard 2 of 2 is missing"));
  EXPECT_THAT(error_of({shard(0, 2, {"a", "c", "e"}), shard(0, 2, {})}),
              HasSubstr("is shard 1 of 2, which is there already"));
  EXPECT_THAT(error_of({shard(0, 2, {"a", "c", "e"}), shard(1, 3, {})}), HasSubstr("is shard 2 of 3, of 5 cases"));
  EXPECT_THAT(error_of({shard(0, 2, {"a", "c", "e"}), shard(1, 2, {"b"})}),
              HasSubstr("shard-1/results.json: holds fewer cases than its shard has"));
  EXPECT_THAT(error_of({}), HasSubstr("there are no results to merge"));
}

}  // namespace
}  // namespace fillrule::run
