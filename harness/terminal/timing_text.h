// Where a run's time went, as text for the terminal.
#pragma once

#include <cstdint>
#include <string>

#include "harness/run/timing.h"

namespace fillrule::terminal {

// A table of the parts: processor time in all and for each case, and, where Timing::warm is there, how many times the
// reference's own drawing that is; then wall times, cases a second, and the same ratio. `picture_seconds` (wall) is
// what writing the report took.
std::string timing_text(const run::Timing& timing, uint64_t case_count, double picture_seconds);

}  // namespace fillrule::terminal
