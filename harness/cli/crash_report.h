// What is left of a process that dies of a signal: where it was, and with which cases.
#pragma once

namespace fillrule::cli {

// From now on a crash tells on stderr which code it happened in, each frame with its library: whether in the driver,
// in a library, or here; and what each thread was doing with which cases (harness/run/under_way.h). The process then
// dies of the signal as it would have. Nothing happens where somebody listens for crashes already, as sanitizers do,
// without glibc, or where the stack has no room left.
void report_crashes();

}  // namespace fillrule::cli
