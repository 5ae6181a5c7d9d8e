#include "harness/run/suite_runner.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "harness/run/job_queue.h"
#include "harness/run/lanes.h"
#include "harness/run/reference.h"
#include "harness/run/stopwatch.h"
#include "harness/run/under_way.h"
#include "harness/scene/build.h"
#include "harness/scene/check.h"
#include "reference/exact/features.h"

namespace fillrule::run {
namespace {

// By wall time.
RunTiming median(std::array<RunTiming, 3> timings) {
  std::ranges::sort(timings, {}, &RunTiming::wall_seconds);
  return timings[1];
}

// So many cases are handed to the reference at once: enough to share a submission, few enough that judging starts
// soon.
constexpr size_t kBatchSize = 32;
// So many cases are worth a second device.
constexpr size_t kCasesForTwoDevices = 8 * kBatchSize;
// Nothing is drawn ahead while pictures of so many bytes wait.
constexpr size_t kWaitingBytes = size_t{256} << 20U;

}  // namespace

struct SuiteRunner::State {
  RunOptions options;
  Candidate candidate;
  std::vector<vulkan::Reference> devices;  // the reference's: none, one, or two that are alike (lanes.h)
  DeviceOfSlots device_of_slots;
  scene::Painter reference_paint;  // empty without a reference
  std::unique_ptr<scene::Assets> assets = std::make_unique<scene::Assets>();

  // Whether the case is a scene whose colours the candidate can draw, so that both parties have to.
  [[nodiscard]] bool has_colors(const Case& test_case) const { return test_case.scene && candidate.paint; }

  // The reference's planes, and for a scene its colours too.
  [[nodiscard]] ReferenceDrawing with_colors(const Case& test_case, Planes planes) const {
    ReferenceDrawing drawn{.planes = std::move(planes)};
    if (has_colors(test_case)) {
      const Case* const one = &test_case;
      const UnderWay under_way("drawn in colour by", devices.front().device().driver, {&one, 1});
      drawn.colors = scene::paint_scene(test_case, *assets, reference_paint);
    }
    return drawn;
  }

  [[nodiscard]] std::optional<Result<judge::CheckResult>> check_colors(const Case& test_case,
                                                                       const scene::KnownCase& known,
                                                                       const ReferenceDrawing& drawn) const {
    if (!has_colors(test_case)) return std::nullopt;
    const scene::PaintingParty candidate_party{candidate.paint, candidate.subpixel_bits};
    if (!drawn.colors) return scene::check_scene(test_case, *assets, candidate_party, nullptr, known);
    const scene::PaintingParty reference_party{scene::painted_before(*drawn.colors),
                                               devices.front().device().subpixel_bits};
    return scene::check_scene(test_case, *assets, candidate_party, &reference_party, known);
  }

  [[nodiscard]] judge::Oracle ask_oracle(const Case& test_case, bool with_reference) const {
    const auto reference_bits =
        with_reference ? std::optional(devices.front().device().subpixel_bits) : std::optional<uint32_t>();
    return {test_case, candidate.subpixel_bits, reference_bits};
  }

  [[nodiscard]] judge::CaseVerdict judge_case(const Case& test_case, const judge::Oracle& oracle,
                                              const Planes& candidate_planes, const Planes* reference_planes,
                                              bool keep_maps) const {
    const judge::Party candidate_party{.planes = &candidate_planes, .subpixel_bits = candidate.subpixel_bits};
    const judge::Settings settings{.profile = options.profile, .keep_maps = keep_maps};
    if (reference_planes == nullptr) return judge::judge(test_case, oracle, candidate_party, nullptr, settings);
    const judge::Party reference_party{.planes = reference_planes,
                                       .subpixel_bits = devices.front().device().subpixel_bits};
    return judge::judge(test_case, oracle, candidate_party, &reference_party, settings);
  }

