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
                    "each has case, planes, reason and source");
    return {};
  }
  return node->value_or(std::string());
}

std::vector<std::string> read_planes(const toml::table& table, Diagnostics& diagnostics) {
  std::vector<std::string> planes;
  if (const toml::array* const array = table["planes"].as_array()) {
    for (const toml::node& plane : *array) planes.push_back(plane.value_or(std::string()));
  }
  if (planes.empty() || std::find(planes.begin(), planes.end(), "") != planes.end()) {
    diagnostics.add(format::place_of(table), "a deviation needs the names of its planes",
                    "write planes = [\"depth\"]");
  }
  return planes;
}

Deviation read_deviation(const toml::table& table, Diagnostics& diagnostics) {
  format::check_keys({table, "[[deviation]]"}, {"case", "planes", "reason", "source"}, diagnostics);
  return {.case_pattern = read_text(table, "case", diagnostics),
          .planes = read_planes(table, diagnostics),
          .reason = read_text(table, "reason", diagnostics),
          .source = read_text(table, "source", diagnostics)};
}

bool covers(const Deviation& deviation, const std::string& case_name, const std::string& plane) {
  return std::find(deviation.planes.begin(), deviation.planes.end(), plane) != deviation.planes.end() &&
         format::glob_matches(deviation.case_pattern, case_name);
}

// A plane of the entry had a fault in none of the entry's cases, of which at least one was judged.
bool is_gone(const Deviation& deviation, const std::vector<CaseResult>& cases) {
  return std::any_of(deviation.planes.begin(), deviation.planes.end(), [&](const std::string& plane) {
    bool judged = false;
    for (const CaseResult& result : cases) {
      if (!format::glob_matches(deviation.case_pattern, result.name)) continue;
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
