#include "harness/exhaust/exhaust.h"

#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <thread>

#include "cases/format/writer.h"
#include "harness/cli/command.h"
#include "harness/cli/options.h"
#include "harness/exhaust/case_file.h"
#include "harness/report/json.h"

namespace fillrule::cli {
namespace {

constexpr const char* kNoReferenceName = "none";

struct ExhaustCommandOptions {
  exhaust::Options exhaust;
  std::string candidate = "renderer";
  uint32_t subpixel_bits = 8;
  std::string reference = "lavapipe";
  std::string triples;  // empty: by the size of the world
  std::string cull = "none";
  std::string folder = "build/exhaust";
};

exhaust::Triples triples_of(const ExhaustCommandOptions& options) {
  const exhaust::World& world = options.exhaust.world;
  if (options.triples.empty()) return exhaust::default_triples(world.grid, world.size);
  return options.triples == "ordered" ? exhaust::Triples::kOrdered : exhaust::Triples::kUnordered;
}

VkCullModeFlags cull_mode_of(const std::string& cull) {
  if (cull == "front") return VK_CULL_MODE_FRONT_BIT;
  return cull == "back" ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_NONE;
}

std::string default_state_file(const ExhaustCommandOptions& options) {
  const exhaust::World& world = options.exhaust.world;
  const std::string cull = options.cull == "none" ? "" : "-cull-" + options.cull;
  return fmt::format("{}/{}x{}-{}-{}{}.json", options.folder, world.grid, world.size, options.candidate,
                     options.reference, cull);
}

// Tells how far it is: over and over in one line on a terminal, a line every ten seconds elsewhere.
class ProgressPrinter {
 public:
  explicit ProgressPrinter(uint64_t total) : total_(total) {}

  void operator()(const exhaust::Progress& progress) {
    const auto now = std::chrono::steady_clock::now();
    if (!first_) {
      first_ = {now, progress.triangles};
      if (progress.triangles > 0) fmt::print("resumed after {} triangles\n", progress.triangles);
    }
    const auto period = is_terminal_ ? std::chrono::milliseconds(200) : std::chrono::seconds(10);
    if (now - printed_ < period) return;
    printed_ = now;
    const double seconds = std::chrono::duration<double>(now - first_->begin).count();
    const auto drawn = static_cast<double>(progress.triangles - first_->triangles);
    const uint64_t differing = progress.candidate.tally.triangles + progress.reference.tally.triangles;
    fmt::print("{}{:5.1f}%  {} of {} triangles, {:.2f} million/s, {} differ{}", is_terminal_ ? "\r" : "",
               100.0 * static_cast<double>(progress.triangles) / static_cast<double>(total_), progress.triangles,
               total_, seconds > 0 ? drawn / seconds / 1e6 : 0.0, differing, is_terminal_ ? "" : "\n");
    static_cast<void>(std::fflush(stdout));
    is_line_open_ = is_terminal_;
  }

  void end_line() {
    if (is_line_open_) fmt::print("\n");
    is_line_open_ = false;
  }