  // What check_colors() need not find out again.
  static scene::KnownCase known_of(const judge::Oracle& oracle, const Planes& candidate,
                                   const judge::CaseVerdict& verdict) {
    return {.oracle = &oracle, .faultless = verdict.candidate_faults() == 0 ? &candidate : nullptr};
  }

  static void add_colors(Result<judge::CheckResult> colors, CaseResult& result) {
    if (colors) {
      result.checks.push_back(std::move(*colors));
      return;
    }
    result.status = Status::kSkipped;
    result.bad_input = colors.error();
    Error in_one_line = colors.error();
    in_one_line.hint.clear();
    result.message = to_string(in_one_line);
  }

  // Whether the candidate can draw the case and the oracle judge it.
  [[nodiscard]] Result<void> can_finish(const Case& test_case) const {
    const FeatureSet unjudged = features_of(test_case).without(exact::oracle_features());
    if (!unjudged.empty()) return failure("the oracle lacks " + to_string(unjudged));
    return candidate.check(test_case);
  }

  // The candidate's part and the verdict. Returns the wall time of the parts.
  RunTiming finish(const Case& test_case, const ReferenceDrawing& drawn, CaseResult& result) const {
    const Case* const one = &test_case;
    const UnderWay under_way("drawn or judged for the candidate", candidate.name, {&one, 1});
    RunTiming timing;
    const Planes* const reference_planes = drawn.planes ? &*drawn.planes : nullptr;
    if (Result<void> can = can_finish(test_case); !can) {
      result.status = Status::kSkipped;
      result.message = to_string(can.error());
      return timing;
    }
    const Stopwatch whole;
    WallLaps stopwatch;
    const Result<Planes> planes = candidate.draw(test_case, 0);
    timing.candidate_seconds += stopwatch.lap();
    if (!planes) {
      result.status = Status::kFailed;
      result.message = "the candidate cannot draw it: " + to_string(planes.error());
      return timing;
    }
    const judge::Oracle oracle = ask_oracle(test_case, reference_planes != nullptr);
    timing.oracle_seconds += stopwatch.lap();
    result.verdict = judge_case(test_case, oracle, *planes, reference_planes, false);
    timing.judge_seconds += stopwatch.lap();
    if (options.checks) {
      result.checks = judge::metamorphic_checks(
          test_case,
          {.draw = candidate.draw, .subpixel_bits = candidate.subpixel_bits, .features = candidate.features},
          *planes);
      timing.check_seconds += stopwatch.lap();
    }
    if (std::optional<Result<judge::CheckResult>> colors =
            check_colors(test_case, known_of(oracle, *planes, result.verdict), drawn)) {
      add_colors(std::move(*colors), result);
      timing.check_seconds += stopwatch.lap();
    }
    result.seconds = whole.seconds();
    const bool check_failed = std::any_of(result.checks.begin(), result.checks.end(), [](const auto& check) {
      return check.outcome == judge::CheckResult::Outcome::kFailed;
    });
    if (result.verdict.candidate_faults() > 0 || check_failed) result.status = Status::kFailed;
    return timing;
  }

  // The next cases that there are for the device, drawn and handed to `take` one by one; false if there are none.
  template <typename Take>
  bool draw_next(std::span<const Case> cases, Lanes& lanes, size_t device, std::vector<CaseResult>& results,
                 const Take& take) {
    const std::vector<size_t> batch = lanes.next(device, kBatchSize);
    std::vector<std::optional<Planes>> planes(batch.size());
    if (!devices.empty()) planes = draw_batch(devices[device], cases, batch, results);
    for (size_t i = 0; i < batch.size(); ++i) {
      Job job{.index = batch[i]};
      if (planes[i]) job.reference = with_colors(cases[batch[i]], std::move(*planes[i]));
      take(std::move(job));
    }
    return !batch.empty();
  }

