#include "harness/run/deviations.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>

#include "cases/format/glob.h"
#include "cases/format/toml_access.h"

namespace fillrule::run {
namespace {

using format::Diagnostics;

std::string read_text(const toml::table& table, std::string_view key, Diagnostics& diagnostics) {
  const toml::node* const node = table.get(key);
  if (node == nullptr || !node->is_string() || node->value_or(std::string()).empty()) {
    diagnostics.add(format::place_of(node == nullptr ? static_cast<const toml::node&>(table) : *node),
                    fmt::format("a deviation needs the text \"{}\"", key),
                    "each has cases, planes, reason and source");
    return {};
  }
  return node->value_or(std::string());
}

std::vector<std::string> read_texts(const toml::table& table, std::string_view key, std::string_view hint,
                                    Diagnostics& diagnostics) {
  std::vector<std::string> texts;
  if (const toml::array* const array = table[key].as_array()) {
    for (const toml::node& text : *array) texts.push_back(text.value_or(std::string()));
  }
  if (texts.empty() || std::find(texts.begin(), texts.end(), "") != texts.end()) {
    diagnostics.add(format::place_of(table), fmt::format("a deviation needs the list of its {}", key),
                    std::string(hint));
  }
  return texts;
}

Deviation read_deviation(const toml::table& table, Diagnostics& diagnostics) {
  format::check_keys({table, "[[deviation]]"}, {"cases", "planes", "reason", "source"}, diagnostics);
  return {.cases = read_texts(table, "cases", "write cases = [\"clipping/near*\"]", diagnostics),
          .planes = read_texts(table, "planes", "write planes = [\"depth\"]", diagnostics),
          .reason = read_text(table, "reason", diagnostics),
          .source = read_text(table, "source", diagnostics)};
}

bool is_about(const Deviation& deviation, const std::string& case_name) {
  return std::any_of(deviation.cases.begin(), deviation.cases.end(),
                     [&](const std::string& pattern) { return format::glob_matches(pattern, case_name); });
}

bool covers(const Deviation& deviation, const std::string& case_name, const std::string& plane) {
  return std::find(deviation.planes.begin(), deviation.planes.end(), plane) != deviation.planes.end() &&
         is_about(deviation, case_name);
}

// A plane of the entry had a fault in none of the entry's cases, of which at least one was judged.
bool is_gone(const Deviation& deviation, const std::vector<CaseResult>& cases) {
  return std::any_of(deviation.planes.begin(), deviation.planes.end(), [&](const std::string& plane) {
    bool judged = false;
    for (const CaseResult& result : cases) {
      if (!is_about(deviation, result.name)) continue;
      for (const judge::PlaneVerdict& verdict : result.verdict.planes) {
        if (verdict.name != plane) continue;
        if (verdict.reference_faults() > 0) return false;
        judged = true;
      }
    }
    return judged;
  });
}

}  // namespace

std::string deviations_file_name(const Reference& reference) {
  const std::string& text = reference.version;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto begin = std::find_if(text.begin(), text.end(), is_digit);
  const auto end = std::find_if_not(begin, text.end(), [&](char c) { return is_digit(c) || c == '.'; });
  return fmt::format("{}-{}.toml", reference.driver, std::string(begin, end));
}

Result<std::vector<Deviation>> read_deviations(const std::string& path) {
  std::vector<Deviation> deviations;
  Diagnostics diagnostics(path);
  try {
    const toml::table root = toml::parse_file(path);
    format::check_keys({root, "the list of deviations"}, {"deviation"}, diagnostics);
    if (const toml::array* const array = root["deviation"].as_array()) {
      for (const toml::node& node : *array) {
        if (const toml::table* const table = node.as_table()) {
          deviations.push_back(read_deviation(*table, diagnostics));
        } else {
          format::wrong_type(node, "deviation", "a table", diagnostics);
        }
      }
    }
  } catch (const toml::parse_error& error) {
    const toml::source_position place = error.source().begin;
    diagnostics.add({.line = place.line, .column = place.column}, std::string(error.description()));
  }
  if (!diagnostics.empty()) return tl::unexpected(diagnostics.take().front());
  return deviations;
}

Result<std::vector<Deviation>> known_deviations(const std::string& folder, const Reference& reference) {
  const std::string path = folder + "/" + deviations_file_name(reference);
  if (!std::filesystem::exists(path)) return {};
  return read_deviations(path);
}

DeviationReport compare_with_known(const std::vector<CaseResult>& cases, const std::vector<Deviation>& known) {
  DeviationReport report;
  for (const CaseResult& result : cases) {
    for (const judge::PlaneVerdict& plane : result.verdict.planes) {
      if (plane.reference_faults() == 0) continue;
      const bool is_known = std::any_of(known.begin(), known.end(), [&](const Deviation& deviation) {
        return covers(deviation, result.name, plane.name);
      });
      (is_known ? report.known : report.unexpected)
          .push_back({.case_name = result.name, .plane = plane.name, .samples = plane.reference_faults()});
    }
  }
  std::copy_if(known.begin(), known.end(), std::back_inserter(report.gone),
               [&cases](const Deviation& deviation) { return is_gone(deviation, cases); });
  return report;
}

}  // namespace fillrule::run
