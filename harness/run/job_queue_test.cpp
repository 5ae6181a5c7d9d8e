#include "harness/run/job_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace fillrule::run {
namespace {

constexpr size_t kPlenty = size_t{1} << 30U;

// One sample of each plane: 16 bytes.
Job job_with_picture(size_t index) {
  return {.index = index, .reference = {.planes = Planes::cleared(1, 1, 1, 0, 0)}};
}

TEST(JobQueue, IsShortWhileOthersWouldSoonHaveNothingToTake) {
  JobQueue queue(3, 2);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(queue.is_short(4, kPlenty)) << i;
    queue.push({.index = i});
  }
  EXPECT_FALSE(queue.is_short(4, kPlenty));
  // A second thread that only takes jobs.
  queue.stop_making();
  EXPECT_TRUE(queue.is_short(4, kPlenty));
}

TEST(JobQueue, IsShortOfJobsThatMakersTakeThemselvesWhenItIsEmpty) {
  JobQueue queue(2, 2);
  EXPECT_TRUE(queue.is_short(4, kPlenty));
  queue.push({.index = 7});
  EXPECT_FALSE(queue.is_short(4, kPlenty));
  EXPECT_EQ(queue.try_pop()->index, 7U);
  EXPECT_FALSE(queue.try_pop());
}

TEST(JobQueue, IsShortForOneThatIsBehindUntilSomeAreAhead) {
  JobQueue queue(2, 2);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(queue.is_short(4, kPlenty, true)) << i;
    queue.push({.index = i});
    EXPECT_FALSE(queue.is_short(4, kPlenty, false)) << i;
  }
  EXPECT_FALSE(queue.is_short(4, kPlenty, true));
}

TEST(JobQueue, IsNeverShortWhilePicturesPileUp) {
  JobQueue queue(8, 1);
  queue.push(job_with_picture(0));
  EXPECT_TRUE(queue.is_short(4, 17));
  queue.push(job_with_picture(1));
  EXPECT_FALSE(queue.is_short(4, 17));
  EXPECT_TRUE(queue.try_pop());
  EXPECT_TRUE(queue.is_short(4, 17));
}

TEST(JobQueue, KeepsTakersUntilNothingIsLeftAndNobodyMakesMore) {
  constexpr size_t kJobs = 20;
  JobQueue queue(3, 1);
  std::atomic<size_t> taken = 0;
  const auto wait_until_taken = [&](size_t jobs) {
    for (int i = 0; i < 2000 && taken < jobs; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return taken == jobs;
  };
  {
    const Workers takers(2, [&](uint32_t) {
      while (queue.pop()) ++taken;
    });
    // Each when the queue has been empty.
    for (size_t i = 0; i < kJobs; ++i) {
      queue.push({.index = i});
      ASSERT_TRUE(wait_until_taken(i + 1)) << i;
    }
    queue.stop_making();
  }
  EXPECT_EQ(taken, kJobs);
}

}  // namespace
}  // namespace fillrule::run
