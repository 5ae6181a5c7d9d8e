#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "cases/format/suite.h"
#include "harness/faults/table.h"
#include "harness/faults/text.h"
#include "harness/scene/build.h"

namespace fillrule::faults {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Catalogue, HasEveryFaultOnceInOrder) {
  uint8_t expected = 0;
  std::set<std::string_view> names;
  for (const FaultEntry& entry : catalogue()) {
    EXPECT_EQ(static_cast<uint8_t>(entry.fault), ++expected) << entry.name;
    EXPECT_FALSE(entry.what.empty() || entry.source.empty()) << entry.name;
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_EQ(fault_named(entry.name), entry.fault);
  }
  EXPECT_EQ(fault_named("none"), Fault::kNone);
}

TEST(Catalogue, AnUnknownNameIsAnErrorThatTellsTheNearestOrAll) {
  const auto misspelt = fault_named("afine_varyings");
  ASSERT_FALSE(misspelt);
  EXPECT_EQ(misspelt.error().what, "there is no fault 'afine_varyings'");
  EXPECT_EQ(misspelt.error().hint, "did you mean \"affine_varyings\"?");
  EXPECT_THAT(fault_named("xyz").error().hint, HasSubstr("strip_parity_ignored"));
}

FaultRow row_with(std::vector<std::string> cases) {
  return {.entry = {.fault = Fault::kLineTies, .name = "line_ties", .what = "w", .source = "s"},
          .cases = std::move(cases),
          .planes = {"hits"}};
}

TEST(FaultRule, AsksForThreeCasesOfTwoTopicsThatAreNotNamedAfterTheFault) {
  EXPECT_TRUE(is_caught(row_with({"lines/a", "lines/b", "depth/c"})));
  EXPECT_FALSE(is_caught(row_with({"lines/a", "depth/c"})));
  EXPECT_FALSE(is_caught(row_with({"lines/a", "lines/b", "lines/c"})));
  EXPECT_FALSE(is_caught(row_with({"lines/a", "lines/b", "depth/ties_of_line"})));
  EXPECT_FALSE(is_caught(row_with({})));
}

TEST(FaultRule, ACaseIsNamedAfterAFaultIfItHoldsAllOfItsWords) {
  EXPECT_TRUE(is_named_after("lines/line_and_its_ties[x=1]", "line_ties"));
  EXPECT_FALSE(is_named_after("lines/diagonals", "line_ties"));
  EXPECT_FALSE(is_named_after("points/line[case=ties]", "line_ties"));
}

TEST(FaultRule, ExamplesAreOfDifferentTopicsAndFilesAsFarAsThereAre) {
  EXPECT_THAT(examples(row_with({"depth/line_ties", "lines/a[x=1]", "lines/a[x=2]", "lines/b", "depth/c", "flat/d"})),
              ElementsAre("lines/a[x=1]", "depth/c", "flat/d"));
  EXPECT_THAT(examples(row_with({"lines/a[x=1]", "lines/a[x=2]", "lines/b"})),
              ElementsAre("lines/a[x=1]", "lines/b", "lines/a[x=2]"));
  EXPECT_THAT(examples(row_with({"lines/line_ties"})), ElementsAre("lines/line_ties"));
}

TEST(FaultText, TellsWhatIsCaughtAndWhatIsNot) {
  const FaultTable table{.rows = {row_with({"lines/a", "lines/b", "depth/c"}), row_with({"lines/a"})},
                         .false_alarms = {"flat/d"}};
  EXPECT_THAT(to_text(table), HasSubstr("caught     line_ties     3 cases  hits: lines/a, depth/c, lines/b\n"
                                        "NOT CAUGHT line_ties     1 cases  hits: lines/a\n"
                                        "FALSE ALARM: flat/d fails without any fault\n"
                                        "1 of 2 faults caught"));
  EXPECT_THAT(to_markdown(table), HasSubstr("| `line_ties` | w | s | 1 | `lines/a` | hits |\n"));
  const auto json = nlohmann::json::parse(to_json(table));
  EXPECT_EQ(json["faults"][0]["caught_by"], 3);
  EXPECT_EQ(json["faults"][0]["planes"][0], "hits");
  EXPECT_EQ(json["faults"][1]["caught"], false);
  EXPECT_EQ(json["faults"][1]["what"], "w");
  EXPECT_EQ(json["false_alarms"][0], "flat/d");
}

// The table of README.md, as ci/faults writes it.
struct ReadmeRow {
  std::string name;
  std::string what;
  std::vector<std::string> cases;
};

std::vector<std::string> in_backquotes(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, '`') && std::getline(stream, part, '`');) found.push_back(part);
  return found;
}

std::vector<ReadmeRow> readme_table() {
  std::vector<ReadmeRow> rows;
  std::ifstream file(FILLRULE_SOURCE_DIR "/harness/faults/README.md");
  bool in_table = false;
  for (std::string line; std::getline(file, line);) {
    in_table = in_table || line == "<!-- table -->";
    if (!in_table || !line.starts_with("| `")) continue;
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, '|');) cells.push_back(cell);
    rows.push_back({.name = in_backquotes(cells[1]).front(),
                    .what = cells[2].substr(1, cells[2].size() - 2),
                    .cases = in_backquotes(cells[5])});
  }
  return rows;
}

TEST(Readme, HasARowForEveryFault) {
  const std::vector<ReadmeRow> rows = readme_table();
  ASSERT_EQ(rows.size(), catalogue().size()) << "run ci/faults";
  for (size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].name, catalogue()[i].name) << "run ci/faults";
    EXPECT_EQ(rows[i].what, catalogue()[i].what) << "run ci/faults";
    EXPECT_EQ(rows[i].cases.size(), kLeastCases) << rows[i].name << " is not caught, or run ci/faults";
  }
}

TEST(Readme, EveryCaseInItStillCatchesItsFault) {
  for (const ReadmeRow& row : readme_table()) {
    const format::Suite suite = scene::load_suite(FILLRULE_SOURCE_DIR "/cases", row.cases);
    EXPECT_THAT(suite.errors, IsEmpty()) << row.name << ": run ci/faults";
    const Result<Fault> fault = fault_named(row.name);
    ASSERT_TRUE(fault) << "run ci/faults";
    const FaultEntry entry{.fault = *fault, .name = row.name};
    const FaultTable table = catch_faults(suite.cases, std::span(&entry, 1), 1, {});
    EXPECT_EQ(table.rows.front().cases.size(), row.cases.size()) << row.name << ": run ci/faults";
    EXPECT_THAT(table.false_alarms, IsEmpty());
  }
}

}  // namespace
}  // namespace fillrule::faults
