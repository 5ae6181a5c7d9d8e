#include <gtest/gtest.h>

#include "harness/judge/possibilities.h"

namespace fillrule::judge {
namespace {

TEST(OracleAnswer, NamesTheOwnerOnlyWhereThereIsOne) {
  const OracleAnswer either = answer_of({.outcomes = {{.owner = 1}, {.owner = 2}}});
  EXPECT_EQ(either.coverage, OracleAnswer::Coverage::kMust);
  EXPECT_FALSE(either.owner);
  EXPECT_EQ(answer_of({.outcomes = {{.owner = 1}}}).owner, 1U);
}

TEST(OracleAnswer, TellsWhatIsLeftOpen) {
  EXPECT_EQ(answer_of({.in_doubt = true, .outcomes = {{.owner = 1}, {}}}).coverage, OracleAnswer::Coverage::kMay);
  EXPECT_EQ(answer_of({.outcomes = {{}}}).coverage, OracleAnswer::Coverage::kMustNot);
  EXPECT_EQ(answer_of({.undefined = true, .outcomes = {{.owner = 1}}}).coverage, OracleAnswer::Coverage::kUndefined);
}

}  // namespace
}  // namespace fillrule::judge
