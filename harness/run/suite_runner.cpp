#include "harness/run/suite_runner.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "harness/run/reference.h"
#include "harness/scene/check.h"
#include "reference/exact/features.h"

namespace fillrule::run {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// So many cases are handed to the reference at once: enough to share a submission, few enough that judging starts
// soon.
constexpr size_t kBatchSize = 32;

// What a worker takes: a case, its place in the results and what the reference drew.
struct Job {
  size_t index = 0;
  std::unique_ptr<const Planes> reference;  // none where the candidate is alone with the oracle
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

}  // namespace

struct SuiteRunner::State {
  RunOptions options;
  Candidate candidate;
  std::optional<vulkan::Reference> reference;
  scene::Painter reference_paint;  // empty without a reference
  std::unique_ptr<scene::Assets> assets = std::make_unique<scene::Assets>();

  // The colours of a scene; nothing of other cases, nor where the candidate cannot draw in colour.
  [[nodiscard]] std::optional<judge::CheckResult> check_colors(const Case& test_case, bool with_reference) const {
    if (!test_case.scene || !candidate.paint) return std::nullopt;
    const scene::PaintingParty candidate_party{candidate.paint, candidate.subpixel_bits};
    if (!with_reference) return scene::check_scene(test_case, *assets, candidate_party, nullptr);
    const scene::PaintingParty reference_party{reference_paint, reference->device().subpixel_bits};
    return scene::check_scene(test_case, *assets, candidate_party, &reference_party);
  }

  [[nodiscard]] judge::CaseVerdict judge_case(const Case& test_case, const Planes& candidate_planes,
                                              const Planes* reference_planes, bool keep_maps) const {
    const judge::Party candidate_party{.planes = &candidate_planes, .subpixel_bits = candidate.subpixel_bits};
    const judge::Settings settings{.profile = options.profile, .keep_maps = keep_maps};
    if (reference_planes == nullptr) return judge::judge(test_case, candidate_party, nullptr, settings);
    const judge::Party reference_party{.planes = reference_planes,
                                       .subpixel_bits = reference->device().subpixel_bits};
    return judge::judge(test_case, candidate_party, &reference_party, settings);
  }

  // Whether the candidate can draw the case and the oracle judge it.
  [[nodiscard]] Result<void> can_finish(const Case& test_case) const {
    const FeatureSet unjudged = features_of(test_case).without(exact::oracle_features());
    if (!unjudged.empty()) return failure("the oracle lacks " + to_string(unjudged));
    return candidate.check(test_case);
  }

  // The candidate's part and the verdict.
  void finish(const Case& test_case, const Planes* reference_planes, CaseResult& result, Timing& timing) const {
    if (Result<void> can = can_finish(test_case); !can) {
      result.status = Status::kSkipped;
      result.message = to_string(can.error());
      return;
    }
    const auto start = Clock::now();
    const Result<Planes> planes = candidate.draw(test_case, 0);
    const double drawn = seconds_since(start);
    timing.candidate_seconds += drawn;
    if (!planes) {
      result.status = Status::kFailed;
      result.message = "the candidate cannot draw it: " + to_string(planes.error());
      return;
    }
    result.verdict = judge_case(test_case, *planes, reference_planes, false);
    const double judged = seconds_since(start);
    timing.judge_seconds += judged - drawn;
    if (options.checks) {
      result.checks = judge::metamorphic_checks(
          test_case,
          {.draw = candidate.draw, .subpixel_bits = candidate.subpixel_bits, .features = candidate.features},
          *planes);
    }
    if (std::optional<judge::CheckResult> colors = check_colors(test_case, reference_planes != nullptr)) {
      result.checks.push_back(std::move(*colors));
    }
    result.seconds = seconds_since(start);
    timing.check_seconds += result.seconds - judged;
    const bool check_failed = std::any_of(result.checks.begin(), result.checks.end(), [](const auto& check) {
      return check.outcome == judge::CheckResult::Outcome::kFailed;
    });
    if (result.verdict.candidate_faults() > 0 || check_failed) result.status = Status::kFailed;
  }

  // Draws one batch. Cases that the device cannot draw are marked as skipped, with the reason.
  std::vector<std::unique_ptr<const Planes>> draw_batch(std::span<const Case> batch, std::span<CaseResult> results) {
    std::vector<std::unique_ptr<const Planes>> drawn(batch.size());
    std::vector<const Case*> accepted;
    std::vector<size_t> places;
    for (size_t i = 0; i < batch.size(); ++i) {
      if (const Result<void> can = vulkan::check_case(reference->device(), batch[i]); !can) {
        results[i].status = Status::kSkipped;
        results[i].message = to_string(can.error()) + "; held against the oracle alone";
        continue;
      }
      accepted.push_back(&batch[i]);
      places.push_back(i);
    }
    std::vector<Result<Planes>> planes = reference->draw(accepted);
    for (size_t i = 0; i < accepted.size(); ++i) {
      if (planes[i]) {
        drawn[places[i]] = std::make_unique<const Planes>(std::move(*planes[i]));
      } else {
        results[places[i]].status = Status::kFailed;
        results[places[i]].message = "the reference broke down: " + to_string(planes[i].error());
      }
    }
    return drawn;
  }

  void feed(std::span<const Case> cases, std::vector<CaseResult>& results, JobQueue& queue, Timing& timing) {
    for (size_t begin = 0; begin < cases.size(); begin += kBatchSize) {
      const size_t size = std::min(kBatchSize, cases.size() - begin);
      std::vector<std::unique_ptr<const Planes>> drawn(size);
      if (reference) {
        const auto start = Clock::now();
        drawn = draw_batch(cases.subspan(begin, size), std::span(results).subspan(begin, size));
        timing.reference_seconds += seconds_since(start);
      }
      for (size_t i = 0; i < size; ++i) {
        if (results[begin + i].status == Status::kFailed) continue;
        queue.push({.index = begin + i, .reference = std::move(drawn[i])});
      }
    }
    queue.close();
  }

