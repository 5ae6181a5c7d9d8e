#include <fmt/core.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

#include "harness/bench/curves.h"
#include "harness/bench/measure.h"
#include "harness/bench/report.h"
#include "harness/bench/workloads.h"
#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "harness/report/json.h"

namespace fillrule::cli {
namespace {

struct BenchCommandOptions {
  bench::MeasureOptions measure;
  std::vector<std::string> workloads;  // empty: all
  std::string clock = "wall";
  std::string json_file;
  std::string svg_file;
  bool curves = false;
};

void print_head(const BenchCommandOptions& options) {
  const bench::MeasureOptions& measure = options.measure;
  fmt::print("renderer ({}) against {}, {} threads each; {} time in ms, medians of {} in turns (quartiles)\n",
             renderer::to_string(measure.isa), measure.driver.name, measure.threads, options.clock,
             measure.repetitions);
  fmt::print("{:18} {:>28} {:>28} {:>7}\n", "workload", "renderer", "reference", "ratio");
}

std::string text_of(const bench::Timing& timing) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", timing.median, timing.lower_quartile, timing.upper_quartile);
}

void print_row(const bench::Measurement& row, const std::string& note = {}) {
  fmt::print("{:18} {:>28} {:>28} {:>7.2f}{}\n", row.name, text_of(row.renderer), text_of(row.reference), row.ratio(),
             note);
  static_cast<void>(std::fflush(stdout));
}

// Leaves the rows that could be measured; false if one could not.
bool measure_workloads(const BenchCommandOptions& options, std::vector<bench::Measurement>& rows) {
  bool complete = true;
  for (const bench::Workload& workload : bench::workloads()) {
    if (!options.workloads.empty() &&
        std::ranges::find(options.workloads, workload.name) == options.workloads.end()) {
      continue;
    }
    const Result<bench::Measurement> row = bench::measure(workload.name, workload.make(), options.measure);
    if (row) {
      print_row(*row);
      rows.push_back(*row);
    } else {
      print_error(row.error());
      complete = false;
    }
  }
  return complete;
}

bool measure_curves(const BenchCommandOptions& options, std::vector<bench::Measurement>& rows) {
  bool complete = true;
  for (const bench::Curve& curve : bench::scaling_curves(options.measure.threads)) {
    fmt::print("{}\n", curve.name);
    for (const bench::CurvePoint& point : curve.points) {
      bench::MeasureOptions measure = options.measure;
      if (point.threads != 0) measure.threads = point.threads;
      const Result<bench::Measurement> row = bench::measure(point.name, point.make(), measure);
      if (!row) {
        print_error(row.error());
        complete = false;
        continue;
      }
      print_row(*row, fmt::format("  {:.1f} ns for each of {:.0f} {}", row->renderer.median * 1e6 / point.work,
                                  point.work, curve.unit));
      rows.push_back(*row);
    }
  }
  return complete;
}

int run_bench(BenchCommandOptions& options) {
  options.measure.clock = options.clock == "wall" ? bench::Clock::kWall : bench::Clock::kProcessor;
  for (const std::string& file : {options.json_file, options.svg_file}) {
    if (file.empty()) continue;
    if (const Result<void> checked = check_writable(file); !checked) {
      print_error(checked.error());
      return kBadInput;
    }
  }
  print_head(options);
  std::vector<bench::Measurement> rows;
  const bool complete = options.curves ? measure_curves(options, rows) : measure_workloads(options, rows);
  Result<void> written;
  if (!options.json_file.empty()) written = report::write_text(options.json_file, bench::to_json(rows));
  if (written && !options.svg_file.empty()) written = report::write_text(options.svg_file, bench::to_svg(rows));
  if (!written) {
    print_error(written.error());
    return kBadInput;
  }
  return complete ? kConforms : kMismatch;
}

}  // namespace

void add_bench(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("bench", "time the renderer and a driver side by side");
  const auto options = std::make_shared<BenchCommandOptions>();
  bench::MeasureOptions& measure = options->measure;
  measure.threads = std::max(std::thread::hardware_concurrency(), 1U);
  measure.driver.files = driver_files();
  std::vector<std::string> names;
  for (const bench::Workload& workload : bench::workloads()) names.push_back(workload.name);
  command
      ->add_option("--workload", options->workloads,
                   fmt::format("some of {}; by default all", fmt::join(names, ", ")))
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(names));
  command->add_option("--threads", measure.threads, "of either party; SwiftShader always takes all processors")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  add_isa_option(*command, measure.isa);
  command->add_option("--reference", measure.driver.name, "a driver as 'fillrule devices' names it")
      ->capture_default_str();
  command->add_option("--repetitions", measure.repetitions, "of which the median counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option("--clock", options->clock,
                   "wall, or processor: the time that the process had a processor, for a machine that is not idle")
      ->check(CLI::IsMember({"wall", "processor"}))
      ->capture_default_str();
  command->add_flag("--curves", options->curves, "how cost grows with triangles, their size, threads and the target");
  command->add_option("--json", options->json_file, "write the figures to a file")->type_name("FILE");
  command->add_option("--svg", options->svg_file, "draw the ratios into a file")->type_name("FILE");
  command->callback([options, &exit_code] { exit_code = run_bench(*options); });
}

}  // namespace fillrule::cli
