#include "harness/report/html_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "harness/report/html_assets.h"
#include "harness/report/html_summary.h"
#include "harness/report/names.h"

namespace fillrule::report {
namespace {

using Json = nlohmann::ordered_json;

// What a small case takes.
constexpr size_t kSmallCase = 8'000;

// JSON inside of a script element: no text in it can end the element, or be taken for markup.
std::string for_script(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

std::string script(std::string_view id, const Json& json) {
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, for_script(json));
}

// In the order of kColumns.
constexpr std::array kColumns{"name",       "status",    "candidate_faults", "reference_faults",
                              "new_faults", "imprecise", "permitted",        "seconds",
                              "why"};

Json row_of(const run::CaseResult& one, bool unexpected, const std::string& sentence) {
  std::string why = sentence.empty() ? one.message : sentence;
  for (const judge::CheckResult& check : one.checks) {
    if (check.outcome != judge::CheckResult::Outcome::kFailed) continue;
    why += fmt::format("{}The check {} failed: {}", why.empty() ? "" : " ", check.name, check.message);
  }
  return {one.name,
          name_of(one.status),
          one.verdict.candidate_faults(),
          one.verdict.reference_faults(),
          unexpected ? 1 : 0,
          one.verdict.count(judge::Verdict::kImprecise),
          one.verdict.count(judge::Verdict::kPermitted),
          static_cast<float>(one.seconds),
          why};
}

Json reference_json(const run::Reference& reference) {
  return {{"driver", reference.driver},
          {"name", reference.name},
          {"version", reference.version},
          {"subpixel_bits", reference.subpixel_bits}};
}

// Puts the value in the place of the mark, which is there once.
void fill(std::string& page, std::string_view mark, std::string_view value) {
  page.replace(page.find(mark), mark.size(), value);
}

}  // namespace

bool HtmlReport::has_room() const {
  return bytes_ + kSmallCase <= most_bytes_;
}

bool HtmlReport::add(size_t index, HtmlCase encoded) {
  const bool fits = bytes_ + encoded.json.size() <= most_bytes_;
  if (!fits) {
    encoded.json.clear();
    add_statistics(index);
  }
  bytes_ += encoded.json.size();
  blocks_.push_back({.index = index, .sentence = encoded.diagnosis.sentence, .json = std::move(encoded.json)});
  return fits;
}

const HtmlReport::Block* HtmlReport::block_of(size_t index) const {
  const auto found = std::ranges::find(blocks_, index, &Block::index);
  return found == blocks_.end() ? nullptr : &*found;
}

std::string HtmlReport::page(const run::RunResult& result, const run::DeviationReport& deviations,
                             const std::optional<std::string>& faults) const {
  std::vector<std::string> sentences(result.cases.size());
  for (const Block& block : blocks_) sentences[block.index] = block.sentence;
  std::unordered_set<std::string> unexpected;
  for (const run::DeviationReport::Fault& fault : deviations.unexpected) unexpected.insert(fault.case_name);
  Json run{{"candidate", {{"name", result.candidate}, {"subpixel_bits", result.candidate_subpixel_bits}}},
           {"reference", reference_json(result.reference)},
           {"wall_seconds", result.summary.wall_seconds},
           {"most_bytes", most_bytes_},
           {"without_planes", without_planes_},
           {"sentences", Json::object()},
           {"columns", kColumns},
           {"cases", Json::array()}};
  for (const Block& block : blocks_) run["sentences"][std::to_string(block.index)] = block.sentence;
  for (size_t i = 0; i < result.cases.size(); ++i) {
    run["cases"].push_back(row_of(result.cases[i], unexpected.contains(result.cases[i].name), sentences[i]));
  }
  if (faults) {
    Json table = Json::parse(*faults, nullptr, false);
    if (!table.is_discarded() && table.contains("faults")) run["faults"] = std::move(table["faults"]);
  }
  std::string data = script("run", run);
  for (const Block& block : blocks_) {
    if (block.json.empty()) continue;
    data += fmt::format("<script type=\"application/json\" id=\"case-{}\">{}</script>\n", block.index, block.json);
  }
  std::string page(html_template());
  fill(page, "<!-- style -->", html_style());
  fill(page, "<!-- summary -->",
       html_summary(result, deviations, [&sentences](size_t index) { return sentences[index]; }));
  fill(page, "<!-- data -->", data);
  fill(page, "<!-- script -->", html_script());
  return page;
}

}  // namespace fillrule::report