 private:
  struct First {
    std::chrono::steady_clock::time_point begin;
    uint64_t triangles = 0;
  };
  uint64_t total_;
  bool is_terminal_ = isatty(STDOUT_FILENO) != 0;
  bool is_line_open_ = false;
  std::optional<First> first_;
  std::chrono::steady_clock::time_point printed_ = std::chrono::steady_clock::now();
};

void print_world(const exhaust::World& world, const exhaust::Parties& parties) {
  fmt::print("small world: 1/{} px grid, {} x {} px, {} positions, {} triangles ({})\n", world.grid, world.size,
             world.size, exhaust::position_count(world), exhaust::triple_count(world),
             world.triples == exhaust::Triples::kOrdered ? "all ordered triples of vertices"
                                                         : "up to the order of the vertices");
  const auto print_party = [](const char* role, const exhaust::Party& party) {
    fmt::print("{}: {}{}, {} subpixel bits\n", role, party.name,
               party.version.empty() ? "" : " (" + party.version + ")", party.subpixel_bits);
  };
  print_party("candidate", parties.candidate);
  if (parties.reference) print_party("reference", *parties.reference);
}

void print_findings(const exhaust::Party& party, const exhaust::Findings& findings) {
  const exhaust::Tally& tally = findings.tally;
  if (!tally.any()) {
    fmt::print("{}: equal to the oracle on all triangles, hits and facing\n", party.name);
    return;
  }
  fmt::print(
      "{}: {} triangles differ; pixels: {} faults, {} within the latitude, {} ties against the top-left rule, "
      "{} outside of their cells\n",
      party.name, tally.triangles, tally.faults, tally.latitude, tally.ties, tally.strays);
}

// Prints the differences and leaves a case file for each, at most max_differences in all.
bool report_differences(const ExhaustCommandOptions& options, const exhaust::Parties& parties,
                        const exhaust::Progress& progress) {
  std::vector<std::pair<std::string, exhaust::Difference>> all;
  for (const auto& one : progress.candidate.first) all.emplace_back(parties.candidate.name, one);
  for (const auto& one : progress.reference.first) all.emplace_back(parties.reference->name, one);
  // Both parties get their share.
  std::ranges::stable_sort(all, {}, [](const auto& one) { return one.second.number; });
  all.resize(std::min(all.size(), options.exhaust.max_differences));
  if (all.empty()) return true;
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);
  const exhaust::World& world = options.exhaust.world;
  bool written = true;
  for (const auto& [party, difference] : all) {
    fmt::print("{}", exhaust::difference_text(world, party, difference));
    const Case drawn = exhaust::difference_case(world, party, difference);
    const std::string path = fmt::format("{}/{}.toml", options.folder, drawn.name);
    const Result<void> result = report::write_text(path, format::write(drawn));
    if (!result) print_error(result.error());
    written = written && result.has_value();
    if (result) fmt::print("  case file: {}\n", path);
  }
  return written;
}

// For a world of ordered triples: may a larger one be gone through in one order of the vertices?
bool check_symmetry(const exhaust::World& world) {
  if (world.triples != exhaust::Triples::kOrdered) return true;
  const uint64_t asymmetric = exhaust::asymmetric_triangles(world);
  if (asymmetric == 0) {
    fmt::print(
        "symmetry: the order of the vertices changes the coverage of no triangle, and its winding as it must\n");
  } else {
    fmt::print("symmetry: the order of the vertices changes the coverage of {} triangles\n", asymmetric);
  }
  return asymmetric == 0;
}

Result<exhaust::Parties> make_parties(const ExhaustCommandOptions& options, int& exit_code) {
  exit_code = kBadInput;
  exhaust::Parties parties;
  const exhaust::CellLayout layout(options.exhaust.world, options.exhaust.target_size);
  Result<exhaust::Party> candidate = options.candidate == exhaust::kRenderer
                                         ? exhaust::make_renderer(options.subpixel_bits)
                                         : exhaust::make_device(options.candidate, driver_files(), layout);
  if (!candidate) {
    return failure(fmt::format("there is no candidate '{}': {}", options.candidate, candidate.error().what),
                   "the candidates are: renderer, and the drivers that 'fillrule devices' lists");
  }
  parties.candidate = std::move(*candidate);
  if (options.reference == kNoReferenceName) return parties;
  exit_code = kNoReference;
  Result<exhaust::Party> reference = exhaust::make_device(options.reference, driver_files(), layout);
  if (!reference) return tl::unexpected(reference.error());
  parties.reference = std::move(*reference);
  return parties;
}

int conclude(const ExhaustCommandOptions& options, const exhaust::Parties& parties, const exhaust::Outcome& outcome) {
  const exhaust::Progress& progress = outcome.progress;
  const bool written = report_differences(options, parties, progress);
  fmt::print("{} triangles, {} of which cover a pixel, in {:.1f} s: {:.2f} million/s\n", progress.triangles,
             progress.covering, progress.seconds, static_cast<double>(progress.triangles) / progress.seconds / 1e6);
  print_findings(parties.candidate, progress.candidate);
  if (parties.reference) print_findings(*parties.reference, progress.reference);
  const bool is_symmetric = check_symmetry(options.exhaust.world);
  if (!written) return kBadInput;
  const bool conforms = is_symmetric && !progress.candidate.tally.any() && !progress.reference.tally.any();
  return conforms ? kConforms : kMismatch;
}

int run_exhaust(ExhaustCommandOptions& options) {
  exhaust::World& world = options.exhaust.world;
  if (const Result<void> checked = exhaust::check_world(world.grid, world.size); !checked) {
    print_error(checked.error());
    return kBadInput;
  }
  world.triples = triples_of(options);
  options.exhaust.cull_mode = cull_mode_of(options.cull);
  options.exhaust.target_size = exhaust::CellLayout::default_target_size(world.size);
  if (options.exhaust.state_file.empty()) options.exhaust.state_file = default_state_file(options);

  int exit_code = kConforms;
  const Result<exhaust::Parties> parties = make_parties(options, exit_code);
  if (!parties) {
    print_error(parties.error());
    return exit_code;
  }
  print_world(world, *parties);
  ProgressPrinter printer(exhaust::triple_count(world));
  const auto outcome = exhaust::exhaust(options.exhaust, *parties, [&](const exhaust::Progress& progress) {
    printer(progress);
    return true;
  });
  printer.end_line();
  if (!outcome) {
    print_error(outcome.error());
    return kBadInput;
  }
  if (!outcome->note.empty()) fmt::print(stderr, "began anew: {}\n", outcome->note);
  return conclude(options, *parties, *outcome);
}

}  // namespace

