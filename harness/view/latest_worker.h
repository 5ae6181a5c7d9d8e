// A thread that always does the newest of the jobs it has been given, and drops those between: what keeps a window
// responsive while something slow is drawn for it.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace fillrule::view {

// `work` runs on the worker's thread alone. What it gives belongs to the worker until it is finished, so whoever
// takes it never sees half of a picture.
template <typename Job, typename Outcome>
class LatestWorker {
 public:
  explicit LatestWorker(std::function<Outcome(const Job&)> work)
      : work_(std::move(work)), thread_([this] { run(); }) {}
  ~LatestWorker() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  LatestWorker(const LatestWorker&) = delete;
  LatestWorker(LatestWorker&&) = delete;
  LatestWorker& operator=(const LatestWorker&) = delete;
  LatestWorker& operator=(LatestWorker&&) = delete;

  // Instead of the job that waits, if one does.
  void submit(Job job) {
    {
      const std::lock_guard lock(mutex_);
      waiting_ = std::move(job);
    }
    changed_.notify_all();
  }

  // The newest outcome, once.
  std::optional<Outcome> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(finished_, std::nullopt);
  }

  // Until nothing waits or is under way.
  void wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !waiting_ && !working_; });
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return stopping_ || waiting_; });
      if (stopping_) return;
      const Job job = *std::exchange(waiting_, std::nullopt);
      working_ = true;
      lock.unlock();
      Outcome outcome = work_(job);
      lock.lock();
      working_ = false;
      finished_ = std::move(outcome);
      changed_.notify_all();
    }
  }

  std::function<Outcome(const Job&)> work_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Job> waiting_;
  std::optional<Outcome> finished_;
  bool working_ = false;
  bool stopping_ = false;
  std::thread thread_;  // the last member: it starts when all others are there
};

}  // namespace fillrule::view
