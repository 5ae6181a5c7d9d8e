#include "harness/faults/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace fillrule::faults {

std::string to_text(const FaultTable& table) {
  size_t name_width = 0;
  for (const FaultRow& row : table.rows) name_width = std::max(name_width, row.entry.name.size());
  std::string text;
  size_t caught = 0;
  for (const FaultRow& row : table.rows) {
    caught += is_caught(row) ? 1 : 0;
    text +=
        fmt::format("{} {:<{}}  {:>4} cases  {}: {}\n", is_caught(row) ? "caught    " : "NOT CAUGHT", row.entry.name,
                    name_width, row.cases.size(), fmt::join(row.planes, ", "), fmt::join(examples(row), ", "));
  }
  for (const std::string& name : table.false_alarms) {
    text += fmt::format("FALSE ALARM: {} fails without any fault\n", name);
  }
  text += fmt::format("{} of {} faults caught by at least {} cases of at least {} topics\n", caught,
                      table.rows.size(), kLeastCases, kLeastTopics);
  return text;
}

std::string to_markdown(const FaultTable& table) {
  std::string text =
      "| fault | what the rasterizer does | class | cases | for instance | planes |\n"
      "|---|---|---|---|---|---|\n";
  for (const FaultRow& row : table.rows) {
    const std::vector<std::string> shown = examples(row);
    text += fmt::format("| `{}` | {} | {} | {} | {}{}{} | {} |\n", row.entry.name, row.entry.what, row.entry.source,
                        row.cases.size(), shown.empty() ? "" : "`", fmt::join(shown, "`, `"),
                        shown.empty() ? "" : "`", fmt::join(row.planes, ", "));
  }
  return text;
}

std::string to_json(const FaultTable& table) {
  using Json = nlohmann::ordered_json;
  Json json{{"faults", Json::array()}, {"false_alarms", table.false_alarms}};
  for (const FaultRow& row : table.rows) {
    json["faults"].push_back({{"name", row.entry.name},
                              {"what", row.entry.what},
                              {"source", row.entry.source},
                              {"caught", is_caught(row)},
                              {"caught_by", row.cases.size()},
                              {"cases", row.cases},
                              {"planes", row.planes}});
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fillrule::faults
