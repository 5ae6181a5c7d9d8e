// Threads that share loops: started when there is work enough for them, gone with their pool.
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
  explicit WorkerPool(uint32_t threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  WorkerPool(WorkerPool&&) = delete;
  WorkerPool& operator=(WorkerPool&&) = delete;

  [[nodiscard]] uint32_t threads() const { return threads_; }

  // Calls body(0) ... body(count - 1), each once, in any order and from any thread; returns when all are done. What
  // is worth less than kMinParallelCost (very roughly nanoseconds) runs on the calling thread.
  //
  // Every threads-th call, beginning with another one each, is a thread's own; only when it has no more of those it
  // takes others': from one loop to the next a thread then finds most of what it works on in its own cache, and to
  // fetch it from another processor's costs hundreds of nanoseconds.
  void parallel_for(size_t count, size_t cost, const std::function<void(size_t)>& body);

  static constexpr size_t kMinParallelCost = 200'000;
  static constexpr size_t kMinCostToLookOut = 1'000'000;

  // While there is one, more loops are coming: threads without work look out for the next one, for a while, before
  // they sleep. To be woken takes tens of microseconds, in each of a draw's loops. After short loops, worth less than
  // kMinCostToLookOut, they do not: whoever has many of those has other work for the processor.
  class Awake {
   public:
    explicit Awake(WorkerPool& pool) : pool_(pool) { pool_.is_awake_ = true; }
    ~Awake() { pool_.is_awake_ = false; }
    Awake(const Awake&) = delete;
    Awake& operator=(const Awake&) = delete;
    Awake(Awake&&) = delete;
    Awake& operator=(Awake&&) = delete;

   private:
    WorkerPool& pool_;
  };

 private:
  // How many of a thread's own calls were begun; on a line of the cache of its own.
  struct alignas(64) Begun {
    std::atomic<size_t> calls = 0;
  };

  void start();
  void keep_workers_off_own_processor();
  void work(uint32_t thread);
  // Returns once `is_ready()`, or after a while.
  template <typename IsReady>
  void look_out(const IsReady& is_ready) const;
  void take_all(uint32_t thread, const std::function<void(size_t)>& body, size_t count);

  uint32_t threads_;
  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable work_ready_;
  std::condition_variable work_done_;
  const std::function<void(size_t)>* body_ = nullptr;
  size_t count_ = 0;
  std::vector<Begun> begun_;  // thread by thread
  // Changed under the mutex; read without it by threads that look out.
  std::atomic<size_t> busy_ = 0;
  std::atomic<uint64_t> generation_ = 0;
  std::atomic<bool> is_long_ = false;   // the loop is worth kMinCostToLookOut
  std::atomic<bool> is_awake_ = false;  // changed by the thread that draws
  bool has_processors_ = false;         // one for each thread
  int avoided_processor_ = -1;          // by all workers
  bool stopping_ = false;
};

// The calling thread's own pool, kept until it asks for another number of threads or ends: to start one costs more
// than a tenth of a millisecond, a good part of a short draw.
WorkerPool& own_workers(uint32_t threads);

}  // namespace fillrule::renderer
