#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "harness/cli/subject.h"
#include "harness/report/printable.h"
#include "harness/view/session.h"
#include "harness/view/window.h"

namespace fillrule::cli {
namespace {

struct ViewOptions {
  SuiteOptions suite;
  PartyOptions parties;
  view::WindowOptions window;
  std::string size;
  std::string events_file;
  std::string folder = ".";
  uint32_t frames = 0;
};

constexpr const char* kFirstScene = "scenes/textured_cube";

// Everything that can be wrong with the command line, before there is a window.
Result<void> check(ViewOptions& options) {
  if (options.frames > 0) options.window.frames = options.frames;
  const bool needs_frames = options.window.benchmark || !options.window.screenshot_file.empty();
  if (needs_frames && options.frames == 0) return failure("--benchmark and --screenshot need --frames N");
  if (!options.size.empty()) {
    const auto size = parse_size(options.size);
    if (!size) return tl::unexpected(size.error());
    options.window.pane_width = static_cast<int>(size->first);
    options.window.pane_height = static_cast<int>(size->second);
  }
  if (!options.window.screenshot_file.empty() && !options.window.screenshot_file.ends_with(".png")) {
    return failure(fmt::format("the screenshot \"{}\" is no .png", options.window.screenshot_file));
  }
  for (const std::string& file : {options.window.screenshot_file, options.window.record_file}) {
    if (file.empty()) continue;
    if (auto writable = check_writable(file); !writable) return writable;
  }
  if (options.events_file.empty()) return {};
  auto events = view::read_events(options.events_file);
  if (!events) return tl::unexpected(events.error());
  options.window.events = std::move(*events);
  return {};
}

Result<view::Session> create_session(const ViewOptions& options, int& exit_code) {
  scene::Assets assets;
  Result<Case> found = find_subject(options.suite, assets, "view");
  if (!found) return tl::unexpected(found.error());
  const std::string& reference = options.parties.references.front();
  const view::SessionOptions session_options{.run = against(options.parties, reference),
                                             .is_judged = reference != run::kNoReference,
                                             .folder = options.folder};
  if (is_driver(reference)) exit_code = kNoReference;
  return view::Session::create(std::move(*found), session_options);
}

int run_view(ViewOptions& options) {
  if (options.suite.selectors.empty()) options.suite.selectors.emplace_back(kFirstScene);
  if (const auto checked = check(options); !checked) {
    print_error(checked.error());
    return kBadInput;
  }
  int exit_code = kBadInput;
  Result<view::Session> session = create_session(options, exit_code);
  if (!session) {
    print_error(session.error());
    return exit_code;
  }
  const Result<view::Shown> shown = view::show(*session, options.window);
  if (!shown) {
    print_error(shown.error());
    return kNoReference;
  }
  if (options.window.benchmark) {
    fmt::print("{} frames in {:.2f} s: {:.1f} frames a second, {:.2f} ms of each until the picture is drawn\n",
               shown->frames, shown->seconds, shown->frames / shown->seconds,
               1e3 * shown->drawing_seconds / shown->frames);
  }
  if (options.window.events) {
    fmt::print("{}\n", report::printable_lines(session->window_title()));
    if (const std::string status = session->status(); !status.empty()) fmt::print("{}\n", report::printable(status));
  }
  return kConforms;
}

}  // namespace

void add_view(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("view", "turn a scene or a model with mouse and keyboard, live");
  const auto options = std::make_shared<ViewOptions>();
  add_suite_options(*command, options->suite);
  command->get_option("cases")->expected(0, 1)->description(
      fmt::format("a scene, any other case, or an OBJ file; {} if none", kFirstScene));
  options->parties.run.candidate_options.threads = std::max(std::thread::hardware_concurrency(), 1U);
  add_party_options(*command, options->parties);
  command->get_option("--reference")
      ->expected(1)
      ->description("a driver as 'fillrule devices' names it; oracle: it judges alone; none: nobody judges");
  command->add_option("--size", options->size, "of each picture; 400x400 by default")->type_name("WxH");
  command->add_option("--bake-to", options->folder, "where ctrl+s writes case files to")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  command->add_option("--events", options->events_file, "keys and mouse from a file instead of the user's")
      ->type_name("FILE");
  command->add_option("--record", options->window.record_file, "write the user's keys and mouse to a file")
      ->type_name("FILE");
  command->add_option("--frames", options->frames, "end after so many")->check(CLI::Range(1, 1000000));
  command
      ->add_option("--screenshot", options->window.screenshot_file,
                   "write the last frame to a .png, drawn and judged to the end")
      ->type_name("FILE");
  command->add_flag("--benchmark", options->window.benchmark,
                    "orbit by a little with each frame, and tell how many frames there are in a second");
  command->callback([options, &exit_code] { exit_code = run_view(*options); });
}

}  // namespace fillrule::cli
