// [sweep]: the variables that turn one file into many cases.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "cases/format/expression.h"
#include "cases/format/toml_access.h"

namespace fillrule::format {

inline constexpr size_t kMaxCasesPerFile = 65536;

struct SweepValue {
  std::string written;  // as the file has it; part of the case's name
  double number = 0.0;
};

struct SweepVariable {
  std::string name;
  bool is_text = false;            // the values are words such as "back", used as "$cull"
  std::vector<SweepValue> values;  // at least one
};

struct Sweep {
  std::vector<SweepVariable> variables;  // in the order of the file

  // The number of combinations; the last variable runs fastest.
  [[nodiscard]] size_t size() const;
  // For each variable the number of its value in combination `index`.
  [[nodiscard]] std::vector<size_t> values_of(size_t index) const;
  // The combination of these values: the inverse of values_of().
  [[nodiscard]] size_t index_of(const std::vector<size_t>& values) const;
  // Gives the variables their values of combination `index`.
  void define(size_t index, Evaluator& evaluator) const;
  // "[angle=30,cull=back]"; empty without variables.
  [[nodiscard]] std::string suffix(size_t index) const;
};

// A value as it is written in the file, whose whole text is `text`.
std::string written_value(const toml::node& node, std::string_view text);

// `text` is the whole file, from which values are quoted. Variables that cannot be read are left out, with an error.
Sweep read_sweep(const toml::table& root, std::string_view text, Evaluator& evaluator, Diagnostics& diagnostics);

}  // namespace fillrule::format
