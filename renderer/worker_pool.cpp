#include "renderer/worker_pool.h"

namespace fillrule::renderer {

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
  {
    const std::scoped_lock lock(mutex_);
    body_ = &body;
    count_ = count;
    next_ = 0;
    busy_ = workers_.size();
    ++generation_;
  }
  work_ready_.notify_all();
  take_all(body, count);
  std::unique_lock lock(mutex_);
  work_done_.wait(lock, [this] { return busy_ == 0; });
}

void WorkerPool::start() {
  while (workers_.size() + 1 < threads_) {
    workers_.emplace_back([this] { work(); });
  }
}

void WorkerPool::take_all(const std::function<void(size_t)>& body, size_t count) {
  for (size_t i = next_++; i < count; i = next_++) {
    body(i);
  }
}

void WorkerPool::work() {
  uint64_t seen = 0;
  std::unique_lock lock(mutex_);
  while (true) {
    work_ready_.wait(lock, [&] { return stopping_ || generation_ != seen; });
    if (stopping_) {
      return;
    }
    seen = generation_;
    const std::function<void(size_t)>& body = *body_;
    const size_t count = count_;
    lock.unlock();
    take_all(body, count);
    lock.lock();
    if (--busy_ == 0) {
      work_done_.notify_one();
    }
  }
}

}  // namespace fillrule::renderer
