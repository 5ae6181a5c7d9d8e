#include "renderer/worker_pool.h"

#include <gmock/gmock.h>

#if defined(__linux__)
#include <sched.h>
#endif

#include <array>
#include <set>

namespace fillrule::renderer {
namespace {

// One call on each of the pool's threads. Each waits for the others: it ends only if all run at the same time.
template <typename Body>
void call_on_all_at_once(WorkerPool& pool, const Body& body) {
  std::atomic<uint32_t> arrived = 0;
  pool.parallel_for(pool.threads(), WorkerPool::kMinParallelCost, [&](size_t call) {
    body(call);
    ++arrived;
    while (arrived < pool.threads()) {
      std::this_thread::yield();
    }
  });
}

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

TEST(WorkerPool, DoesEveryIndexOnceInLoopsThatFollowEachOther) {
  for (const uint32_t threads : {2U, 7U}) {
    WorkerPool pool(threads);
    std::atomic<int> calls = 0;
    for (int draw = 0; draw < 20; ++draw) {
      const WorkerPool::Awake awake(pool);
      for (int loop = 0; loop < 10; ++loop) {
        const size_t cost = loop % 2 == 0 ? WorkerPool::kMinCostToLookOut : WorkerPool::kMinParallelCost;
        pool.parallel_for(13, cost, [&](size_t) { ++calls; });
      }
    }
    EXPECT_EQ(calls, 20 * 10 * 13) << threads << " threads";
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
  std::atomic<int> calls = 0;
  call_on_all_at_once(pool, [&](size_t) { ++calls; });
  EXPECT_EQ(calls, 3);
}

TEST(WorkerPool, AThreadBeginsEveryLoopWithItsOwnCalls) {
  constexpr size_t kThreads = 4;
  WorkerPool pool(kThreads);
  std::array<std::set<std::thread::id>, kThreads> threads_of_call;
  for (size_t loop = 1; loop <= 50; ++loop) {
    // At once, so that nobody can take another's.
    call_on_all_at_once(pool, [&](size_t call) { threads_of_call[call].insert(std::this_thread::get_id()); });
  }
  EXPECT_THAT(threads_of_call, ::testing::Each(::testing::SizeIs(1)));
}

#if defined(__linux__)
TEST(WorkerPool, WorkersKeepOffOneProcessor) {
  cpu_set_t all;
  ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
  if (CPU_COUNT(&all) < 2) {
    GTEST_SKIP() << "there is one processor, which nobody can keep off";
  }
  WorkerPool pool(2);
  const std::thread::id caller = std::this_thread::get_id();
  cpu_set_t of_worker;
  CPU_ZERO(&of_worker);
  call_on_all_at_once(pool, [&](size_t) {
    if (std::this_thread::get_id() != caller) {
      EXPECT_EQ(sched_getaffinity(0, sizeof of_worker, &of_worker), 0);
    }
  });
  EXPECT_EQ(CPU_COUNT(&of_worker), CPU_COUNT(&all) - 1);
  cpu_set_t of_caller;
  ASSERT_EQ(sched_getaffinity(0, sizeof of_caller, &of_caller), 0);
  EXPECT_TRUE(CPU_EQUAL(&of_caller, &all));
}

TEST(WorkerPool, ABoundThreadHasWorkersToo) {
  std::thread([] {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<size_t>(std::max(sched_getcpu(), 0)), &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    WorkerPool pool(2);
    std::atomic<int> calls = 0;
    call_on_all_at_once(pool, [&](size_t) { ++calls; });
    EXPECT_EQ(calls, 2);
  }).join();
}
#endif

TEST(WorkerPool, AThreadKeepsItsOwnPool) {
  WorkerPool& two = own_workers(2);
  EXPECT_EQ(&own_workers(2), &two);
  EXPECT_EQ(two.threads(), 2U);
  EXPECT_EQ(own_workers(3).threads(), 3U);
  std::thread([] { EXPECT_EQ(own_workers(4).threads(), 4U); }).join();
  EXPECT_EQ(own_workers(3).threads(), 3U);
}

}  // namespace
}  // namespace fillrule::renderer
