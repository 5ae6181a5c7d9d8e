#include "harness/report/merge_pages.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_map>

#include "harness/report/html_report.h"
#include "harness/report/json.h"

namespace fillrule::report {
namespace {

using Json = nlohmann::ordered_json;

// What the pages tell of one case at fault.
struct Shown {
  size_t index = 0;  // in the merged results
  HtmlCase encoded;
};

struct Pages {
  std::vector<Shown> cases;
  std::vector<size_t> without_planes;
  std::optional<std::string> faults;  // as in faults.json
};

// The text of a script element; none if there is no such element.
std::optional<std::string> script_text(const std::string& page, const std::string& id) {
  const std::string start = R"(<script type="application/json" id=")" + id + R"(">)";
  const size_t found = page.find(start);
  if (found == std::string::npos) return std::nullopt;
  const size_t begin = found + start.size();
  const size_t end = page.find("</script>", begin);
  if (end == std::string::npos) return std::nullopt;
  return page.substr(begin, end - begin);
}

// Adds what a page shows. `places`: where the cases are in the merged results, by name. Throws what the JSON library
// does where the page's data is not as HtmlReport writes it.
void read_page(const std::string& page, const std::unordered_map<std::string, size_t>& places, Pages& pages) {
  const Json run = Json::parse(script_text(page, "run").value_or(""));
  const auto place_of = [&](size_t index) {
    const auto found = places.find(run.at("cases").at(index).at(0).get<std::string>());
    return found == places.end() ? std::optional<size_t>() : found->second;
  };
  for (const auto& [index, sentence] : run.at("sentences").items()) {
    const auto place = place_of(std::stoul(index));
    const auto block = script_text(page, "case-" + index);
    if (!place || !block) continue;
    Shown shown{.index = *place};
    shown.encoded.diagnosis.sentence = sentence.get<std::string>();
    shown.encoded.json = *block;
    pages.cases.push_back(std::move(shown));
  }
  for (const Json& index : run.at("without_planes")) {
    if (const auto place = place_of(index.get<size_t>())) pages.without_planes.push_back(*place);
  }
  if (!pages.faults && run.contains("faults")) pages.faults = Json{{"faults", run["faults"]}}.dump();
}

Result<Pages> read_pages(const std::vector<std::string>& folders,
                         const std::unordered_map<std::string, size_t>& places) {
  Pages pages;
  for (const std::string& folder : folders) {
    const std::string path = folder + "/report.html";
    std::ifstream file(path, std::ios::binary);
    if (!file) {
      return tl::unexpected(Error{
          .file = path, .what = "cannot be read", .hint = "merge the folders that 'fillrule run --report' wrote"});
    }
    try {
      read_page(std::string(std::istreambuf_iterator<char>(file), {}), places, pages);
    } catch (const std::exception&) {
      return tl::unexpected(Error{.file = path, .what = "is not a report of this version of fillrule"});
    }
  }
  return pages;
}

}  // namespace

Result<void> merge_pages(const std::vector<std::string>& folders, const std::string& folder,
                         const run::RunResult& merged, const run::DeviationReport& deviations) {
  std::unordered_map<std::string, size_t> places;
  for (size_t i = 0; i < merged.cases.size(); ++i) places.emplace(merged.cases[i].name, i);
  Result<Pages> pages = read_pages(folders, places);
  if (!pages) return tl::unexpected(pages.error());
  // As in a run: where room is short, the cases that failed have it.
  std::ranges::sort(pages->cases, {}, [&merged](const Shown& shown) {
    return std::pair(merged.cases[shown.index].status != run::Status::kFailed, shown.index);
  });
  HtmlReport html;
  for (Shown& shown : pages->cases) html.add(shown.index, std::move(shown.encoded));
  for (const size_t index : pages->without_planes) html.add_statistics(index);
  return write_text(folder + "/report.html", html.page(merged, deviations, pages->faults));
}

}  // namespace fillrule::report
