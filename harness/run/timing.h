// Where the time of a run goes. All in seconds.
#pragma once

#include <optional>

namespace fillrule::run {

// Where the time of one run over all cases went. Parts are in processor time, summed over threads, so that they add
// up and a thread that waits for another counts for nothing.
struct RunTiming {
  double wall_seconds = 0;
  double processor_seconds = 0;  // of the whole process, the driver's own threads included
  double candidate_seconds = 0;  // drawing each case once
  double oracle_seconds = 0;     // what must and may be covered
  double judge_seconds = 0;      // the verdicts, exact values included
  double check_seconds = 0;      // the metamorphic checks

  // What is left: the reference's drawing and reading back, and handing cases round.
  [[nodiscard]] double reference_seconds() const {
    return processor_seconds - candidate_seconds - oracle_seconds - judge_seconds - check_seconds;
  }
  // Every part so many times.
  [[nodiscard]] RunTiming scaled(double factor) const {
    return {.candidate_seconds = candidate_seconds * factor,
            .oracle_seconds = oracle_seconds * factor,
            .judge_seconds = judge_seconds * factor,
            .check_seconds = check_seconds * factor};
  }
  RunTiming& operator+=(const RunTiming& other) {
    wall_seconds += other.wall_seconds;
    processor_seconds += other.processor_seconds;
    candidate_seconds += other.candidate_seconds;
    oracle_seconds += other.oracle_seconds;
    judge_seconds += other.judge_seconds;
    check_seconds += other.check_seconds;
    return *this;
  }
};

struct Timing {
  RunTiming run;  // the run itself, pipelines made on the way
  // The same once more, now that every pipeline is there: the suite, and the reference's drawing and reading back of
  // the same batches with nothing else going on; in turn, the median of three each.
  struct Warm {
    RunTiming suite;
    RunTiming reference_alone;
  };
  std::optional<Warm> warm;
};

}  // namespace fillrule::run
