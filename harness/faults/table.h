// Which cases of the suite catch which fault: the naive rasterizer draws each case with each fault, and the judge
// holds it against the oracle, with the profiles that the renderer is held to as well (top_left, diamond_exit).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cases/model/case.h"
#include "harness/faults/fault.h"

namespace fillrule::faults {

// One fault, and what the suite makes of it.
struct FaultRow {
  FaultEntry entry;
  std::vector<std::string> cases;   // that catch it, in the order of the suite
  std::vector<std::string> planes;  // in which they do, those of the most cases first; all varyings are one
};

struct FaultTable {
  std::vector<FaultRow> rows;
  // Cases in which the judge finds the rasterizer at fault although it makes none. There should be none.
  std::vector<std::string> false_alarms;
};

// Told how many cases are done, by one thread at a time.
using Progress = std::function<void(uint64_t done)>;

FaultTable catch_faults(std::span<const Case> cases, std::span<const FaultEntry> faults, uint32_t jobs,
                        const Progress& progress);

// A fault counts as caught if this many cases of this many topics catch it besides those whose name names it.
inline constexpr size_t kLeastCases = 3;
inline constexpr size_t kLeastTopics = 2;
bool is_caught(const FaultRow& row);

// Whether the name of the case's file holds every word of the fault's.
bool is_named_after(const std::string& case_name, std::string_view fault);

// Up to three catching cases to show, of different topics and files as far as there are, none named after the fault
// if others are there.
std::vector<std::string> examples(const FaultRow& row);

}  // namespace fillrule::faults
