#include "cases/model/result.h"

#include <gtest/gtest.h>

namespace fillrule {
namespace {

TEST(Error, NamesFileLineAndColumnThenTheHint) {
  const Error error{.file = "a.toml", .line = 3, .column = 7, .what = "unknown key", .hint = "remove it"};
  EXPECT_EQ(to_string(error), "a.toml:3:7: unknown key\n  hint: remove it");
}

TEST(Error, LeavesOutThePartsThatAreAbsent) {
  EXPECT_EQ(to_string(Error{.file = "a.toml", .what = "cannot be read"}), "a.toml: cannot be read");
  EXPECT_EQ(to_string(failure("no device").value()), "no device");
}

}  // namespace
}  // namespace fillrule
