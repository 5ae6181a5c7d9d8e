#include "harness/terminal/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fillrule::terminal {
namespace {

constexpr size_t kWidestBar = 40;
constexpr size_t kNarrowestBar = 10;
constexpr double kFirstAfter = 1;
constexpr double kInterval = 0.1;

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

std::string progress_text(size_t done, size_t total, double seconds, size_t columns) {
  const size_t digits = fmt::formatted_size("{}", total);
  std::string text = fmt::format("{:>{}} of {} cases", done, digits, total);
  if (done > 0 && seconds > 0) {
    const double rate = static_cast<double>(done) / seconds;
    text += fmt::format(", {:.{}f} a second, {} left", rate, rate < 10 ? 1 : 0,
                        duration_text(static_cast<double>(total - done) / rate));
  }
  if (columns < text.size()) return text.substr(0, columns);
  const size_t room = columns - text.size();
  if (room < kNarrowestBar + 3 || total == 0) return text;
  const size_t width = std::min(room - 3, kWidestBar);
  const size_t filled = width * done / total;
  return fmt::format("[{:#>{}}{:.>{}}] {}", "", filled, "", width - filled, text);
}

bool ProgressClock::is_due(double seconds) {
  if (seconds < kFirstAfter || seconds < shown_ + kInterval) return false;
  shown_ = seconds;
  return true;
}

}  // namespace fillrule::terminal
