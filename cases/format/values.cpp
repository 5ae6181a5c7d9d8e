#include "cases/format/values.h"

#include <cmath>

namespace fillrule::format {

std::optional<Number> Values::number(const toml::node& node, std::string_view label) {
  if (const auto* const whole = node.as_integer()) return Number{.value = static_cast<double>(whole->get())};
  if (const auto* const real = node.as_floating_point()) return Number{.value = real->get()};
  const auto* const string = node.as_string();
  if (string == nullptr) {
    wrong_type(node, label, "a number", diagnostics_);
    return std::nullopt;
  }
  const std::string& expression = string->get();
  if (expression.starts_with('$')) {
    diagnostics_.add(place_of(node), fmt::format("{} must be a number, not \"{}\"", label, expression),
                     fmt::format("numeric variables are written without $: \"{}\"", expression.substr(1)));
    return std::nullopt;
  }
  const Result<Number> value = evaluator_.number(expression);
  if (!value) {
    diagnostics_.add(place_of(node), value.error());
    return std::nullopt;
  }
  return *value;
}

std::optional<float> Values::float32(const toml::node& node, std::string_view label) {
  const auto value = number(node, label);
  if (!value) return std::nullopt;
  const auto rounded = to_float32(*value);
  if (!rounded) {
    diagnostics_.add(place_of(node), fmt::format("{} = {} is beyond float32", label, value->value),
                     "write inf if infinity is meant");
  }
  return rounded;
}

std::optional<float> Values::finite_float32(const toml::node& node, std::string_view label) {
  const auto value = float32(node, label);
  if (value && !std::isfinite(*value)) {
    diagnostics_.add(place_of(node), fmt::format("{} must be finite, not {}", label, *value));
    return std::nullopt;
  }
  return value;
}

std::optional<double> Values::finite(const toml::node& node, std::string_view label) {
  const auto value = number(node, label);
  if (!value) return std::nullopt;
  if (!std::isfinite(value->value)) {
    diagnostics_.add(place_of(node), fmt::format("{} must be finite, not {}", label, value->value));
    return std::nullopt;
  }
  return value->value;
}

std::optional<int64_t> Values::integer(const toml::node& node, std::string_view label, IntegerRange range) {
  const auto value = number(node, label);
  if (!value) return std::nullopt;
  const bool whole = std::isfinite(value->value) && std::trunc(value->value) == value->value;
  if (!whole) {
    diagnostics_.add(place_of(node), fmt::format("{} must be a whole number, not {}", label, value->value));
    return std::nullopt;
  }
  if (value->value < static_cast<double>(range.min) || value->value > static_cast<double>(range.max)) {
    diagnostics_.add(place_of(node),
                     fmt::format("{} must be {} to {}, not {}", label, range.min, range.max, value->value));
    return std::nullopt;
  }
  return static_cast<int64_t>(value->value);
}

std::optional<bool> Values::boolean(const toml::node& node, std::string_view label) {
  if (const auto* const flag = node.as_boolean()) return flag->get();
  if (!node.is_string()) {
    wrong_type(node, label, "true or false", diagnostics_);
    return std::nullopt;
  }
  const auto word = text(node, label);
  if (!word) return std::nullopt;
  if (*word == "true") return true;
  if (*word == "false") return false;
  diagnostics_.add(place_of(node), fmt::format("{} must be true or false, not \"{}\"", label, *word));
  return std::nullopt;
}

std::optional<std::string> Values::text(const toml::node& node, std::string_view label) {
  const auto* const string = node.as_string();
  if (string == nullptr) {
    wrong_type(node, label, "a string", diagnostics_);
    return std::nullopt;
  }
  const Result<std::string> value = evaluator_.text(string->get());
  if (!value) {
    diagnostics_.add(place_of(node), value.error());
    return std::nullopt;
  }
  return *value;
}

void Values::unknown_enumerator(const toml::node& node, std::string_view label, const std::string& name,
                                const std::vector<std::string>& known) {
  diagnostics_.add(place_of(node), fmt::format("unknown {} \"{}\"", label, name), suggestion(name, known, "known"));
}

}  // namespace fillrule::format
