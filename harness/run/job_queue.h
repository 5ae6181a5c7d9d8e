// Cases on their way from being drawn with the reference to being judged.
#pragma once

#include <algorithm>
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

// Jobs that all of some threads take, and a few of them make, too, until there is nothing left to make.
class JobQueue {
 public:
  JobQueue(size_t threads, size_t makers) : threads_(threads), makers_(makers) {}

  void push(Job job) {
    const std::lock_guard lock(mutex_);
    waiting_bytes_ += job.bytes();
    jobs_.push_back(std::move(job));
    ready_.notify_one();
  }

  // A thread makes no more of them.
  void stop_making() {
    const std::lock_guard lock(mutex_);
    --makers_;
    ready_.notify_all();
  }

  // Whether one that makes jobs had better do so now: fewer than `ahead` wait for each thread that only takes them,
  // or none at all, and their pictures have fewer bytes than these. One that is behind the others works ahead, as if
  // there were one thread more that only takes jobs.
  [[nodiscard]] bool is_short(size_t ahead, size_t bytes, bool is_behind = false) {
    const std::lock_guard lock(mutex_);
    const size_t takers = threads_ - makers_ + (is_behind ? 1 : 0);
    return jobs_.size() < std::max<size_t>(takers * ahead, 1) && waiting_bytes_ < bytes;
  }

  // Empty when no job waits and none will come.
  std::optional<Job> pop() {
    std::unique_lock lock(mutex_);
    ready_.wait(lock, [this] { return makers_ == 0 || !jobs_.empty(); });
    return take();
  }

  // Empty when no job waits.
  std::optional<Job> try_pop() {
    const std::lock_guard lock(mutex_);
    return take();
  }

 private:
  std::optional<Job> take() {
    if (jobs_.empty()) return std::nullopt;
    Job job = std::move(jobs_.front());
    jobs_.pop_front();
    waiting_bytes_ -= job.bytes();
    return job;
  }

  std::mutex mutex_;
  std::condition_variable ready_;
  size_t threads_;
  size_t makers_;
  std::deque<Job> jobs_;
  size_t waiting_bytes_ = 0;
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
