#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <set>
#include <vector>

#include "harness/check/check.h"
#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "harness/scene/build.h"

namespace fillrule::cli {
namespace {

// A case is checked with all cases of its file: what they show, they show together.
format::Suite whole_files(const format::Suite& selected, const std::string& root) {
  std::vector<std::string> files;
  std::set<std::string> seen;
  for (const Case& one : selected.cases) {
    if (seen.insert(one.file).second) files.push_back(one.file);
  }
  return files.empty() ? format::Suite{} : scene::load_suite(root, files);
}

// The cases of other files that these name as their control. One that is not there is a finding, not an error.
std::vector<Case> controls_of(const std::vector<Case>& cases, const std::string& root) {
  std::set<std::string> here;
  std::set<std::string> elsewhere;
  for (const Case& one : cases) here.insert(one.name);
  for (const Case& one : cases) {
    if (!one.control.empty() && !here.contains(one.control)) elsewhere.insert(one.control);
  }
  if (elsewhere.empty()) return {};
  const std::vector<std::string> names(elsewhere.begin(), elsewhere.end());
  return scene::load_suite(root, names).cases;
}

int check_cases(const SuiteOptions& options) {
  const format::Suite selected = load(options);
  const format::Suite suite = whole_files(selected, options.root);
  const std::vector<Error> findings = check::check_files(suite.cases, controls_of(suite.cases, options.root));
  for (const Error& finding : findings) print_error(finding);
  std::set<std::string> files;
  for (const Case& one : suite.cases) files.insert(one.file);
  fmt::print("check: {} case{} in {} file{}, {} finding{}\n", suite.cases.size(), suite.cases.size() == 1 ? "" : "s",
             files.size(), files.size() == 1 ? "" : "s", findings.size(), findings.size() == 1 ? "" : "s");
  return findings.empty() && selected.errors.empty() ? kConforms : kBadInput;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand(
      "check", "lint case files: is the head complete, is a control named, is the effect really there?");
  const auto options = std::make_shared<SuiteOptions>();
  add_suite_options(*command, *options);
  command->callback([options, &exit_code] { exit_code = check_cases(*options); });
}

}  // namespace fillrule::cli