  // What one of the threads does. The first ones have a device each and draw with it whenever there would soon be
  // nothing to judge; else they judge like all. So no more threads are busy than there are jobs: where they took
  // turns on a processor, each would find its caches full of what the other left.
  void work(uint32_t worker, std::span<const Case> cases, Lanes& lanes, JobQueue& queue,
            std::vector<CaseResult>& results, RunTiming& timing, const Progress& progress) {
    const auto push = [&](Job job) {
      if (results[job.index].status == Status::kFailed) {
        progress();
      } else {
        queue.push(std::move(job));
      }
    };
    ThreadLaps processor;
    bool draws = worker < lane_count();
    while (true) {
      if (draws && queue.is_short(kBatchSize, kWaitingBytes, lanes.is_behind(worker, kBatchSize))) {
        draws = draw_next(cases, lanes, worker, results, push);
        if (!draws) queue.stop_making();
        processor.lap();
        continue;
      }
      const std::optional<Job> job = draws ? queue.try_pop() : queue.pop();
      if (job) {
        WallLaps wall;
        const RunTiming parts = finish(cases[job->index], job->reference, results[job->index]);
        // The processor's time, shared out as the wall time is, if that clock is fine enough to tell.
        const double processor_seconds = processor.lap();
        const double wall_seconds = wall.lap();
        if (wall_seconds > 0) timing += parts.scaled(processor_seconds / wall_seconds);
        progress();
      } else if (!draws) {
        return;
      }
    }
  }

  // Of those that draw; one where there is no device.
  [[nodiscard]] size_t lane_count() const { return std::max<size_t>(devices.size(), 1); }

  // On one thread, each case with the device that has drawn it before.
  void draw_with_reference_alone(std::span<const Case> cases) {
    std::vector<CaseResult> ignored(cases.size());
    Lanes lanes(cases, device_of_slots);
    for (size_t device = 0; device < devices.size(); ++device) {
      while (draw_next(cases, lanes, device, ignored, [](const Job&) {})) {
      }
    }
  }

  // Where there are processors to draw with two devices at the same time, and cases enough. Without the second one
  // the first draws everything.
  void open_second_device(size_t cases) {
    if (devices.size() != 1 || options.jobs < 2 || cases < kCasesForTwoDevices) return;
    Result<vulkan::Reference> second = open_device(options.reference, options.driver_files, options.validation);
    if (second) devices.push_back(std::move(*second));
  }

  // Keeps the images that scenes show in `assets`. Done ahead of their turn, beside what is drawn until then: unless
  // it is there already (images::load_ahead()), the library that reads them takes half a second to load, in which all
  // threads would come to wait for it.
  void read_images(std::span<const Case> cases) const {
    for (const Case& test_case : cases) {
      // What is wrong is told when the case is drawn.
      if (has_colors(test_case)) std::ignore = scene::shading_of(test_case, *assets);
    }
  }

  // Draws and judges everything.
  RunTiming run(std::span<const Case> cases, std::vector<CaseResult>& results, const Progress& progress) {
    const uint32_t jobs = std::max(options.jobs, 1U);
    std::vector<RunTiming> timings(jobs);
    return timed([&](RunTiming& timing) {
      open_second_device(cases.size());
      {
        const Workers reader(jobs > 1 ? 1 : 0, [&](uint32_t) { read_images(cases); });
        Lanes lanes(cases, device_of_slots);
        JobQueue queue(jobs, lane_count());
        const Workers workers(
            jobs, [&](uint32_t worker) { work(worker, cases, lanes, queue, results, timings[worker], progress); });
      }
      for (const RunTiming& of_worker : timings) timing += of_worker;
    });
  }

