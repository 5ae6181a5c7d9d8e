#include "harness/exhaust/exhaust.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>

#include "harness/exhaust/state.h"

namespace fillrule::exhaust {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds kSavePeriod{3};

struct BatchResult {
  uint32_t triangles = 0;
  uint32_t covering = 0;
  Comparison candidate;
  Comparison reference;
};

void add(const Comparison& comparison, size_t max_differences, Findings& findings) {
  findings.tally.add(comparison.tally);
  for (const Difference& difference : comparison.first) {
    if (findings.first.size() < max_differences) findings.first.push_back(difference);
  }
}

// One session. Threads take batches in order and deliver them in any; what is known grows in order again.
class Session {
 public:
  Session(const Options& options, const Parties& parties, const OnProgress& on_progress, const Progress& begin)
      : options_(options),
        parties_(parties),
        on_progress_(on_progress),
        identity_(identity_of(options, parties)),
        layout_(options.world, options.target_size),
        oracle_(options.world.grid, options.world.size),
        total_(triple_count(options.world)),
        next_(begin.triangles),
        seconds_before_(begin.seconds),
        progress_(begin) {}

  // True if the world is finished.
  Result<bool> run();

  [[nodiscard]] const Progress& progress() const { return progress_; }

 private:
  void work();
  // The number of the next batch's first triangle, or total_ if there is nothing left to do.
  uint64_t take();
  Result<BatchResult> draw(uint64_t first, Batch& batch, std::vector<uint8_t>& hits);
  Result<Comparison> draw(const Party& party, const Batch& batch, std::vector<uint8_t>& hits);
  void deliver(uint64_t first, Result<BatchResult> result);
  void save();

  const Options& options_;
  const Parties& parties_;
  const OnProgress& on_progress_;
  std::string identity_;
  CellLayout layout_;
  exact::SmallWorld oracle_;
  uint64_t total_;

  std::mutex mutex_;  // of everything below
  uint64_t next_;
  bool stopped_ = false;
  std::optional<Error> error_;
  std::map<uint64_t, BatchResult> waiting_;  // by the number of the first triangle
  Clock::time_point begin_ = Clock::now();
  Clock::time_point saved_ = begin_;
  double seconds_before_;
  Progress progress_;
};

Result<bool> Session::run() {
  std::vector<std::thread> threads;
  for (uint32_t i = 1; i < options_.threads; ++i) threads.emplace_back([this] { work(); });
  work();
  for (std::thread& thread : threads) thread.join();
  if (!error_ && stopped_) save();
  if (error_) return tl::unexpected(*error_);
  return progress_.triangles == total_;
}

void Session::work() {
  Batch batch;
  std::vector<uint8_t> hits(size_t{layout_.target_size()} * layout_.target_size());
  for (uint64_t first = take(); first < total_; first = take()) deliver(first, draw(first, batch, hits));
}

uint64_t Session::take() {
  const std::scoped_lock lock(mutex_);
  if (stopped_ || error_) return total_;
  const uint64_t first = next_;
  next_ = std::min(next_ + layout_.capacity(), total_);
  return first;
}

Result<BatchResult> Session::draw(uint64_t first, Batch& batch, std::vector<uint8_t>& hits) {
  const auto triangles = static_cast<uint32_t>(std::min<uint64_t>(layout_.capacity(), total_ - first));
  fill(options_.world, oracle_, layout_, options_.cull_mode, first, triangles, batch);
  BatchResult result{.triangles = triangles, .covering = batch.covering};
  Result<Comparison> candidate = draw(parties_.candidate, batch, hits);
  if (!candidate) return tl::unexpected(candidate.error());
  result.candidate = std::move(*candidate);
  if (parties_.reference) {
    Result<Comparison> reference = draw(*parties_.reference, batch, hits);
    if (!reference) return tl::unexpected(reference.error());
    result.reference = std::move(*reference);
  }
  return result;
}

Result<Comparison> Session::draw(const Party& party, const Batch& batch, std::vector<uint8_t>& hits) {
  const HitDraw draw{
      .positions_clip = batch.positions_clip, .target_size = layout_.target_size(), .cull_mode = options_.cull_mode};
  if (const Result<void> drawn = party.draw(draw, hits); !drawn) return tl::unexpected(drawn.error());
  return compare({.world = options_.world,
                  .layout = layout_,
                  .cull_mode = options_.cull_mode,
                  .subpixel_bits = party.subpixel_bits},
                 batch, hits, options_.max_differences);
}

void Session::deliver(uint64_t first, Result<BatchResult> result) {
  const std::scoped_lock lock(mutex_);
  if (!result) {
    error_ = result.error();
    return;
  }
  waiting_.emplace(first, std::move(*result));
  for (auto next = waiting_.find(progress_.triangles); next != waiting_.end();
       next = waiting_.find(progress_.triangles)) {
    const BatchResult& done = next->second;
    progress_.triangles += done.triangles;
    progress_.covering += done.covering;
    add(done.candidate, options_.max_differences, progress_.candidate);
    add(done.reference, options_.max_differences, progress_.reference);
    waiting_.erase(next);
  }
  const Clock::time_point now = Clock::now();
  progress_.seconds = seconds_before_ + std::chrono::duration<double>(now - begin_).count();
  if (now - saved_ >= kSavePeriod && progress_.triangles < total_) {
    save();
    saved_ = now;
  }
  if (!on_progress_(progress_)) stopped_ = true;
}

void Session::save() {
  if (options_.state_file.empty()) return;
  const Result<void> saved = save_state(options_.state_file, identity_, progress_);
  if (!saved) error_ = saved.error();
}

}  // namespace