void add_exhaust(CLI::App& app, int& exit_code) {
  CLI::App* const command =
      app.add_subcommand("exhaust", "prove a small world whole: every triangle on a grid in a cell of pixels");
  const auto options = std::make_shared<ExhaustCommandOptions>();
  exhaust::Options& exhaust = options->exhaust;
  exhaust.threads = std::max(std::thread::hardware_concurrency(), 1U);
  command->add_option("--grid", exhaust.world.grid, "vertices lie on multiples of 1/N px")
      ->type_name("N")
      ->check(at_least(1))
      ->capture_default_str();
  command->add_option("--size", exhaust.world.size, "of the cell, in pixels")
      ->type_name("P")
      ->check(at_least(1))
      ->capture_default_str();
  command->add_option("--candidate", options->candidate, "who is judged: renderer, or a driver")
      ->capture_default_str();
  command->add_option("--subpixel-bits", options->subpixel_bits, "of the candidate")
      ->check(CLI::Range(4, 8))
      ->capture_default_str();
  command->add_option("--reference", options->reference, "a driver as 'fillrule devices' names it, or none")
      ->capture_default_str();
  command
      ->add_option("--triples", options->triples,
                   "every order of three vertices, or one; by default one above a hundred million triangles")
      ->check(CLI::IsMember({"ordered", "unordered"}));
  command->add_option("--cull", options->cull, "which faces are culled, counter-clockwise being front")
      ->check(CLI::IsMember({"none", "front", "back"}))
      ->capture_default_str();
  command->add_option("--threads", exhaust.threads, "draws at the same time")->check(CLI::Range(1, 64));
  command
      ->add_option("--resume", exhaust.state_file,
                   "where the state is kept, and taken up again after an interruption; by default a file in --out")
      ->type_name("FILE");
  command->add_flag("--fresh", exhaust.fresh, "begin anew, whatever the state file says");
  command->add_option("--out", options->folder, "where case files of differing triangles go, at most 20")
      ->type_name("DIR")
      ->capture_default_str();
  command->callback([options, &exit_code] { exit_code = run_exhaust(*options); });
}

}  // namespace fillrule::cli
