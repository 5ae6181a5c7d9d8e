#include "harness/faults/table.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "harness/faults/rasterizer.h"
#include "harness/judge/judge.h"

namespace fillrule::faults {
namespace {

constexpr uint32_t kSubpixelBits = 8;
constexpr std::string_view kVaryings = "varyings";

// The planes in which the judge finds a fault.
std::vector<std::string> planes_at_fault(const Case& one, const Planes& planes) {
  const judge::Party party{.planes = &planes, .subpixel_bits = kSubpixelBits};
  const judge::CaseVerdict verdict =
      judge::judge(one, party, nullptr, {.profile = {.top_left = true, .diamond_exit = true}});
  std::vector<std::string> found;
  for (const judge::PlaneVerdict& plane : verdict.planes) {
    if (plane.candidate_faults() == 0) continue;
    const std::string_view name = plane.name;
    found.emplace_back(plane.kind == judge::PlaneKind::kVarying ? kVaryings : name);
  }
  found.erase(std::unique(found.begin(), found.end()), found.end());  // varyings are the last ones
  return found;
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return std::ranges::equal(
      a, b, {}, [](float value) { return std::bit_cast<uint32_t>(value); },
      [](float value) { return std::bit_cast<uint32_t>(value); });
}

bool same_bits(const Planes& a, const Planes& b) {
  return a.hits == b.hits && a.owner == b.owner && a.front_facing == b.front_facing && same_bits(a.depth, b.depth) &&
         std::ranges::equal(a.varyings, b.varyings,
                            [](const auto& one, const auto& other) { return same_bits(one, other); });
}

// What one case says of each fault: the planes that catch it.
struct CaseFindings {
  bool false_alarm = false;
  std::vector<std::vector<std::string>> planes;
};

CaseFindings findings_of(const Case& one, std::span<const FaultEntry> faults) {
  CaseFindings findings;
  const Planes right = draw_case(one, Fault::kNone, kSubpixelBits);
  findings.false_alarm = !planes_at_fault(one, right).empty();
  for (const FaultEntry& entry : faults) {
    const Planes faulty = draw_case(one, entry.fault, kSubpixelBits);
    // Most faults show in few cases, and what is drawn rightly needs no second verdict.
    findings.planes.push_back(same_bits(faulty, right) ? std::vector<std::string>{} : planes_at_fault(one, faulty));
  }
  return findings;
}

std::string topic_of(const std::string& case_name) {
  return case_name.substr(0, case_name.find('/'));
}

std::string file_of(const std::string& case_name) {
  return case_name.substr(0, case_name.find('['));
}

// The words between underscores and slashes.
std::set<std::string> words_of(std::string_view name) {
  std::set<std::string> words;
  for (size_t begin = 0; begin <= name.size();) {
    const size_t end = std::min(name.find_first_of("_/", begin), name.size());
    words.emplace(name.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

FaultRow row_of(std::span<const Case> cases, const std::vector<CaseFindings>& findings, const FaultEntry& entry,
                size_t number) {
  FaultRow row{.entry = entry};
  std::map<std::string, size_t> counts;
  for (size_t i = 0; i < cases.size(); ++i) {
    const std::vector<std::string>& planes = findings[i].planes[number];
    if (!planes.empty()) row.cases.push_back(cases[i].name);
    for (const std::string& plane : planes) ++counts[plane];
  }
  for (const auto& [plane, count] : counts) row.planes.push_back(plane);
  std::ranges::stable_sort(row.planes, std::ranges::greater{}, [&](const std::string& one) { return counts[one]; });
  return row;
}

}  // namespace

FaultTable catch_faults(std::span<const Case> cases, std::span<const FaultEntry> faults, uint32_t jobs,
                        const Progress& progress) {
  std::vector<CaseFindings> findings(cases.size());
  std::atomic<size_t> next = 0;
  std::mutex mutex;
  uint64_t done = 0;
  const auto work = [&] {
    for (size_t i = next++; i < cases.size(); i = next++) {
      findings[i] = findings_of(cases[i], faults);
      const std::lock_guard lock(mutex);
      ++done;
      if (progress) progress(done);
    }
  };
  {
    std::vector<std::jthread> threads;
    for (uint32_t i = 0; i < std::max(jobs, 1U); ++i) threads.emplace_back(work);
  }
  FaultTable table;
  for (size_t i = 0; i < cases.size(); ++i) {
    if (findings[i].false_alarm) table.false_alarms.push_back(cases[i].name);
  }
  for (size_t i = 0; i < faults.size(); ++i) table.rows.push_back(row_of(cases, findings, faults[i], i));
  return table;
}

bool is_named_after(const std::string& case_name, std::string_view fault) {
  const std::set<std::string> words = words_of(file_of(case_name));
  return std::ranges::includes(words, words_of(fault));
}

bool is_caught(const FaultRow& row) {
  std::set<std::string> topics;
  size_t cases = 0;
  for (const std::string& name : row.cases) {
    if (is_named_after(name, row.entry.name)) continue;
    ++cases;
    topics.insert(topic_of(name));
  }
  return cases >= kLeastCases && topics.size() >= kLeastTopics;
}

std::vector<std::string> examples(const FaultRow& row) {
  std::vector<std::string> chosen;
  const auto differs = [&](const std::string& name, const auto& part_of) {
    return std::ranges::none_of(chosen, [&](const std::string& other) { return part_of(other) == part_of(name); });
  };
  // The most telling ones first; then whatever there is.
  for (const int strictness : {3, 2, 1, 0}) {
    for (const std::string& name : row.cases) {
      if (chosen.size() == kLeastCases) return chosen;
      const bool fits = (strictness < 1 || !is_named_after(name, row.entry.name)) &&
                        (strictness < 2 || differs(name, file_of)) && (strictness < 3 || differs(name, topic_of));
      if (fits && differs(name, [](const std::string& whole) { return whole; })) chosen.push_back(name);
    }
  }
  return chosen;
}

}  // namespace fillrule::faults
