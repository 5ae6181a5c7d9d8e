// The part of report.html that reads without JavaScript.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "harness/run/deviations.h"
#include "harness/run/run.h"

namespace fillrule::report {

// Text for HTML: & < > " ' are escaped.
std::string html_text(std::string_view text);

// Counts, parties and the cases that failed, each with its sentence, as HTML.
std::string html_summary(const run::RunResult& result, const run::DeviationReport& deviations,
                         const std::function<std::string(size_t index)>& sentence_of);

}  // namespace fillrule::report