  void draw_with_reference_alone(std::span<const Case> cases) {
    std::vector<CaseResult> ignored(cases.size());
    for (size_t begin = 0; begin < cases.size(); begin += kBatchSize) {
      const size_t size = std::min(kBatchSize, cases.size() - begin);
      draw_batch(cases.subspan(begin, size), std::span(ignored).subspan(begin, size));
    }
  }

  // Draws and judges everything.
  void run(std::span<const Case> cases, std::vector<CaseResult>& results, Timing& timing) {
    const uint32_t jobs = std::max(options.jobs, 1U);
    std::vector<Timing> timings(jobs);
    {
      JobQueue queue(2 * kBatchSize);
      const Workers workers(jobs, [&](uint32_t worker) {
        while (std::optional<Job> job = queue.pop()) {
          finish(cases[job->index], job->reference.get(), results[job->index], timings[worker]);
        }
      });
      feed(cases, results, queue, timing);
    }
    for (const Timing& of_worker : timings) {
      timing.candidate_seconds += of_worker.candidate_seconds;
      timing.judge_seconds += of_worker.judge_seconds;
      timing.check_seconds += of_worker.check_seconds;
    }
  }

  Timing::Warm measure_warm(std::span<const Case> cases) {
    std::array<double, 3> suite{};
    std::array<double, 3> alone{};
    for (size_t i = 0; i < suite.size(); ++i) {
      auto start = Clock::now();
      draw_with_reference_alone(cases);
      alone[i] = seconds_since(start);
      start = Clock::now();
      std::vector<CaseResult> ignored(cases.size());
      Timing ignored_timing;
      run(cases, ignored, ignored_timing);
      suite[i] = seconds_since(start);
    }
    std::sort(suite.begin(), suite.end());
    std::sort(alone.begin(), alone.end());
    return {.suite_seconds = suite[1], .reference_alone_seconds = alone[1]};
  }
};

Result<SuiteRunner> SuiteRunner::create(const RunOptions& options) {
  CandidateOptions candidate_options = options.candidate_options;
  candidate_options.driver_files = options.driver_files;
  Result<Candidate> candidate = make_candidate(options.candidate, candidate_options);
  if (!candidate) return tl::unexpected(candidate.error());
  return create(options, std::move(*candidate));
}

Result<SuiteRunner> SuiteRunner::create(const RunOptions& options, Candidate candidate) {
  auto state = std::make_unique<State>(State{options, std::move(candidate), std::nullopt, nullptr});
  if (options.reference != kNoReference) {
    Result<vulkan::Reference> reference = open_device(options.reference, options.driver_files, options.validation);
    if (!reference) return tl::unexpected(reference.error());
    state->reference.emplace(std::move(*reference));
    state->reference_paint = scene::driver_painter_on_demand(
        {.driver = options.reference, .driver_files = options.driver_files, .validation = options.validation});
  }
  return SuiteRunner(std::move(state));
}

SuiteRunner::SuiteRunner(std::unique_ptr<State> state) : state_(std::move(state)) {}
SuiteRunner::SuiteRunner(SuiteRunner&&) noexcept = default;
SuiteRunner& SuiteRunner::operator=(SuiteRunner&&) noexcept = default;
SuiteRunner::~SuiteRunner() = default;

RunResult SuiteRunner::run(std::span<const Case> cases) {
  RunResult result{.candidate = state_->candidate.name,
                   .candidate_subpixel_bits = state_->candidate.subpixel_bits,
                   .reference = {.driver = kNoReference}};
  if (state_->reference) {
    const vulkan::DeviceInfo& device = state_->reference->device();
    result.reference = {.driver = device.driver,
                        .name = device.name,
                        .version = device.driver_version,
                        .subpixel_bits = device.subpixel_bits};
  }
  const auto start = Clock::now();
  result.cases.resize(cases.size());
  for (size_t i = 0; i < cases.size(); ++i) {
    result.cases[i].name = cases[i].name;
    result.cases[i].file = cases[i].file;
  }
  state_->run(cases, result.cases, result.timing);
  result.summary = summarise(result.cases, seconds_since(start));
  if (state_->reference && state_->options.measure_alone) result.timing.warm = state_->measure_warm(cases);
  return result;
}

Result<Drawing> SuiteRunner::draw(const Case& test_case) {
  if (const Result<void> can = state_->can_finish(test_case); !can) return tl::unexpected(can.error());
  Drawing drawing;
  Result<Planes> candidate = state_->candidate.draw(test_case, 0);
  if (!candidate) return tl::unexpected(candidate.error());
  drawing.candidate = std::move(*candidate);
  // What the device cannot draw is shown without it.
  if (state_->reference && vulkan::check_case(state_->reference->device(), test_case)) {
    const Case* const one = &test_case;
    std::vector<Result<Planes>> planes = state_->reference->draw({&one, 1});
    if (!planes.front()) return tl::unexpected(planes.front().error());
    drawing.reference = std::move(*planes.front());
  }
  const Planes* const reference = drawing.reference ? &*drawing.reference : nullptr;
  drawing.verdict = state_->judge_case(test_case, drawing.candidate, reference, true);
  drawing.scene_colors = state_->check_colors(test_case, reference != nullptr);
  return drawing;
}

std::vector<std::string> SuiteRunner::validation_messages() const {
  return state_->reference ? state_->reference->validation_messages() : std::vector<std::string>{};
}

}  // namespace fillrule::run
