// The fault table for people and for programs.
#pragma once

#include <string>

#include "harness/faults/table.h"

namespace fillrule::faults {

// For a terminal: a line for each fault, then what is wrong.
std::string to_text(const FaultTable& table);

// A Markdown table: fault, what it does, class, number of catching cases, three of them, the planes.
std::string to_markdown(const FaultTable& table);

// {faults: [{name, what, source, caught, caught_by, cases, planes}], false_alarms}: caught_by is the number of cases,
// caught whether that is enough.
std::string to_json(const FaultTable& table);

}  // namespace fillrule::faults
