#include "harness/report/html_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/report/html_summary.h"

namespace fillrule::report {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kHostile = "</script><script>alert(1)</script>\"'\xff";

run::RunResult two_failures() {
  run::RunResult result{.candidate = "<i>renderer</i>", .cases = {{.name = kHostile}, {.name = "b"}}};
  for (run::CaseResult& one : result.cases) one.status = run::Status::kFailed;
  result.summary = run::summarise(result.cases, 1);
  return result;
}

HtmlCase encoded(size_t size) {
  HtmlCase one;
  one.diagnosis.sentence = "It is <wrong>.";
  one.json = std::string(size, 'x');
  return one;
}

// The JSON of a script element.
nlohmann::json data_of(const std::string& page, const std::string& id) {
  const std::string start = "id=\"" + id + "\">";
  const size_t begin = page.find(start) + start.size();
  return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(HtmlReport, ListsEveryCaseAndNoNameEndsAScript) {
  HtmlReport report;
  EXPECT_TRUE(report.add(0, encoded(10)));
  const std::string page = report.page(two_failures(), {}, std::nullopt);
  const nlohmann::json run = data_of(page, "run");
  ASSERT_EQ(run["cases"].size(), 2U);
  EXPECT_EQ(run["cases"][0][0], "</script><script>alert(1)</script>\"'\xef\xbf\xbd");
  EXPECT_EQ(run["columns"][8], "why");
  EXPECT_EQ(run["cases"][0][8], "It is <wrong>.");
  EXPECT_THAT(page, Not(HasSubstr("alert(1)</script>")));
  EXPECT_THAT(page, HasSubstr("id=\"case-0\">xxxxxxxxxx</script>"));
}

TEST(HtmlReport, TheSummaryNeedsNoScript) {
  HtmlReport report;
  report.add(1, encoded(10));
  const std::string page = report.page(two_failures(), {}, std::nullopt);
  const std::string text = page.substr(page.find("id=\"static\""), page.find("</main>") - page.find("id=\"static\""));
  EXPECT_THAT(text, HasSubstr("<tr><th>failed</th><td>2</td></tr>"));
  EXPECT_THAT(text, HasSubstr("&lt;i&gt;renderer"));
  EXPECT_THAT(text, HasSubstr("<td>b</td><td>It is &lt;wrong&gt;.</td>"));
  EXPECT_THAT(text, HasSubstr("&lt;/script&gt;"));
}

TEST(HtmlReport, BeyondTheLimitThereAreStatisticsOnly) {
  HtmlReport report(20'000);
  EXPECT_TRUE(report.add(0, encoded(15'000)));
  EXPECT_FALSE(report.has_room());
  EXPECT_FALSE(report.add(1, encoded(15'000)));
  const std::string page = report.page(two_failures(), {}, std::nullopt);
  EXPECT_EQ(data_of(page, "run")["without_planes"], nlohmann::json({1}));
  EXPECT_EQ(data_of(page, "run")["cases"][1][8], "It is <wrong>.");
  EXPECT_THAT(page, Not(HasSubstr("id=\"case-1\"")));
}

TEST(HtmlReport, HoldsTheTableOfFaults) {
  const std::string table = R"({"faults": [{"name": "no_clip", "caught_by": 3}]})";
  const HtmlReport report;
  EXPECT_EQ(data_of(report.page(two_failures(), {}, table), "run")["faults"][0]["name"], "no_clip");
  EXPECT_FALSE(data_of(report.page(two_failures(), {}, "{broken"), "run").contains("faults"));
}

TEST(HtmlReport, AsksForNothingFromOutside) {
  const std::string page = HtmlReport().page(two_failures(), {}, std::nullopt);
  for (const char* const mark : {"http:", "https:", "src=", "url(", "@import", "<!-- style -->", "<!-- script -->"}) {
    EXPECT_THAT(page, Not(HasSubstr(mark)));
  }
}

}  // namespace
}  // namespace fillrule::report
