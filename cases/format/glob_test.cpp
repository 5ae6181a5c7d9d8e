#include "cases/format/glob.h"

#include <gtest/gtest.h>

namespace fillrule::format {
namespace {

TEST(Glob, StarIsAnyTextAndQuestionMarkOneCharacter) {
  EXPECT_TRUE(glob_matches("clipping/*", "clipping/near_plane[angle=30]"));
  EXPECT_TRUE(glob_matches("*plane*", "clipping/near_plane[angle=30]"));
  EXPECT_TRUE(glob_matches("*", ""));
  EXPECT_TRUE(glob_matches("**", "a/b"));
  EXPECT_TRUE(glob_matches("a?c", "abc"));
  EXPECT_FALSE(glob_matches("a?c", "ac"));
  EXPECT_FALSE(glob_matches("clipping", "clipping/near"));
  EXPECT_FALSE(glob_matches("*near", "clipping/near_plane"));
  EXPECT_FALSE(glob_matches("", "a"));
}

TEST(Glob, BracketsAreThemselves) {
  EXPECT_TRUE(glob_matches("a[x=1]", "a[x=1]"));
  EXPECT_FALSE(glob_matches("a[x=1]", "ax"));
  EXPECT_TRUE(glob_matches("a[x=*]", "a[x=1,y=2]"));
}

TEST(Glob, CanMatchALongerText) {
  EXPECT_TRUE(glob_can_match("a[x=1]", "a["));
  EXPECT_TRUE(glob_can_match("a*", "a["));
  EXPECT_TRUE(glob_can_match("*y=2]", "a["));
  EXPECT_FALSE(glob_can_match("a", "a["));
  EXPECT_FALSE(glob_can_match("ab*", "a["));
}

}  // namespace
}  // namespace fillrule::format
