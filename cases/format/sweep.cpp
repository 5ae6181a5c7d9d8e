#include "cases/format/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/format/values.h"

namespace fillrule::format {
namespace {

// The text of a number that stands on one line; TOML numbers are ASCII, but what is before them may not be, and
// columns count characters.
std::string quote(const toml::source_region& region, std::string_view text) {
  size_t begin = 0;
  for (uint32_t line = 1; line < region.begin.line; ++line) begin = text.find('\n', begin) + 1;
  const auto is_continuation = [&](size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U; };
  for (uint32_t column = 1; column < region.begin.column; ++column) {
    ++begin;
    while (begin < text.size() && is_continuation(begin)) ++begin;
  }
  return std::string(trim(text.substr(begin, region.end.column - region.begin.column)));
}

bool is_word(std::string_view text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !text.empty() && letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

class SweepReader {
 public:
  SweepReader(std::string_view text, Evaluator& evaluator, Diagnostics& diagnostics)
      : text_(text), values_(evaluator, diagnostics), diagnostics_(diagnostics) {}

  void read(const Entry& entry, Sweep& sweep) {
    SweepVariable variable{.name = entry.name()};
    if (const auto good = values_.evaluator().check_name(variable.name); !good) {
      diagnostics_.add(place_of(*entry.key), good.error());
      return;
    }
    if (const toml::array* const list = entry.value->as_array()) {
      read_list(*list, variable);
    } else if (const toml::table* const range = entry.value->as_table()) {
      read_range(*range, variable);
    } else {
      wrong_type(*entry.value, fmt::format("sweep variable \"{}\"", variable.name), "a list or a range", diagnostics_,
                 "for example [0, 15] or { from = 0, to = 90, step = 15 }");
    }
    if (!variable.values.empty()) sweep.variables.push_back(std::move(variable));
  }

 private:
  void read_list(const toml::array& list, SweepVariable& variable) {
    if (list.empty())
      diagnostics_.add(place_of(list), fmt::format("sweep variable \"{}\" has no values", variable.name));
    bool has_number = false;
    for (const toml::node& node : list) {
      if (is_text(node)) {
        variable.is_text = true;
        variable.values.push_back({.written = written_value(node, text_)});
      } else if (const auto number = values_.number(node, fmt::format("sweep variable \"{}\"", variable.name))) {
        has_number = true;
        variable.values.push_back({.written = written_value(node, text_), .number = number->value});
      } else {
        continue;
      }
      const std::string& text = variable.values.back().written;
      const auto same = std::count_if(variable.values.begin(), variable.values.end(),
                                      [&](const SweepValue& value) { return value.written == text; });
      if (same == 2) {
        diagnostics_.add(place_of(node),
                         fmt::format("sweep variable \"{}\" has the value {} twice", variable.name, text),
                         "cases would have one name");
      }
    }
    if (variable.is_text && has_number) {
      diagnostics_.add(place_of(list), fmt::format("sweep variable \"{}\" mixes numbers and text", variable.name));
      variable.values.clear();
    }
  }

  // A word that means no number, or a boolean (for "$test" where true or false is expected).
  bool is_text(const toml::node& node) {
    if (node.is_boolean()) return true;
    const auto* const string = node.as_string();
    return string != nullptr && is_word(trim(string->get())) && !values_.evaluator().number(string->get());
  }

  void read_range(const toml::table& range, SweepVariable& variable) {
    check_keys({range, fmt::format("sweep variable \"{}\"", variable.name)}, {"from", "to", "step"}, diagnostics_);
    const auto bound = [&](std::string_view key) -> std::optional<double> {
      const toml::node* const node = range.get(key);
      if (node == nullptr) {
        diagnostics_.add(place_of(range), fmt::format(R"(sweep variable "{}" lacks "{}")", variable.name, key),
                         "write { from = 0, to = 90, step = 15 }");
        return std::nullopt;
      }
      const auto number = values_.number(*node, key);
      if (!number) return std::nullopt;
      if (!std::isfinite(number->value)) {
        diagnostics_.add(place_of(*node), fmt::format("{} must be finite, not {}", key, number->value));
        return std::nullopt;
      }
      return number->value;
    };
    const auto from = bound("from");
    const auto to = bound("to");
    const auto step = bound("step");
    if (!from || !to || !step) return;
    // `to` itself belongs to the range, also where the steps miss it by rounding.
    const double steps = std::floor((*to - *from) / *step + 1e-9);
    if (*step == 0.0 || !(steps >= 0.0)) {
      diagnostics_.add(place_of(range), fmt::format("sweep variable \"{}\" never gets from {} to {} by steps of {}",
                                                    variable.name, *from, *to, *step));
      return;
    }
    // One too many is enough for the error that they are too many.
    const auto last = static_cast<size_t>(std::fmin(steps, static_cast<double>(kMaxCasesPerFile)));
    for (size_t i = 0; i <= last; ++i) {
      const double value = *from + static_cast<double>(i) * *step;
      variable.values.push_back({.written = fmt::format("{:.12g}", value), .number = value});
    }
  }

  std::string_view text_;
  Values values_;
  Diagnostics& diagnostics_;
};

}  // namespace

size_t Sweep::size() const {
  size_t size = 1;
  for (const SweepVariable& variable : variables) size *= variable.values.size();
  return size;
}

std::vector<size_t> Sweep::values_of(size_t index) const {
  std::vector<size_t> values(variables.size());
  for (size_t i = variables.size(); i-- > 0;) {
    values[i] = index % variables[i].values.size();
    index /= variables[i].values.size();
  }
  return values;
}

size_t Sweep::index_of(const std::vector<size_t>& values) const {
  size_t index = 0;
  for (size_t i = 0; i < variables.size(); ++i) index = index * variables[i].values.size() + values[i];
  return index;
}

void Sweep::define(size_t index, Evaluator& evaluator) const {
  const std::vector<size_t> values = values_of(index);
  for (size_t i = 0; i < variables.size(); ++i) {
    const SweepValue& value = variables[i].values[values[i]];
    if (variables[i].is_text) {
      evaluator.define_text(variables[i].name, value.written);
    } else {
      evaluator.define(variables[i].name, value.number);
    }
  }
}

std::string Sweep::suffix(size_t index) const {
  if (variables.empty()) return {};
  const std::vector<size_t> values = values_of(index);
  std::string suffix;
  for (size_t i = 0; i < variables.size(); ++i) {
    suffix += fmt::format("{}{}={}", i == 0 ? "" : ",", variables[i].name, variables[i].values[values[i]].written);
  }
  return fmt::format("[{}]", suffix);
}

std::string written_value(const toml::node& node, std::string_view text) {
  if (const auto* const string = node.as_string()) return std::string(trim(string->get()));
  return quote(node.source(), text);
}

Sweep read_sweep(const toml::table& root, std::string_view text, Evaluator& evaluator, Diagnostics& diagnostics) {
  Sweep sweep;
  const toml::node* const node = root.get("sweep");
  const toml::table* const table = node == nullptr ? nullptr : as_table(*node, "sweep", diagnostics);
  if (table == nullptr) return sweep;
  SweepReader reader(text, evaluator, diagnostics);
  double cases = 1.0;
  for (const Entry& entry : in_file_order(*table)) {
    const size_t variables = sweep.variables.size();
    reader.read(entry, sweep);
    if (sweep.variables.size() > variables) cases *= static_cast<double>(sweep.variables.back().values.size());
  }
  if (cases > static_cast<double>(kMaxCasesPerFile)) {
    diagnostics.add(place_of(*node), "sweep makes too many cases",
                    fmt::format("a file expands to at most {}", kMaxCasesPerFile));
    for (SweepVariable& variable : sweep.variables) variable.values.resize(1);
  }
  return sweep;
}

}  // namespace fillrule::format
