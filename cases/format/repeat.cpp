#include "cases/format/repeat.h"

#include <string>
#include <vector>

namespace fillrule::format {
namespace {

struct Counter {
  std::string name;
  int64_t count;
};

std::vector<Counter> read_counters(const toml::table& table, size_t max_copies, Values& values) {
  std::vector<Counter> counters;
  const auto max = static_cast<int64_t>(max_copies);
  int64_t copies = 1;
  for (const Entry& entry : in_file_order(table)) {
    const std::string name = entry.name();
    if (const auto good = values.evaluator().check_name(name); !good) {
      values.diagnostics().add(place_of(*entry.key), good.error());
      continue;
    }
    const auto count = values.integer(*entry.value, fmt::format("repeat {}", name), {.min = 1, .max = max});
    // A count that cannot be read leaves one copy, so that the expressions are still checked.
    counters.push_back({name, count.value_or(1)});
    if (copies > max / counters.back().count) {
      values.diagnostics().add(place_of(table), "repeat makes too many vertices",
                               fmt::format("at most {} copies of this draw fit", max));
      counters.back().count = 1;
    }
    copies *= counters.back().count;
  }
  return counters;
}

}  // namespace

void for_each_copy(const toml::node* node, size_t max_copies, Values& values, const std::function<void()>& emit) {
  const toml::table* const table = node == nullptr ? nullptr : as_table(*node, "repeat", values.diagnostics());
  if (table == nullptr) {
    emit();
    return;
  }
  const std::vector<Counter> counters = read_counters(*table, max_copies, values);
  std::vector<int64_t> position(counters.size(), 0);
  const size_t errors_before = values.diagnostics().count();
  for (bool more = true; more;) {
    for (size_t i = 0; i < counters.size(); ++i) {
      values.evaluator().define(counters[i].name, static_cast<double>(position[i]));
    }
    emit();
    // An error of one copy is most often that of all.
    if (values.diagnostics().count() > errors_before) break;
    more = false;
    for (size_t i = counters.size(); i-- > 0 && !more;) {
      position[i] = position[i] + 1 < counters[i].count ? position[i] + 1 : 0;
      more = position[i] != 0;
    }
  }
  for (const Counter& counter : counters) values.evaluator().undefine(counter.name);
}

}  // namespace fillrule::format
