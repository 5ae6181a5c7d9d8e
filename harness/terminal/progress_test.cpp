#include "harness/terminal/progress.h"

#include <gtest/gtest.h>

namespace fillrule::terminal {
namespace {

TEST(ProgressText, TellsHowFarHowFastAndHowLongStill) {
  EXPECT_EQ(progress_text(50, 200, 2, 90),
            "[##########..............................]  50 of 200 cases, 25 a second, 6 s left");
  EXPECT_EQ(progress_text(1, 4637, 4, 70), "[..................]    1 of 4637 cases, 0.2 a second, 5 h 09 min left");
  EXPECT_EQ(progress_text(100, 1000, 10, 64), "[#............]  100 of 1000 cases, 10 a second, 1 min 30 s left");
}

TEST(ProgressText, NothingIsKnownBeforeTheFirstCase) {
  EXPECT_EQ(progress_text(0, 9, 1.5, 40), "[.........................] 0 of 9 cases");
  EXPECT_EQ(progress_text(0, 0, 0, 40), "0 of 0 cases");
}

TEST(ProgressText, ANarrowTerminalLosesTheBarAndThenTheEnd) {
  EXPECT_EQ(progress_text(50, 200, 2, 45), " 50 of 200 cases, 25 a second, 6 s left");
  EXPECT_EQ(progress_text(50, 200, 2, 20), " 50 of 200 cases, 25");
  EXPECT_EQ(progress_text(50, 200, 2, 0), "");
}

TEST(ProgressClock, AfterASecondAndThenTenTimesASecond) {
  ProgressClock clock;
  EXPECT_FALSE(clock.is_due(0.5));
  EXPECT_TRUE(clock.is_due(1.0));
  EXPECT_FALSE(clock.is_due(1.05));
  EXPECT_TRUE(clock.is_due(1.11));
}

}  // namespace
}  // namespace fillrule::terminal
