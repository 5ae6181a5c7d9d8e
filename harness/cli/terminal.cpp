#include "harness/cli/terminal.h"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>

namespace fillrule::cli {
namespace {

constexpr size_t kUsualColumns = 80;

// 0 where it cannot be found out.
size_t columns_of(int descriptor) {
  winsize size{};
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace

void add_terminal_options(CLI::App& command, terminal::Wishes& wishes) {
  command
      .add_option(
          "--color", wishes.colour,
          "colours in the output: auto (on a terminal, unless NO_COLOR is set; CLICOLOR_FORCE asks for them), "
          "always, never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
  command
      .add_option(
          "--preview", wishes.preview,
          "pictures of cases at fault in the terminal itself: auto (if it is known to show them), blocks (24-bit "
          "colours), kitty (the graphics protocol), none")
      ->check(CLI::IsMember({"auto", "blocks", "kitty", "none"}))
      ->capture_default_str();
}

terminal::Style stdout_style(const terminal::Wishes& wishes) {
  const bool is_terminal = isatty(STDOUT_FILENO) != 0;
  const auto variable = [](const std::string& name) {
    const char* const value = std::getenv(name.c_str());
    return value == nullptr ? std::string() : std::string(value);
  };
  return terminal::choose_style(
      wishes,
      {.is_terminal = is_terminal, .columns = is_terminal ? columns_of(STDOUT_FILENO) : 0, .variable = variable});
}

std::function<void(uint64_t)> progress_count(uint64_t total, const std::string& of_what) {
  if (isatty(STDERR_FILENO) == 0) return {};
  return [total, of_what](uint64_t done) {
    fmt::print(stderr, "\r{} of {} {}{}", done, total, of_what, done < total ? "" : "\n");
    static_cast<void>(std::fflush(stderr));
  };
}

ProgressLine::ProgressLine(size_t total, bool wanted) : total_(total), shown_(wanted && isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (width_ > 0) fmt::print(stderr, "\r{:{}}\r", "", width_);
}

void ProgressLine::advance() {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  ++done_;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  if (!clock_.is_due(seconds)) return;
  const size_t columns = columns_of(STDERR_FILENO);
  // The last column stays free: some terminals begin a new line there. Blanks take away what an older line leaves, as
  // not every terminal knows a command for that.
  width_ = (columns == 0 ? kUsualColumns : columns) - 1;
  fmt::print(stderr, "\r{:<{}}", terminal::progress_text(done_, total_, seconds, width_), width_);
  static_cast<void>(std::fflush(stderr));  // a terminal that is gone shows no progress
}

}  // namespace fillrule::cli
