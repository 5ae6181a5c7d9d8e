#include "harness/cli/commands.h"

#include <fmt/core.h>

#include <cstdio>
#include <filesystem>

#include "cases/format/suite.h"
#include "harness/report/json.h"
#include "harness/report/pictures.h"
#include "harness/report/terminal.h"
#include "reference/vulkan/reference.h"

namespace fillrule::cli {
namespace {

void print_error(const Error& error) {
  fmt::print(stderr, "{}\n", to_string(error));
}

// The cases that were asked for. Errors are printed, and the other cases stay.
format::Suite load(const Arguments& arguments) {
  format::Suite suite = format::load_suite(arguments.suite, arguments.selectors);
  for (const Error& error : suite.errors) print_error(error);
  return suite;
}

int exit_code_of(const run::Summary& summary, bool bad_input) {
  if (bad_input) return kBadInput;
  return summary.failed > 0 ? kMismatch : kConforms;
}

void print_results(const Arguments& arguments, const run::RunResult& result) {
  for (const run::CaseResult& one : result.cases) {
    const bool worth_telling = one.status != run::Status::kPassed || one.verdict.reference_faults() > 0;
    if (!arguments.quiet && (arguments.verbose || worth_telling)) fmt::print("{}", report::case_text(one));
  }
  fmt::print("{}", report::summary_text(result));
  if (arguments.timing) fmt::print("{}", report::timing_text(result));
}

// Pictures of every case at fault, drawn once more: whoever draws the same case twice gets the same bytes.
bool write_pictures(const Arguments& arguments, run::SuiteRunner& runner, const std::vector<Case>& cases,
                    const run::RunResult& result) {
  bool written = true;
  size_t count = 0;
  for (size_t i = 0; i < cases.size(); ++i) {
    const judge::CaseVerdict& verdict = result.cases[i].verdict;
    if (verdict.candidate_faults() == 0 && verdict.reference_faults() == 0) continue;
    const Result<run::Drawing> drawing = runner.draw(cases[i]);
    const auto paths = drawing ? report::write_pictures(arguments.report_folder, cases[i], *drawing)
                               : Result<std::vector<std::string>>(tl::unexpected(drawing.error()));
    if (!paths) print_error(paths.error());
    written = written && paths.has_value();
    count += paths ? 1 : 0;
  }
  if (count > 0) fmt::print("pictures of {} cases in {}\n", count, arguments.report_folder);
  return written;
}

bool write_json(const std::string& path, const std::string& text) {
  const Result<void> written = report::write_text(path, text);
  if (!written) print_error(written.error());
  return written.has_value();
}

bool make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) print_error({.file = folder, .what = "cannot be made: " + error.message()});
  return !error;
}

// A candidate that is not there is a mistake on the command line; a device that is not there is not.
Result<run::SuiteRunner> create_runner(const Arguments& arguments, int& exit_code) {
  if (const auto candidate = run::make_candidate(arguments.run.candidate, {}); !candidate) {
    exit_code = kBadInput;
    return tl::unexpected(candidate.error());
  }
  exit_code = kNoReference;
  return run::SuiteRunner::create(arguments.run);
}

int run_cases(const Arguments& arguments) {
  const format::Suite suite = load(arguments);
  int exit_code = kConforms;
  Result<run::SuiteRunner> runner = create_runner(arguments, exit_code);
  if (!runner) {
    print_error(runner.error());
    return exit_code;
  }
  const run::RunResult result = runner->run(suite.cases);
  print_results(arguments, result);
  bool bad = !suite.errors.empty();
  const std::string json = report::to_json(result);
  if (!arguments.json_file.empty()) bad = !write_json(arguments.json_file, json) || bad;
  if (!arguments.report_folder.empty()) {
    bad = !make_folder(arguments.report_folder) || !write_json(arguments.report_folder + "/results.json", json) ||
          !write_pictures(arguments, *runner, suite.cases, result) || bad;
  }
  for (const std::string& message : runner->validation_messages()) fmt::print(stderr, "validation: {}\n", message);
  if (!suite.errors.empty()) fmt::print(stderr, "{} errors in case files or selectors\n", suite.errors.size());
  return exit_code_of(result.summary, bad);
}

int list_cases(const Arguments& arguments) {
  const format::Suite suite = load(arguments);
  for (const Case& one : suite.cases) fmt::print("{}\n", one.name);
  return suite.errors.empty() ? kConforms : kBadInput;
}

int show_cases(const Arguments& arguments) {
  const format::Suite suite = load(arguments);
  int exit_code = kConforms;
  Result<run::SuiteRunner> runner = create_runner(arguments, exit_code);
  if (!runner) {
    print_error(runner.error());
    return exit_code;
  }
  const std::string folder = arguments.report_folder.empty() ? "build/show" : arguments.report_folder;
  bool bad = !suite.errors.empty();
  bool mismatch = false;
  for (const Case& one : suite.cases) {
    const Result<run::Drawing> drawing = runner->draw(one);
    const auto paths = drawing ? report::write_pictures(folder, one, *drawing)
                               : Result<std::vector<std::string>>(tl::unexpected(drawing.error()));
    if (!paths) {
      print_error(paths.error());
      bad = true;
      continue;
    }
    const bool failed = drawing->verdict.candidate_faults() > 0;
    mismatch = mismatch || failed;
    fmt::print("{}", report::case_text({.name = one.name,
                                        .file = one.file,
                                        .status = failed ? run::Status::kFailed : run::Status::kPassed,
                                        .verdict = drawing->verdict}));
    for (const std::string& path : *paths) fmt::print("    {}\n", path);
  }
  if (bad) return kBadInput;
  return mismatch ? kMismatch : kConforms;
}

int list_devices(const Arguments& arguments) {
  const auto devices = vulkan::list_devices(arguments.run.driver_files);
  if (!devices || devices->empty()) {
    if (!devices) print_error(devices.error());
    fmt::print(stderr,
               "no Vulkan device was found\n  hint: install a driver, such as the package mesa-vulkan-drivers\n");
    return kNoReference;
  }
  for (const vulkan::DeviceInfo& device : *devices) {
    fmt::print("{:<12} {}, {}, {} subpixel bits, targets up to {} px\n", device.driver, device.name,
               device.driver_version, device.subpixel_bits, device.max_target_size);
  }
  return kConforms;
}

}  // namespace

int execute(const Arguments& arguments) {
  switch (arguments.command) {
    case Command::kRun:
      return run_cases(arguments);
    case Command::kList:
      return list_cases(arguments);
    case Command::kShow:
      return show_cases(arguments);
    case Command::kDevices:
      return list_devices(arguments);
  }
  return kBadInput;
}

}  // namespace fillrule::cli
