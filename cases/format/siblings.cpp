#include "cases/format/siblings.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/format/enums.h"
#include "cases/format/suggestion.h"

namespace fillrule::format {
namespace {

constexpr std::string_view kControlHint =
    "name another case, control = \"topic/name\", or a value of the sweep, control = { size = 1 }";

bool fits(const SweepSelection& selection, const std::vector<size_t>& values) {
  for (size_t i = 0; i < values.size(); ++i) {
    if (selection[i] && *selection[i] != values[i]) return false;
  }
  return true;
}

class SiblingsReader {
 public:
  SiblingsReader(std::string_view text, const Sweep& sweep, Diagnostics& diagnostics)
      : text_(text), sweep_(sweep), diagnostics_(diagnostics) {}

  void read_control(const toml::node& node, Siblings& siblings) {
    if (const toml::table* const values = node.as_table()) {
      siblings.control_values = read_selection(*values, "control");
    } else if (const auto* const name = node.as_string()) {
      siblings.control_name = trim(name->get());
      if (siblings.control_name.empty())
        diagnostics_.add(place_of(node), "control is empty", std::string(kControlHint));
    } else {
      wrong_type(node, "control", "a case's name or a table", diagnostics_, std::string(kControlHint));
    }
  }

  void read_expect(const toml::node& node, Siblings& siblings) {
    if (const auto* const word = node.as_string()) {
      const std::optional<Effect> effect = enum_value(kEffects, word->get());
      if (effect) {
        siblings.effect = *effect;
      } else {
        diagnostics_.add(place_of(node), fmt::format("expect knows no \"{}\"", word->get()),
                         suggestion(word->get(), enum_names(kEffects), "the values are"));
      }
      return;
    }
    const toml::table* const table = node.as_table();
    if (table == nullptr) {
      wrong_type(node, "expect", "a word or a table", diagnostics_,
                 "for example \"nothing\" or { nothing = [{ size = 0 }] }");
      return;
    }
    check_keys({*table, "expect"}, {"nothing", "same"}, diagnostics_);
    for (const Entry& entry : in_file_order(*table)) read_effects(entry, siblings);
  }

 private:
  void read_effects(const Entry& entry, Siblings& siblings) {
    const std::optional<Effect> effect = enum_value(kEffects, entry.name());
    const toml::array* const selections = as_array(*entry.value, entry.name(), "an array of tables", diagnostics_);
    if (!effect || selections == nullptr) return;
    for (const toml::node& node : *selections) {
      const toml::table* const table = as_table(node, entry.name(), diagnostics_);
      if (table == nullptr) continue;
      if (auto selection = read_selection(*table, entry.name())) siblings.effects.emplace_back(*selection, *effect);
    }
  }

  std::optional<SweepSelection> read_selection(const toml::table& table, std::string_view label) {
    SweepSelection selection(sweep_.variables.size());
    bool good = true;
    for (const Entry& entry : in_file_order(table)) {
      const auto variable = std::ranges::find(sweep_.variables, entry.name(), &SweepVariable::name);
      if (variable == sweep_.variables.end()) {
        std::vector<std::string> names;
        for (const SweepVariable& one : sweep_.variables) names.push_back(one.name);
        diagnostics_.add(place_of(*entry.key),
                         fmt::format("{}: the sweep has no variable \"{}\"", label, entry.name()),
                         suggestion(entry.name(), names, "its variables are"));
        good = false;
        continue;
      }
      const std::optional<size_t> value = find_value(*variable, *entry.value);
      good = good && value.has_value();
      selection[static_cast<size_t>(variable - sweep_.variables.begin())] = value;
    }
    if (good && table.empty()) {
      diagnostics_.add(place_of(table), fmt::format("{} names no variable of the sweep", label));
      good = false;
    }
    return good ? std::optional(selection) : std::nullopt;
  }

  // As it is written in the sweep, or else by its number: 1000 is 1e3.
  std::optional<size_t> find_value(const SweepVariable& variable, const toml::node& node) {
    const std::string written = written_value(node, text_);
    const auto by_text = std::ranges::find(variable.values, written, &SweepValue::written);
    if (by_text != variable.values.end()) return static_cast<size_t>(by_text - variable.values.begin());
    const std::optional<double> number = node.value<double>();
    const auto by_number = std::ranges::find_if(
        variable.values, [&](const SweepValue& value) { return !variable.is_text && number == value.number; });
    if (by_number != variable.values.end()) return static_cast<size_t>(by_number - variable.values.begin());
    std::vector<std::string> known;
    for (const SweepValue& value : variable.values) known.push_back(value.written);
    diagnostics_.add(place_of(node), fmt::format("the sweep's {} has no value {}", variable.name, written),
                     suggestion(written, known, "its values are"));
    return std::nullopt;
  }

  std::string_view text_;
  const Sweep& sweep_;
  Diagnostics& diagnostics_;
};

}  // namespace

void Siblings::apply(const std::string& name, const Sweep& sweep, size_t index, Case& one) const {
  std::vector<size_t> values = sweep.values_of(index);
  const bool is_control = control_values && fits(*control_values, values);
  one.effect = is_control ? Effect::kDifferent : effect;
  const auto own = std::ranges::find_if(effects, [&](const auto& some) { return fits(some.first, values); });
  if (own != effects.end()) one.effect = own->second;
  one.control = control_name;
  if (!control_values || is_control) return;
  for (size_t i = 0; i < values.size(); ++i) values[i] = (*control_values)[i].value_or(values[i]);
  one.control = name + sweep.suffix(sweep.index_of(values));
}

Siblings read_siblings(const toml::table& root, std::string_view text, const Sweep& sweep, Diagnostics& diagnostics) {
  Siblings siblings;
  SiblingsReader reader(text, sweep, diagnostics);
  if (const toml::node* const node = root.get("control")) reader.read_control(*node, siblings);
  if (const toml::node* const node = root.get("expect")) reader.read_expect(*node, siblings);
  return siblings;
}

}  // namespace fillrule::format
