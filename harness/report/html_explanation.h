// What is known of one sample, as JSON for report.html.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "harness/explain/explanation.h"

namespace fillrule::report {

using Json = nlohmann::ordered_json;

// JSON has no NaN and no infinity: those become "nan", "inf" and "-inf".
Json json_number(double value);

// {x, y, sample, at, reason, views: [{bits, hits: [least, most], outcomes, primitives}], parties: [{role, view, hits,
// owner, front, values: {NAME: {expected, tolerance, snapping, rounding, severity, ulps, level}}}]}. Numbers of
// no owner are null.
Json explanation_json(const explain::Explanation& explanation);

}  // namespace fillrule::report
