// The words that reports use for verdicts and states, one table for all of them.
#pragma once

#include <string_view>

#include "harness/judge/verdict.h"
#include "harness/run/run.h"

namespace fillrule::report {

std::string_view name_of(judge::Verdict verdict);
std::string_view name_of(run::Status status);
std::string_view name_of(judge::CheckResult::Outcome outcome);

}  // namespace fillrule::report
