// Threads for one draw: started when there is work enough for them, gone with the pool.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace fillrule::renderer {

class WorkerPool {
 public:
  // `threads` counts the calling one; 1 never starts any.
  explicit WorkerPool(uint32_t threads) : threads_(threads) {}
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  WorkerPool(WorkerPool&&) = delete;
  WorkerPool& operator=(WorkerPool&&) = delete;

  // Calls body(0) ... body(count - 1), each once, in any order and from any thread; returns when all are done. What
  // is worth less than kMinParallelCost (very roughly nanoseconds) runs on the calling thread.
  void parallel_for(size_t count, size_t cost, const std::function<void(size_t)>& body);

  static constexpr size_t kMinParallelCost = 200'000;

 private:
  void start();
  void work();
  void take_all(const std::function<void(size_t)>& body, size_t count);

  uint32_t threads_;
  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable work_ready_;
  std::condition_variable work_done_;
  const std::function<void(size_t)>* body_ = nullptr;
  size_t count_ = 0;
  std::atomic<size_t> next_ = 0;
  size_t busy_ = 0;
  uint64_t generation_ = 0;
  bool stopping_ = false;
};

}  // namespace fillrule::renderer
