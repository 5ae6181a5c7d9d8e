#include "renderer/worker_pool.h"

#if defined(__linux__)
#include <pthread.h>
#include <sched.h>
#endif

#include <chrono>
#include <optional>

namespace fillrule::renderer {

namespace {

// So that a hardware thread that waits leaves the core to the other one.
void relax() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

WorkerPool::WorkerPool(uint32_t threads) : threads_(threads), begun_(threads) {}

template <typename IsReady>
void WorkerPool::look_out(const IsReady& is_ready) const {
  if (!has_processors_ || !is_long_) {
    return;
  }
  constexpr std::chrono::microseconds kPatience{100};  // some tiles' worth
  const auto give_up = std::chrono::steady_clock::now() + kPatience;
  while (!is_ready() && std::chrono::steady_clock::now() < give_up) {
    relax();
  }
}

WorkerPool::~WorkerPool() {
  {
    const std::scoped_lock lock(mutex_);
    stopping_ = true;
  }
  work_ready_.notify_all();
  for (std::thread& worker : workers_) {
    worker.join();
  }
}

void WorkerPool::parallel_for(size_t count, size_t cost, const std::function<void(size_t)>& body) {
  if (threads_ <= 1 || count <= 1 || cost < kMinParallelCost) {
    for (size_t i = 0; i < count; ++i) {
      body(i);
    }
    return;
  }
  start();
  keep_workers_off_own_processor();
  {
    const std::scoped_lock lock(mutex_);
    body_ = &body;
    count_ = count;
    for (Begun& begun : begun_) {
      begun.calls = 0;
    }
    busy_ = workers_.size();
    is_long_ = cost >= kMinCostToLookOut;
    ++generation_;
  }
  work_ready_.notify_all();
  take_all(0, body, count);
  look_out([this] { return busy_ == 0; });
  std::unique_lock lock(mutex_);
  work_done_.wait(lock, [this] { return busy_ == 0; });
}

void WorkerPool::start() {
  if (workers_.empty()) {
    // Asked of files of the system: a good part of a short draw that starts nobody.
    has_processors_ = threads_ <= std::thread::hardware_concurrency();
  }
  while (workers_.size() + 1 < threads_) {
    workers_.emplace_back([this, thread = static_cast<uint32_t>(workers_.size()) + 1] { work(thread); });
  }
}

// Linux may wake a thread on its waker's processor though another one is idle, as was seen on a virtual machine. The
// thread then waits, milliseconds, until the calling one has done all the work.
void WorkerPool::keep_workers_off_own_processor() {
#if defined(__linux__)
  const int own = sched_getcpu();
  if (!has_processors_ || own < 0 || own == avoided_processor_) {
    return;
  }
  cpu_set_t others;
  if (sched_getaffinity(0, sizeof others, &others) != 0) {
    return;
  }
  CPU_CLR(static_cast<size_t>(own), &others);
  if (static_cast<size_t>(CPU_COUNT(&others)) < workers_.size()) {
    return;  // the calling thread is bound to some
  }
  for (std::thread& worker : workers_) {
    static_cast<void>(pthread_setaffinity_np(worker.native_handle(), sizeof others, &others));  // a wish
  }
  avoided_processor_ = own;
#endif
}

void WorkerPool::take_all(uint32_t thread, const std::function<void(size_t)>& body, size_t count) {
  for (uint32_t i = 0; i < threads_; ++i) {
    const uint32_t owner = (thread + i) % threads_;
    const auto next = [&] { return owner + begun_[owner].calls++ * threads_; };
    for (size_t call = next(); call < count; call = next()) {
      body(call);
    }
  }
}

void WorkerPool::work(uint32_t thread) {
  uint64_t seen = 0;
  while (true) {
    look_out([&] { return generation_ != seen || !is_awake_; });
    std::unique_lock lock(mutex_);
    work_ready_.wait(lock, [&] { return stopping_ || generation_ != seen; });
    if (stopping_) {
      return;
    }
    seen = generation_;
    const std::function<void(size_t)>& body = *body_;
    const size_t count = count_;
    lock.unlock();
    take_all(thread, body, count);
    lock.lock();
    if (--busy_ == 0) {
      work_done_.notify_one();
    }
  }
}

WorkerPool& own_workers(uint32_t threads) {
  static thread_local std::optional<WorkerPool> workers;
  if (!workers || workers->threads() != threads) {
    workers.emplace(threads);
  }
  return *workers;
}

}  // namespace fillrule::renderer
