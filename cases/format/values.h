// Single values of a case file: numbers, texts, booleans and enumerators, with the variables of the case filled in.
// Every function adds an error and returns nothing if the value will not do.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cases/format/enums.h"
#include "cases/format/expression.h"
#include "cases/format/suggestion.h"
#include "cases/format/toml_access.h"

namespace fillrule::format {

struct IntegerRange {
  int64_t min;
  int64_t max;
};

class Values {
 public:
  Values(Evaluator& evaluator, Diagnostics& diagnostics) : evaluator_(evaluator), diagnostics_(diagnostics) {}

  Evaluator& evaluator() { return evaluator_; }
  Diagnostics& diagnostics() { return diagnostics_; }

  // A TOML number, or a string with a literal or an expression.
  std::optional<Number> number(const toml::node& node, std::string_view label);
  // Rounded to float32; NaN and infinity only where they stand in the file or come from a variable.
  std::optional<float> float32(const toml::node& node, std::string_view label);
  std::optional<float> finite_float32(const toml::node& node, std::string_view label);
  std::optional<double> finite(const toml::node& node, std::string_view label);
  std::optional<int64_t> integer(const toml::node& node, std::string_view label, IntegerRange range);

  std::optional<bool> boolean(const toml::node& node, std::string_view label);
  // A string in which "$name" stands for a text variable.
  std::optional<std::string> text(const toml::node& node, std::string_view label);

  template <typename T, size_t N>
  std::optional<T> enumerator(const toml::node& node, std::string_view label,
                              const std::array<EnumName<T>, N>& names) {
    const auto name = text(node, label);
    if (!name) return std::nullopt;
    const auto value = enum_value(names, *name);
    if (!value) unknown_enumerator(node, label, *name, enum_names(names));
    return value;
  }

 private:
  void unknown_enumerator(const toml::node& node, std::string_view label, const std::string& name,
                          const std::vector<std::string>& known);

  Evaluator& evaluator_;
  Diagnostics& diagnostics_;
};

}  // namespace fillrule::format
