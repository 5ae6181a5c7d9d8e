#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <thread>

#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "harness/cli/terminal.h"
#include "harness/faults/table.h"
#include "harness/faults/text.h"
#include "harness/report/json.h"

namespace fillrule::cli {
namespace {

struct FaultsOptions {
  std::vector<std::string> names;  // all if none
  std::string suite_root;
  std::string json_file;      // empty: none is written
  std::string markdown_file;  // likewise
  uint32_t jobs = 1;
  bool list = false;
};

Result<std::vector<faults::FaultEntry>> chosen(const std::vector<std::string>& names) {
  const auto all = faults::catalogue();
  if (names.empty()) return std::vector(all.begin(), all.end());
  std::vector<faults::FaultEntry> entries;
  for (const std::string& name : names) {
    const Result<faults::Fault> fault = faults::fault_named(name);
    if (!fault) return tl::unexpected(fault.error());
    const auto entry = std::ranges::find(all, *fault, &faults::FaultEntry::fault);
    if (entry != all.end()) entries.push_back(*entry);
  }
  return entries;
}

bool written(const std::string& file, const std::string& text) {
  if (file.empty()) return true;
  const Result<void> result = report::write_text(file, text);
  if (!result) print_error(result.error());
  return result.has_value();
}

int run_faults(const FaultsOptions& options) {
  const auto entries = chosen(options.names);
  if (!entries) {
    print_error(entries.error());
    return kBadInput;
  }
  if (options.list) {
    for (const faults::FaultEntry& entry : *entries)
      fmt::print("{}: {} ({})\n", entry.name, entry.what, entry.source);
    return kConforms;
  }
  for (const std::string* const file : {&options.json_file, &options.markdown_file}) {
    const Result<void> can = file->empty() ? Result<void>{} : check_writable(*file);
    if (can) continue;
    print_error(can.error());
    return kBadInput;
  }
  const format::Suite suite = load({.root = options.suite_root});
  if (!suite.errors.empty()) return kBadInput;
  const faults::FaultTable table =
      faults::catch_faults(suite.cases, *entries, options.jobs, progress_count(suite.cases.size(), "cases"));
  fmt::print("{}", faults::to_text(table));
  const bool both_written = written(options.json_file, faults::to_json(table)) &&
                            written(options.markdown_file, faults::to_markdown(table));
  if (!both_written) return kBadInput;
  return table.false_alarms.empty() && std::ranges::all_of(table.rows, faults::is_caught) ? kConforms : kMismatch;
}

}  // namespace

void add_faults(CLI::App& app, int& exit_code) {
  CLI::App* const command =
      app.add_subcommand("faults", "which cases catch which classic fault; fails if one is not caught");
  const auto options = std::make_shared<FaultsOptions>();
  command->add_option("faults", options->names, "faults by name; all if none")->type_name("FAULT");
  options->suite_root = default_root();
  command->add_option("--suite", options->suite_root, "the folder of the suite")->type_name("DIR");
  command->add_option("--json", options->json_file, "write the table to this file too")->type_name("FILE");
  command->add_option("--markdown", options->markdown_file, "write the table to this file too")->type_name("FILE");
  options->jobs = std::max(std::thread::hardware_concurrency(), 1U);
  command->add_option("--jobs", options->jobs, "cases at the same time")->check(CLI::Range(1, 1024));
  command->add_flag("--list", options->list, "list the faults and what they do");
  command->callback([options, &exit_code] { exit_code = run_faults(*options); });
}

}  // namespace fillrule::cli
