// Wall time, and processor time, which does not run while a thread waits.
#pragma once

#include <ctime>
#include <utility>

#include "harness/run/timing.h"

namespace fillrule::run {

inline double seconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Wall time since it was made.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return seconds_of(CLOCK_MONOTONIC) - start_; }

 private:
  double start_ = seconds_of(CLOCK_MONOTONIC);
};

// Time since the last call, or since it was made.
template <clockid_t clock>
class LapStopwatch {
 public:
  double lap() {
    const double before = std::exchange(last_, seconds_of(clock));
    return last_ - before;
  }

 private:
  double last_ = seconds_of(clock);
};
using WallLaps = LapStopwatch<CLOCK_MONOTONIC>;
// The calling thread's processor time. Each call asks the system, which takes twenty times as long as the wall time.
using ThreadLaps = LapStopwatch<CLOCK_THREAD_CPUTIME_ID>;

// Wall and processor time of what `work` does.
template <typename Work>
RunTiming timed(const Work& work) {
  RunTiming timing;
  const Stopwatch wall;
  const double processor = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
  work(timing);
  timing.processor_seconds = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - processor;
  timing.wall_seconds = wall.seconds();
  return timing;
}

}  // namespace fillrule::run
