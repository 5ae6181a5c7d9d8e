#include "cases/format/suggestion.h"

#include <gtest/gtest.h>

namespace fillrule::format {
namespace {

const std::vector<std::string> kWords{"cull_mode", "front_face", "depth_test", "depth_write"};

TEST(Suggestion, OneWrongLetterSwapOrOmission) {
  EXPECT_EQ(closest("cull_mod", kWords), "cull_mode");
  EXPECT_EQ(closest("cullmode", kWords), "cull_mode");
  EXPECT_EQ(closest("clul_mode", kWords), "cull_mode");
  EXPECT_EQ(closest("depht_wirte", kWords), "depth_write");
  EXPECT_EQ(closest("frontface", kWords), "front_face");
}

TEST(Suggestion, AnotherWordIsNotNear) {
  EXPECT_EQ(closest("blend", kWords), std::nullopt);
  EXPECT_EQ(closest("", kWords), std::nullopt);
  EXPECT_EQ(closest("x", {"y"}), std::nullopt);
}

TEST(Suggestion, TheNearestWins) {
  EXPECT_EQ(closest("depth_tset", kWords), "depth_test");
}

TEST(Suggestion, ListsTheCandidatesIfNoneIsNear) {
  EXPECT_EQ(suggestion("blend", kWords, "known keys"), "known keys: cull_mode, front_face, depth_test, depth_write");
  EXPECT_EQ(suggestion("depth_tst", kWords, "known keys"), "did you mean \"depth_test\"?");
  EXPECT_EQ(suggestion("blend", {}, "known keys"), "");
}

}  // namespace
}  // namespace fillrule::format
