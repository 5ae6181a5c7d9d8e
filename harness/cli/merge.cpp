#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>

#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/terminal.h"
#include "harness/report/json.h"
#include "harness/report/merge_pages.h"
#include "harness/report/pictures.h"
#include "harness/run/counted.h"
#include "harness/run/deviations.h"
#include "harness/run/merge.h"
#include "harness/terminal/text.h"

namespace fillrule::cli {
namespace {

struct MergeOptions {
  std::vector<std::string> folders;
  OutputOptions output;
  std::string expected_folder;
  bool strict_reference = false;
  bool quiet = false;
  terminal::Wishes wishes;
};

Result<std::vector<run::NamedResult>> read_all(const std::vector<std::string>& folders) {
  std::vector<run::NamedResult> parts;
  for (const std::string& folder : folders) {
    const std::string file = folder + "/results.json";
    Result<run::RunResult> result = report::read_results(file);
    if (!result) return tl::unexpected(result.error());
    parts.push_back({.file = file, .result = std::move(*result)});
  }
  return parts;
}

// Pictures and planes of the cases at fault, for which the shards have them.
Result<size_t> copy_pictures(const MergeOptions& options, const std::vector<run::NamedResult>& parts) {
  constexpr std::array kEndings{".png", ".candidate.exr", ".reference.exr"};
  size_t cases = 0;
  for (size_t i = 0; i < parts.size(); ++i) {
    for (const run::CaseResult& one : parts[i].result.cases) {
      const std::string stem = "/" + report::file_stem(one.name);
      bool copied = false;
      for (const char* const ending : kEndings) {
        const std::string from = fmt::format("{}{}{}", options.folders[i], stem, ending);
        const std::string to = fmt::format("{}{}{}", options.output.report_folder, stem, ending);
        std::error_code error;
        if (!std::filesystem::exists(from, error)) continue;
        std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing, error);
        if (error) return tl::unexpected(Error{.file = to, .what = "cannot be written: " + error.message()});
        copied = true;
      }
      cases += copied ? 1 : 0;
    }
  }
  return cases;
}

void print_merged(const MergeOptions& options, const run::RunResult& result, const run::DeviationReport& deviations) {
  const terminal::Style style = stdout_style(options.wishes);
  for (const run::CaseResult& one : result.cases) {
    if (options.quiet || one.status == run::Status::kPassed) continue;
    fmt::print("{}", terminal::case_text(one, style));
  }
  fmt::print("{}{}", terminal::summary_text(result, style), terminal::deviations_text(result, deviations));
}

int merge(const MergeOptions& options) {
  const auto parts = read_all(options.folders);
  if (!parts) {
    print_error(parts.error());
    return kBadInput;
  }
  const auto result = run::merge_results(*parts);
  if (!result) {
    print_error(result.error());
    return kBadInput;
  }
  const auto known = run::known_deviations(options.expected_folder, result->reference);
  if (!known) {
    print_error(known.error());
    return kBadInput;
  }
  const run::DeviationReport deviations = run::compare_with_known(result->cases, *known);
  if (!can_write_output(options.output)) return kBadInput;
  const auto pictures = copy_pictures(options, *parts);
  if (!pictures) print_error(pictures.error());
  const Result<void> page = report::merge_pages(options.folders, options.output.report_folder, *result, deviations);
  if (!page) print_error(page.error());
  print_merged(options, *result, deviations);
  const bool written = write_output(options.output, *result, deviations) && pictures && page;
  if (written) {
    fmt::print("merged {} into {}, with the pictures of {}\n", run::counted(parts->size(), "report"),
               options.output.report_folder, run::counted(*pictures, "case"));
  }
  if (!written) return kBadInput;
  return has_failed(*result, deviations, options.strict_reference) ? kMismatch : kConforms;
}

}  // namespace

void add_merge(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("merge", "join the reports of shards into one");
  const auto options = std::make_shared<MergeOptions>();
  command->add_option("reports", options->folders, "folders that 'fillrule run --report' wrote, one for each shard")
      ->type_name("DIR")
      ->required();
  command->add_option("-o,--report", options->output.report_folder, "where the joined report goes")
      ->type_name("DIR")
      ->required();
  add_output_options(*command, options->output);
  add_deviation_options(*command, options->expected_folder, options->strict_reference);
  add_terminal_options(*command, options->wishes);
  command->add_flag("--quiet,-q", options->quiet, "the summary alone");
  command->callback([options, &exit_code] { exit_code = merge(*options); });
}

}  // namespace fillrule::cli
