// Cases on their way from the thread that draws with the reference to those that judge.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "cases/model/planes.h"
#include "cases/model/result.h"

namespace fillrule::run {

// What the reference drew of a case; nothing where the candidate is alone with the oracle.
struct ReferenceDrawing {
  std::optional<Planes> planes;
  std::optional<Result<Planes>> colors;  // of a scene
};

// What a worker takes: a case, its place in the results and what the reference drew.
struct Job {
  size_t index = 0;
  ReferenceDrawing reference;
};

// Jobs from one thread to many, at most `capacity` waiting, so that pictures do not pile up.
class JobQueue {
 public:
  explicit JobQueue(size_t capacity) : capacity_(capacity) {}

  void push(Job job) {
    std::unique_lock lock(mutex_);
    space_.wait(lock, [this] { return jobs_.size() < capacity_; });
    jobs_.push_back(std::move(job));
    ready_.notify_one();
  }

  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    ready_.notify_all();
  }

  // Empty when the queue has been closed and emptied.
  std::optional<Job> pop() {
    std::unique_lock lock(mutex_);
    ready_.wait(lock, [this] { return closed_ || !jobs_.empty(); });
    if (jobs_.empty()) return std::nullopt;
    Job job = std::move(jobs_.front());
    jobs_.pop_front();
    space_.notify_one();
    return job;
  }

 private:
  size_t capacity_;
  std::mutex mutex_;
  std::condition_variable ready_;
  std::condition_variable space_;
  std::deque<Job> jobs_;
  bool closed_ = false;
};

// Starts `count` threads and waits for them at the end of the scope.
class Workers {
 public:
  template <typename Work>
  Workers(uint32_t count, Work work) {
    for (uint32_t i = 0; i < count; ++i) threads_.emplace_back([work, i] { work(i); });
  }

 private:
  std::vector<std::jthread> threads_;
};

}  // namespace fillrule::run
