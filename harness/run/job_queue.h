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

  // Of the pictures.
  [[nodiscard]] size_t bytes() const {
    size_t sum = 0;
    if (reference.planes) sum += bytes_of(*reference.planes);
    if (reference.colors && *reference.colors) sum += bytes_of(**reference.colors);
    return sum;
  }

 private:
  static size_t bytes_of(const Planes& planes) {
    constexpr size_t kPlanesOfAll = 4;
    return planes.hits.size() * sizeof(float) * (kPlanesOfAll + planes.varyings.size());
  }
};

// Jobs from some threads to many. They wait where pictures of more than `capacity_bytes` would pile up, unless there
// is but one.
class JobQueue {
 public:
  explicit JobQueue(size_t capacity_bytes) : capacity_bytes_(capacity_bytes) {}

  void push(Job job) {
    const size_t bytes = job.bytes();
    std::unique_lock lock(mutex_);
    space_.wait(lock, [this, bytes] { return jobs_.empty() || waiting_bytes_ + bytes <= capacity_bytes_; });
    waiting_bytes_ += bytes;
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
    waiting_bytes_ -= job.bytes();
    space_.notify_all();
    return job;
  }

 private:
  size_t capacity_bytes_;
  size_t waiting_bytes_ = 0;
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
