// The terminal that the command talks to: the options that concern it, and the line that shows how far a run is.
#pragma once

#include <CLI/App.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

#include "harness/terminal/progress.h"
#include "harness/terminal/style.h"

namespace fillrule::cli {

void add_terminal_options(CLI::App& command, terminal::Wishes& wishes);

// Of what is printed to stdout.
terminal::Style stdout_style(const terminal::Wishes& wishes);

// To be told how many of `total` are done: "20 of 106 cases" on stderr, over itself. Empty where that is no terminal.
std::function<void(uint64_t)> progress_count(uint64_t total, const std::string& of_what);

// Shows the progress on stderr, if that is a terminal, and takes it away at the end of the scope.
class ProgressLine {
 public:
  ProgressLine(size_t total, bool wanted);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine(ProgressLine&&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ProgressLine& operator=(ProgressLine&&) = delete;

  // One more case is done. May be called by several threads at once.
  void advance();

 private:
  size_t total_;
  bool shown_;        // if there is a terminal
  size_t width_ = 0;  // of the line, once it is there
  std::mutex mutex_;
  size_t done_ = 0;
  terminal::ProgressClock clock_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace fillrule::cli
