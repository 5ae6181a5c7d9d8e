#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>

#include "harness/cli/command.h"
#include "harness/cli/inspect.h"
#include "harness/cli/options.h"
#include "harness/explain/explain.h"
#include "harness/report/printable.h"

namespace fillrule::cli {
namespace {

struct ExplainOptions {
  SuiteOptions suite;
  PartyOptions parties;
  std::string pixel;
  std::optional<uint32_t> sample;
};

// "X,Y"
std::optional<explain::SampleId> parse_pixel(const std::string& text) {
  explain::SampleId id;
  const char* const end = text.data() + text.size();
  const auto x = std::from_chars(text.data(), end, id.x);
  if (x.ec != std::errc() || x.ptr == end || *x.ptr != ',') return std::nullopt;
  const auto y = std::from_chars(x.ptr + 1, end, id.y);
  if (y.ec != std::errc() || y.ptr != end) return std::nullopt;
  return id;
}

// The one case that the selector names; errors are printed.
std::optional<Case> load_one(const SuiteOptions& options) {
  format::Suite suite = load(options);
  if (!suite.errors.empty()) return std::nullopt;
  if (suite.cases.size() == 1) return std::move(suite.cases.front());
  std::string names;
  for (const Case& one : suite.cases) names += "\n  " + report::printable(one.name);
  print_error({.what = fmt::format("{} cases match, and one sample of one case can be explained:{}",
                                   suite.cases.size(), names)});
  return std::nullopt;
}

int explain_case(const ExplainOptions& options, const Case& one, const explain::SampleId& sample,
                 const std::string& reference) {
  int exit_code = kConforms;
  const run::RunOptions run_options = against(options.parties, reference);
  Result<run::SuiteRunner> runner = create_runner(run_options, exit_code);
  if (!runner) return exit_code;
  const run::RunResult parties = runner->run({});
  const Result<run::Drawing> drawing = runner->draw(one);
  if (!drawing) {
    print_error(drawing.error());
    return kBadInput;
  }
  const auto explanation = explain_sample(parties, run_options.profile, one, *drawing, sample);
  if (!explanation) {
    print_error(explanation.error());
    return kBadInput;
  }
  fmt::print("{}", report::printable_lines(explain::to_text(*explanation)));
  return kConforms;
}

int run_explain(const ExplainOptions& options) {
  std::optional<explain::SampleId> sample = parse_pixel(options.pixel);
  if (!sample) {
    print_error({.what = fmt::format("--pixel takes X,Y, two whole numbers, not '{}'", options.pixel)});
    return kBadInput;
  }
  sample->sample = options.sample;
  const std::optional<Case> one = load_one(options.suite);
  if (!one) return kBadInput;
  int exit_code = kConforms;
  for (const std::string& reference : options.parties.references) {
    exit_code = std::max(exit_code, explain_case(options, *one, *sample, reference));
  }
  return exit_code;
}

}  // namespace

void add_explain(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("explain", "tell everything known about one sample of a case");
  const auto options = std::make_shared<ExplainOptions>();
  add_suite_options(*command, options->suite);
  command->get_option("cases")->required();
  add_party_options(*command, options->parties);
  command->add_option("--pixel", options->pixel, "which one, from the top left")->type_name("X,Y")->required();
  command->add_option("--sample", options->sample, "of the pixel; the one with the gravest verdict unless given")
      ->check(at_least(0))
      ->type_name("N");
  command->callback([options, &exit_code] { exit_code = run_explain(*options); });
}

}  // namespace fillrule::cli
