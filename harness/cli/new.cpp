#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "harness/check/template.h"
#include "harness/cli/command.h"
#include "harness/cli/options.h"

namespace fillrule::cli {
namespace {

struct NewOptions {
  std::string name;
  std::string folder = default_root();
};

int make_case(const NewOptions& options) {
  const Result<std::string> file = check::write_template(options.folder, options.name);
  if (!file) {
    print_error(file.error());
    return kBadInput;
  }
  const std::string selector = case_selector(*file, options.name, options.folder);
  fmt::print("{}: a case that draws as it stands\nnext:\n", *file);
  fmt::print("  write its head and its geometry: $EDITOR {}\n", shell_quoted(*file));
  fmt::print("  draw and judge it: fillrule run {}\n", selector);
  fmt::print("  look at it: fillrule show {}\n", selector);
  fmt::print("  is it complete, and does it show what it is about: fillrule check {}\n", selector);
  return kConforms;
}

}  // namespace

void add_new(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("new", "write a commented template for a case");
  const auto options = std::make_shared<NewOptions>();
  command->add_option("name", options->name, "TOPIC/NAME: lower case letters, digits and underscores")
      ->required()
      ->type_name("TOPIC/NAME");
  command->add_option("--folder", options->folder, "where the topics are")->type_name("DIR")->capture_default_str();
  command->callback([options, &exit_code] { exit_code = make_case(*options); });
}

}  // namespace fillrule::cli
