#include "harness/terminal/worst.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "harness/report/names.h"
#include "harness/report/printable.h"

namespace fillrule::terminal {
namespace {

using judge::PlaneKind;
using judge::PlaneVerdict;
using judge::SampleRecord;
using judge::Verdict;

constexpr size_t kIndent = 6;

// kNoOwner, as the number that the owner plane's records hold.
constexpr double kNoOwnerNumber = std::numeric_limits<uint32_t>::max();

bool holds_floats(const PlaneVerdict& plane) {
  return plane.kind == PlaneKind::kDepth || plane.kind == PlaneKind::kVarying;
}

std::string value_text(const PlaneVerdict& plane, double value) {
  if (plane.kind == PlaneKind::kOwner && value == kNoOwnerNumber) return "none";
  if (std::isnan(value)) return "nan";  // of either sign
  return holds_floats(plane) ? fmt::format("{:.9g}", value) : fmt::format("{}", value);
}

bool has_tolerance(const SampleRecord& sample) {
  return sample.tolerance > 0 && std::isfinite(sample.tolerance);
}

// Of the party that the verdict is about.
std::string ulps_text(const PlaneVerdict& plane, const SampleRecord& sample) {
  const bool of_reference = sample.verdict == Verdict::kReferenceFault && sample.reference;
  const double value = of_reference ? *sample.reference : sample.candidate;
  if (!holds_floats(plane) || std::isnan(sample.expected)) return "-";
  const double ulps = judge::ulps_between(value, sample.expected);
  return std::isnan(ulps) ? "nan" : fmt::format("{:.3g}", ulps);
}

struct Entry {
  const PlaneVerdict* plane = nullptr;
  const SampleRecord* sample = nullptr;
};

std::vector<Entry> worst_entries(const judge::CaseVerdict& verdict) {
  std::vector<Entry> entries;
  for (const PlaneVerdict& plane : verdict.planes) {
    for (const SampleRecord& sample : plane.worst_samples) entries.push_back({&plane, &sample});
  }
  std::ranges::stable_sort(entries,
                           [](const Entry& a, const Entry& b) { return judge::graver(*a.sample, *b.sample); });
  // Of each sample the gravest plane.
  std::vector<Entry> worst;
  for (const Entry& entry : entries) {
    const auto is_same = [&entry](const Entry& other) {
      return std::tie(other.sample->x, other.sample->y, other.sample->sample) ==
             std::tie(entry.sample->x, entry.sample->y, entry.sample->sample);
    };
    if (worst.size() < kShownSamples && std::ranges::none_of(worst, is_same)) worst.push_back(entry);
  }
  return worst;
}

std::string place_text(const SampleRecord& sample, bool with_sample) {
  return with_sample ? fmt::format("({}, {}) sample {}", sample.x, sample.y, sample.sample)
                     : fmt::format("({}, {})", sample.x, sample.y);
}

constexpr size_t kColumns = 8;
constexpr size_t kVerdictColumn = 2;
using Row = std::array<std::string, kColumns>;

Row row_of(const Entry& entry, bool with_sample) {
  const auto& [plane, sample] = entry;
  return {place_text(*sample, with_sample),
          component_name(*plane, *sample),
          std::string(report::name_of(sample->verdict)),
          value_text(*plane, sample->candidate),
          sample->reference ? value_text(*plane, *sample->reference) : "-",
          std::isnan(sample->expected) ? "-" : value_text(*plane, sample->expected),
          has_tolerance(*sample) ? fmt::format("{:.3g}", sample->tolerance) : "-",
          ulps_text(*plane, *sample)};
}

std::string padded(std::string_view text, size_t columns, bool to_the_right) {
  const std::string space(columns - std::min(columns, report::columns_of(text)), ' ');
  return to_the_right ? space + std::string(text) : std::string(text) + space;
}

std::string table_text(const std::vector<Row>& rows, const std::array<size_t, kColumns>& widths,
                       const std::vector<Entry>& entries, const Style& style) {
  std::string text;
  for (size_t r = 0; r < rows.size(); ++r) {
    text.append(kIndent, ' ');
    for (size_t c = 0; c < kColumns; ++c) {
      const std::string cell = padded(rows[r][c], widths[c], c > kVerdictColumn);
      const Role role = r == 0                ? Role::kDim
                        : c == kVerdictColumn ? role_of(entries[r - 1].sample->verdict)
                                              : Role::kPlain;
      text += style.paint(role, cell);
      text += c + 1 < kColumns ? "  " : "\n";
    }
  }
  return text;
}

std::string list_text(const std::vector<Entry>& entries, bool with_sample, const Style& style) {
  std::string text;
  for (const auto& [plane, sample] : entries) {
    const std::string line = fmt::format("{:{}}{} {}: {}, {}, {} ULP", "", kIndent, place_text(*sample, with_sample),
                                         component_name(*plane, *sample), report::name_of(sample->verdict),
                                         values_text(*plane, *sample), ulps_text(*plane, *sample));
    text += report::wrapped(line, style.columns, kIndent + 2) + "\n";
  }
  return text;
}

}  // namespace

std::string values_text(const PlaneVerdict& plane, const SampleRecord& sample) {
  std::string text = fmt::format("candidate {}", value_text(plane, sample.candidate));
  if (sample.reference) text += fmt::format(", reference {}", value_text(plane, *sample.reference));
  if (!std::isnan(sample.expected)) text += fmt::format(", exact {}", value_text(plane, sample.expected));
  if (has_tolerance(sample)) text += fmt::format(" +- {:.3g}", sample.tolerance);
  return text;
}

std::string component_name(const PlaneVerdict& plane, const SampleRecord& sample) {
  const std::string name = report::printable(plane.name);
  return plane.components > 1 ? fmt::format("{}.{}", name, "xyzw"[sample.component]) : name;
}

std::string worst_text(const judge::CaseVerdict& verdict, const Style& style) {
  const std::vector<Entry> entries = worst_entries(verdict);
  if (entries.empty()) return {};
  const bool with_sample = std::ranges::any_of(entries, [](const Entry& entry) { return entry.sample->sample > 0; });
  std::vector<Row> rows{{"pixel", "plane", "verdict", "candidate", "reference", "exact", "tolerance", "ULP"}};
  for (const Entry& entry : entries) rows.push_back(row_of(entry, with_sample));
  std::array<size_t, kColumns> widths{};
  size_t total = kIndent + 2 * (kColumns - 1);
  for (size_t c = 0; c < kColumns; ++c) {
    for (const Row& row : rows) widths[c] = std::max(widths[c], report::columns_of(row[c]));
    total += widths[c];
  }
  const std::string head =
      entries.size() == 1 ? "    the sample:\n" : fmt::format("    the {} worst samples:\n", entries.size());
  const bool fits = style.columns == 0 || total <= style.columns;
  return head + (fits ? table_text(rows, widths, entries, style) : list_text(entries, with_sample, style));
}

Role role_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kIdentical:
      return Role::kPlain;
    case Verdict::kPermitted:
      return Role::kPermitted;
    case Verdict::kImprecise:
      return Role::kCaution;
    case Verdict::kReferenceFault:
      return Role::kReference;
    case Verdict::kCandidateFault:
    case Verdict::kBothFault:
      return Role::kBad;
  }
  return Role::kPlain;
}

}  // namespace fillrule::terminal