Result<Outcome> exhaust(const Options& options, const Parties& parties, const OnProgress& on_progress) {
  if (const Result<void> checked = check_world(options.world.grid, options.world.size); !checked) {
    return tl::unexpected(checked.error());
  }
  Outcome outcome;
  if (!options.state_file.empty() && !options.fresh) {
    const auto loaded = load_state(options.state_file, identity_of(options, parties));
    if (!loaded) {
      outcome.note = to_string(loaded.error());
    } else if (*loaded) {
      outcome.progress = **loaded;
      outcome.resumed_from = outcome.progress.triangles;
    }
  }
  on_progress(outcome.progress);
  Session session(options, parties, on_progress, outcome.progress);
  const Result<bool> finished = session.run();
  if (!finished) return tl::unexpected(finished.error());
  outcome.progress = session.progress();
  outcome.finished = *finished;
  if (outcome.finished && !options.state_file.empty()) {
    std::error_code ignored;
    std::filesystem::remove(options.state_file, ignored);
  }
  return outcome;
}

uint64_t asymmetric_triangles(const World& world) {
  const exact::SmallWorld oracle(world.grid, world.size);
  const auto are_equal = [](const exact::WoundCoverage& p, const exact::WoundCoverage& q) {
    return p.clockwise == q.clockwise && p.counter_clockwise == q.counter_clockwise;
  };
  const auto is_asymmetric = [&](uint32_t a, uint32_t b, uint32_t c) {
    const exact::WoundCoverage forward = oracle.coverage(a, b, c);
    const exact::WoundCoverage reversed{.clockwise = forward.counter_clockwise,
                                        .counter_clockwise = forward.clockwise};
    return !(are_equal(forward, oracle.coverage(b, c, a)) && are_equal(forward, oracle.coverage(c, a, b)) &&
             are_equal(reversed, oracle.coverage(a, c, b)) && are_equal(reversed, oracle.coverage(c, b, a)) &&
             are_equal(reversed, oracle.coverage(b, a, c)));
  };
  uint64_t count = 0;
  for (uint32_t a = 0; a < oracle.positions(); ++a) {
    for (uint32_t b = a; b < oracle.positions(); ++b) {
      for (uint32_t c = b; c < oracle.positions(); ++c) count += is_asymmetric(a, b, c) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace fillrule::exhaust
