#include "harness/cli/crash_report.h"

#if defined(__GLIBC__)
#include <execinfo.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <string_view>

#include "harness/run/under_way.h"
#endif

namespace fillrule::cli {

#if defined(__GLIBC__)
namespace {

constexpr int kMaxFrames = 64;

void print(std::string_view text) {
  static_cast<void>(!write(STDERR_FILENO, text.data(), text.size()));
}

// One line for each thread that is at something.
void print_under_way() {
  for (size_t slot = 0; slot < run::UnderWay::kMost; ++slot) {
    const run::UnderWay* const work = run::UnderWay::in_slot(slot);
    if (work == nullptr) continue;
    print("fillrule: under way: ");
    print(work->what());
    print(" ");
    print(work->party());
    print(":");
    for (const Case* const one : work->cases()) {
      print(" ");
      print(one->name);
    }
    print("\n");
  }
}

// All that a signal's handler may call (signal-safety(7)); backtrace() after its first call, which loads a library.
void report(int signal) {
  const char* const name = sigabbrev_np(signal);
  print("fillrule: died of signal SIG");
  print(name == nullptr ? "?" : name);
  print("; the innermost frames first:\n");
  std::array<void*, kMaxFrames> frames{};
  backtrace_symbols_fd(frames.data(), backtrace(frames.data(), kMaxFrames), STDERR_FILENO);
  print_under_way();
  raise(signal);  // as SA_RESETHAND has put back what the system does
}

}  // namespace
#endif

void report_crashes() {
#if defined(__GLIBC__)
  std::array<void*, 1> frame{};
  backtrace(frame.data(), 1);
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) continue;
    struct sigaction action {};
    action.sa_handler = report;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    sigaction(signal, &action, nullptr);
  }
#endif
}

}  // namespace fillrule::cli