  Timing::Warm measure_warm(std::span<const Case> cases) {
    std::array<RunTiming, 3> suite{};
    std::array<RunTiming, 3> alone{};
    for (size_t i = 0; i < suite.size(); ++i) {
      alone[i] = timed([&](RunTiming&) { draw_with_reference_alone(cases); });
      std::vector<CaseResult> ignored(cases.size());
      suite[i] = run(cases, ignored, [] {});
    }
    return {.suite = median(suite), .reference_alone = median(alone)};
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
  auto state = std::make_unique<State>(State{options, std::move(candidate), {}, {}, nullptr});
  if (options.reference != kNoReference) {
    // A candidate that is a driver has its device by now.
    vulkan::prefer_fast_compilation();
    Result<vulkan::Reference> reference = open_device(options.reference, options.driver_files, options.validation);
    if (!reference) return tl::unexpected(reference.error());
    state->devices.push_back(std::move(*reference));
    state->reference_paint = scene::driver_painter_on_demand(
        {.driver = options.reference, .driver_files = options.driver_files, .validation = options.validation});
  }
  return SuiteRunner(std::move(state));
}

SuiteRunner::SuiteRunner(std::unique_ptr<State> state) : state_(std::move(state)) {}
SuiteRunner::SuiteRunner(SuiteRunner&&) noexcept = default;
SuiteRunner& SuiteRunner::operator=(SuiteRunner&&) noexcept = default;
SuiteRunner::~SuiteRunner() = default;

RunResult SuiteRunner::run(std::span<const Case> cases, const Progress& progress) {
  RunResult result{.candidate = state_->candidate.name,
                   .candidate_subpixel_bits = state_->candidate.subpixel_bits,
                   .reference = {.driver = kNoReference},
                   .profile = to_string(state_->options.profile)};
  if (!state_->devices.empty()) {
    const vulkan::DeviceInfo& device = state_->devices.front().device();
    result.reference = {.driver = device.driver,
                        .name = device.name,
                        .version = device.driver_version,
                        .subpixel_bits = device.subpixel_bits};
  }
  result.cases.resize(cases.size());
  for (size_t i = 0; i < cases.size(); ++i) {
    result.cases[i].name = cases[i].name;
    result.cases[i].file = cases[i].file;
  }
  const Progress nobody = [] {};
  result.timing.run = state_->run(cases, result.cases, progress ? progress : nobody);
  result.summary = summarise(result.cases, result.timing.run.wall_seconds);
  if (!state_->devices.empty() && state_->options.measure_alone) result.timing.warm = state_->measure_warm(cases);
  return result;
}

Result<Drawing> SuiteRunner::draw(const Case& test_case) {
  const Case* const one = &test_case;
  const UnderWay under_way("drawn for pictures by the reference and", state_->candidate.name, {&one, 1});
  if (const Result<void> can = state_->can_finish(test_case); !can) return tl::unexpected(can.error());
  Drawing drawing;
  Result<Planes> candidate = state_->candidate.draw(test_case, 0);
  if (!candidate) return tl::unexpected(candidate.error());
  drawing.candidate = std::move(*candidate);
  // What the device cannot draw is shown without it.
  ReferenceDrawing drawn;
  if (!state_->devices.empty() && vulkan::check_case(state_->devices.front().device(), test_case)) {
    std::vector<Result<Planes>> planes = state_->devices.front().draw({&one, 1});
    if (!planes.front()) return tl::unexpected(planes.front().error());
    drawn = state_->with_colors(test_case, std::move(*planes.front()));
  }
  const Planes* const reference = drawn.planes ? &*drawn.planes : nullptr;
  const judge::Oracle oracle = state_->ask_oracle(test_case, reference != nullptr);
  drawing.verdict = state_->judge_case(test_case, oracle, drawing.candidate, reference, true);
  drawing.scene_colors =
      state_->check_colors(test_case, State::known_of(oracle, drawing.candidate, drawing.verdict), drawn);
  drawing.reference = std::move(drawn.planes);
  return drawing;
}

std::vector<std::string> SuiteRunner::validation_messages() const {
  std::vector<std::string> messages;
  for (const vulkan::Reference& device : state_->devices) {
    for (std::string& message : device.validation_messages()) messages.push_back(std::move(message));
  }
  return messages;
}

}  // namespace fillrule::run
