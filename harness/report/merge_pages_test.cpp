#include "harness/report/merge_pages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "cases/model/temporary_folder.h"
#include "harness/report/html_report.h"

namespace fillrule::report {
namespace {

run::RunResult failures(const std::vector<std::string>& names) {
  run::RunResult result{.candidate = "renderer"};
  for (const std::string& name : names) {
    result.cases.push_back({.name = name, .status = run::Status::kFailed});
  }
  result.summary = run::summarise(result.cases, 1);
  return result;
}

// A page of these cases, all of them shown.
std::string page_of(const std::vector<std::string>& names, const std::optional<std::string>& faults) {
  HtmlReport html;
  for (size_t i = 0; i < names.size(); ++i) {
    HtmlCase one;
    one.diagnosis.sentence = "What is wrong with " + names[i] + ".";
    one.json = "[\"planes of " + names[i] + "\"]";
    html.add(i, std::move(one));
  }
  return html.page(failures(names), {}, faults);
}

class MergePages : public testing::Test {
 protected:
  std::string shard(const std::string& name, const std::string& page) {
    std::string folder = folder_.path(name);
    std::filesystem::create_directories(folder);
    std::ofstream(folder + "/report.html", std::ios::binary) << page;
    return folder;
  }
  std::string merged() {
    std::ifstream file(folder_.path("report.html"), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  const TemporaryFolder folder_;
};

TEST_F(MergePages, GivesThePageOfTheWholeRun) {
  const std::string faults = R"({"faults":[{"name":"f","what":"w","caught_by":3,"cases":[],"planes":[]}]})";
  const std::vector<std::string> shards{shard("1", page_of({"a", "c"}, std::nullopt)),
                                        shard("2", page_of({"b<"}, faults))};
  const auto written = merge_pages(shards, folder_.path(""), failures({"a", "b<", "c"}), {});
  ASSERT_TRUE(written) << to_string(written.error());
  EXPECT_EQ(merged(), page_of({"a", "b<", "c"}, faults));
}

TEST_F(MergePages, RefusesWhatIsNoPage) {
  const auto error_of = [&](const std::vector<std::string>& shards) {
    const auto written = merge_pages(shards, folder_.path(""), failures({"a"}), {});
    return written ? "" : written.error().what;
  };
  EXPECT_EQ(error_of({folder_.path("absent")}), "cannot be read");
  EXPECT_EQ(error_of({shard("3", "<html>")}), "is not a report of this version of fillrule");
}

}  // namespace
}  // namespace fillrule::report
