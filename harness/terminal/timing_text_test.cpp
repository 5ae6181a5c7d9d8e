#include "harness/terminal/timing_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fillrule::terminal {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

run::Timing example() {
  return {.run = {.wall_seconds = 0.5, .processor_seconds = 0.9, .candidate_seconds = 0.1, .check_seconds = 0.2}};
}

TEST(TimingText, WhatNoPartTakesIsTheReferences) {
  const std::string text = timing_text(example(), 100, 0);
  EXPECT_THAT(text, ContainsRegex("reference: draws and reads back, the rest +0.600 +6.0000\n"));
  EXPECT_THAT(text, ContainsRegex("cold +0.500 s, 200 cases a second"));
  EXPECT_THAT(text, Not(HasSubstr("warm")));
  EXPECT_THAT(text, Not(HasSubstr("pictures")));
}

TEST(TimingText, WarmFiguresAreHeldAgainstTheReferenceAlone) {
  run::Timing timing = example();
  timing.warm = {.suite = {.wall_seconds = 0.3, .processor_seconds = 0.5, .oracle_seconds = 0.1},
                 .reference_alone = {.wall_seconds = 0.2, .processor_seconds = 0.25}};
  const std::string text = timing_text(timing, 100, 1.5);
  EXPECT_THAT(text, ContainsRegex("oracle: what must and may be covered +0.100 +1.0000 +0.40\n"));
  EXPECT_THAT(text, ContainsRegex("in all +0.500 +5.0000 +2.00\n"));
  EXPECT_THAT(text, HasSubstr("warm is 1.50 times the reference alone; cold is 0.20 s more than warm\n"));
  EXPECT_THAT(text, ContainsRegex("results and pictures +1.500 s\n"));
}

}  // namespace
}  // namespace fillrule::terminal
