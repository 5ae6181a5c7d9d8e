#include "harness/bench/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>

namespace fillrule::bench {
namespace {

double milliseconds(Clock clock) {
  timespec now{};
  clock_gettime(clock == Clock::kWall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

Result<double> timed(const Party& party, Clock clock) {
  const double begin = milliseconds(clock);
  if (auto drawn = party.draw(); !drawn) return tl::unexpected(drawn.error());
  return milliseconds(clock) - begin;
}

// Lavapipe's last rasterizer thread may be at a fence still when that is already told to be signalled, and the next
// draw frees it (Mesa 22.3): let it get away first.
void let_threads_rest() {
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

Result<PictureDifference> compare(const Scene& scene, const Party& renderer, const Party& reference) {
  for (const Party* party : {&renderer, &reference}) {
    if (auto drawn = party->draw(); !drawn) return tl::unexpected(drawn.error());
    let_threads_rest();
  }
  const auto ours = renderer.picture();
  if (!ours) return tl::unexpected(ours.error());
  const auto theirs = reference.picture();
  if (!theirs) return tl::unexpected(theirs.error());
  return difference(*ours, *theirs, scene.samples);
}

}  // namespace

Timing timing_of(std::vector<double> milliseconds) {
  std::sort(milliseconds.begin(), milliseconds.end());
  const auto at = [&](size_t quarter) { return milliseconds[(milliseconds.size() - 1) * quarter / 4]; };
  return {.median = at(2), .lower_quartile = at(1), .upper_quartile = at(3)};
}

PictureDifference difference(const std::vector<uint32_t>& a, const std::vector<uint32_t>& b, uint32_t samples) {
  PictureDifference result;
  const auto channel = [](uint32_t color, uint32_t i) { return static_cast<int32_t>(color >> (8 * i) & 0xFFU); };
  const auto covered = [&](uint32_t color) {
    return (channel(color, 3) * static_cast<int32_t>(samples) + 127) / 255;
  };
  for (size_t pixel = 0; pixel < a.size(); ++pixel) {
    if (covered(a[pixel]) != covered(b[pixel])) {
      ++result.coverage;
      continue;
    }
    for (uint32_t i = 0; i < 4; ++i) {
      if (std::abs(channel(a[pixel], i) - channel(b[pixel], i)) > static_cast<int32_t>(kMaxChannelDifference)) {
        ++result.color;
        break;
      }
    }
  }
  return result;
}

Result<Measurement> measure(const std::string& name, const Scene& scene, const MeasureOptions& options) {
  const Party renderer = make_renderer(scene, options.threads, options.isa);
  const Result<Party> reference = make_driver(scene, options.driver, options.threads);
  if (!reference) return tl::unexpected(reference.error());
  const Result<PictureDifference> difference = compare(scene, renderer, *reference);
  if (!difference) return tl::unexpected(difference.error());
  const uint32_t pixels = scene.target_size * scene.target_size;
  if (difference->coverage > 0 || difference->color > pixels / 1000) {
    return failure(fmt::format("the pictures of {} differ: the coverage of {} pixels, the colour of {} others", name,
                               difference->coverage, difference->color));
  }
  std::vector<double> ours;
  std::vector<double> theirs;
  for (uint32_t i = 0; i < options.repetitions; ++i) {
    for (auto [party, times] : {std::pair{&renderer, &ours}, std::pair{&*reference, &theirs}}) {
      const Result<double> time = timed(*party, options.clock);
      if (!time) return tl::unexpected(time.error());
      times->push_back(*time);
      let_threads_rest();
    }
  }
  return Measurement{.name = name,
                     .threads = options.threads,
                     .isa = options.isa,
                     .renderer = timing_of(std::move(ours)),
                     .reference = timing_of(std::move(theirs)),
                     .difference = *difference};
}

}  // namespace fillrule::bench
