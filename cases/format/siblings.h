// What the head says of a case beside others: which one is its control, and what it shows compared with that.
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/format/sweep.h"
#include "cases/model/case.h"

namespace fillrule::format {

// Values of some of a sweep's variables: for each variable the number of its value, or none if any will do.
using SweepSelection = std::vector<std::optional<size_t>>;

struct Siblings {
  std::optional<SweepSelection> control_values;            // the control is a case of the same file ...
  std::string control_name;                                // ... or a case of this name, or none is named
  Effect effect = Effect::kDifferent;                      // of all cases but the control
  std::vector<std::pair<SweepSelection, Effect>> effects;  // of some cases; the first that fits

  // Sets `control` and `effect` of the case that combination `index` of the sweep has made of the file called `name`.
  void apply(const std::string& name, const Sweep& sweep, size_t index, Case& one) const;
};

// The keys `control` and `expect` of a file, whose whole text is `text`.
Siblings read_siblings(const toml::table& root, std::string_view text, const Sweep& sweep, Diagnostics& diagnostics);

}  // namespace fillrule::format
