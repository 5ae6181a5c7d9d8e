#include "renderer/worker_pool.h"

#include <gmock/gmock.h>

#include <set>

namespace fillrule::renderer {
namespace {

TEST(WorkerPool, DoesEveryIndexOnceHoweverOftenItIsUsed) {
  for (const uint32_t threads : {1U, 2U, 7U}) {
    WorkerPool pool(threads);
    for (const size_t count : {0U, 1U, 2U, 1000U}) {
      std::vector<std::atomic<int>> calls(count);
      pool.parallel_for(count, WorkerPool::kMinParallelCost, [&](size_t i) { ++calls[i]; });
      for (const std::atomic<int>& times : calls) {
        EXPECT_EQ(times, 1) << threads << " threads";
      }
    }
  }
}

TEST(WorkerPool, SmallWorkStaysOnTheCallingThread) {
  WorkerPool pool(4);
  std::set<std::thread::id> ids;
  pool.parallel_for(100, WorkerPool::kMinParallelCost - 1, [&](size_t) { ids.insert(std::this_thread::get_id()); });
  EXPECT_THAT(ids, ::testing::ElementsAre(std::this_thread::get_id()));
}

TEST(WorkerPool, LargeWorkRunsOnSeveralThreadsAtOnce) {
  WorkerPool pool(3);
  // Each waits for the other two: it ends only if all three run at the same time.
  std::atomic<int> arrived = 0;
  pool.parallel_for(3, WorkerPool::kMinParallelCost, [&](size_t) {
    ++arrived;
    while (arrived < 3) {
      std::this_thread::yield();
    }
  });
  EXPECT_EQ(arrived, 3);
}

}  // namespace
}  // namespace fillrule::renderer
