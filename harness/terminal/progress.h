// The line that a long run shows while it goes on: how far it is, how fast, and how long it takes still. Times are in
// seconds.
#pragma once

#include <cstddef>
#include <string>

namespace fillrule::terminal {

// "[#####.....]  512 of 4637 cases, 431 a second, 9 s left", no wider than `columns`: the bar goes first, then the
// end.
std::string progress_text(size_t done, size_t total, double seconds, size_t columns);

// Whether the line is due: a run that is over in a second needs none, and one that goes on need not show it more than
// ten times a second.
class ProgressClock {
 public:
  bool is_due(double seconds);

 private:
  double shown_ = 0;
};

}  // namespace fillrule::terminal
