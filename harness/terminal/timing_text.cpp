#include "harness/terminal/timing_text.h"

#include <fmt/format.h>

#include <string_view>

namespace fillrule::terminal {
namespace {

std::string part(std::string_view name, double seconds, double cases, double bare) {
  std::string text = fmt::format("  {:<40} {:>8.3f} {:>9.4f}", name, seconds, 1000 * seconds / cases);
  if (bare > 0) text += fmt::format(" {:>8.2f}", seconds / bare);
  return text + "\n";
}

std::string table(const run::RunTiming& run, const run::RunTiming* alone, double cases) {
  const double bare = alone != nullptr ? alone->processor_seconds : 0;
  std::string text;
  if (alone != nullptr) text += part("reference alone: draws and reads back", bare, cases, bare);
  text += part("reference: draws and reads back, the rest", run.reference_seconds(), cases, bare);
  text += part("candidate: draws", run.candidate_seconds, cases, bare);
  text += part("oracle: what must and may be covered", run.oracle_seconds, cases, bare);
  text += part("judge: verdicts and exact values", run.judge_seconds, cases, bare);
  text += part("metamorphic checks", run.check_seconds, cases, bare);
  text += part("in all", run.processor_seconds, cases, bare);
  return text;
}

std::string wall(std::string_view name, const run::RunTiming& run, double cases) {
  return fmt::format("  {:<40} {:>8.3f} s, {:.0f} cases a second", name, run.wall_seconds, cases / run.wall_seconds);
}

}  // namespace

std::string timing_text(const run::Timing& timing, uint64_t case_count, double picture_seconds) {
  const auto cases = static_cast<double>(case_count);
  std::string text = fmt::format("processor time over all threads{:>18} {:>9}\n", "seconds", "ms a case");
  text += " cold, pipelines made on the way\n" + table(timing.run, nullptr, cases);
  if (timing.warm) {
    text += fmt::format(" warm, every pipeline made; medians of 3, in turn {:>17}\n", "of alone");
    text += table(timing.warm->suite, &timing.warm->reference_alone, cases);
  }
  text += "wall time\n" + wall("cold", timing.run, cases) + "\n";
  if (timing.warm) {
    const auto& [suite, alone] = *timing.warm;
    text += wall("warm", suite, cases) + "\n" + wall("reference alone, warm", alone, cases) + "\n";
    text += fmt::format("  warm is {:.2f} times the reference alone; cold is {:.2f} s more than warm\n",
                        suite.wall_seconds / alone.wall_seconds, timing.run.wall_seconds - suite.wall_seconds);
  }
  if (picture_seconds > 0) text += fmt::format("  {:<40} {:>8.3f} s\n", "results and pictures", picture_seconds);
  return text;
}

}  // namespace fillrule::terminal
