#include "harness/run/deviations.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "cases/model/temporary_folder.h"

namespace fillrule::run {
namespace {

CaseResult with_reference_fault(const std::string& name, const std::string& plane, uint64_t faults) {
  CaseResult result{.name = name};
  result.verdict.planes.push_back({.name = plane});
  result.verdict.planes[0].counts[static_cast<size_t>(judge::Verdict::kReferenceFault)] = faults;
  return result;
}

Deviation deviation(const std::string& pattern, const std::vector<std::string>& planes) {
  return {.cases = {pattern}, .planes = planes, .reason = "r", .source = "s"};
}

TEST(Deviations, AreFoundByDriverAndVersion) {
  EXPECT_EQ(deviations_file_name({.driver = "lavapipe", .version = "Mesa 22.3.6 (LLVM 15.0.6)"}),
            "lavapipe-22.3.6.toml");
  EXPECT_EQ(deviations_file_name({.driver = "swiftshader", .version = "5.0.0"}), "swiftshader-5.0.0.toml");
  EXPECT_EQ(deviations_file_name({.driver = "other", .version = ""}), "other-.toml");
}

TEST(Deviations, AFaultThatNoEntryCoversIsUnexpected) {
  const std::vector<CaseResult> cases{with_reference_fault("a/b[x=1]", "depth", 3),
                                      with_reference_fault("a/c", "depth", 2)};
  const DeviationReport report = compare_with_known(cases, {deviation("a/b*", {"depth"})});
  ASSERT_EQ(report.known.size(), 1U);
  EXPECT_EQ(report.known[0].case_name, "a/b[x=1]");
  EXPECT_EQ(report.known[0].samples, 3U);
  ASSERT_EQ(report.unexpected.size(), 1U);
  EXPECT_EQ(report.unexpected[0].case_name, "a/c");
  EXPECT_TRUE(report.gone.empty());
  EXPECT_EQ(compare_with_known(cases, {deviation("a/*", {"coverage"})}).unexpected.size(), 2U);
}

TEST(Deviations, AnEntryThatNoLongerOccursIsGoneIfItsCasesWereJudged) {
  const std::vector<Deviation> known{deviation("a/b*", {"depth"})};
  EXPECT_EQ(compare_with_known({with_reference_fault("a/b", "depth", 0)}, known).gone.size(), 1U);
  EXPECT_TRUE(compare_with_known({with_reference_fault("z/b", "depth", 0)}, known).gone.empty());
  CaseResult skipped{.name = "a/b", .status = Status::kSkipped};
  EXPECT_TRUE(compare_with_known({skipped}, known).gone.empty());
}

TEST(Deviations, AnEntryOfTwoPlanesIsGoneWhenOneOfThemIs) {
  CaseResult result = with_reference_fault("a/b", "depth", 1);
  result.verdict.planes.push_back({.name = "owner"});
  EXPECT_EQ(compare_with_known({result}, {deviation("a/b", {"depth", "owner"})}).gone.size(), 1U);
}

class DeviationsFile : public testing::Test {
 protected:
  std::string error_of(const std::string& text) {
    std::ofstream(path_) << text;
    const auto read = read_deviations(path_);
    return read ? "" : to_string(read.error()).substr(path_.size());
  }
  const TemporaryFolder folder_;
  const std::string path_ = folder_.path("deviations.toml");
};

TEST_F(DeviationsFile, IsReadWhole) {
  std::ofstream(path_) << "[[deviation]]\ncases = ['a/*']\nplanes = ['depth', 'uv']\nreason = 'r'\nsource = 's'\n";
  const auto read = read_deviations(path_);
  ASSERT_TRUE(read) << to_string(read.error());
  ASSERT_EQ(read->size(), 1U);
  EXPECT_EQ((*read)[0].cases.front(), "a/*");
  EXPECT_EQ((*read)[0].planes, (std::vector<std::string>{"depth", "uv"}));
}

TEST_F(DeviationsFile, ErrorsNameThePlace) {
  EXPECT_EQ(error_of("[[deviation]]\ncases = ['a']\nplanes = ['p']\nsource = 's'\n"),
            ":1:1: a deviation needs the text \"reason\"\n  hint: each has cases, planes, reason and source");
  EXPECT_EQ(error_of("[[deviation]]\ncases = ['a']\nreason = 'r'\nsource = 's'\n"),
            ":1:1: a deviation needs the list of its planes\n  hint: write planes = [\"depth\"]");
  EXPECT_EQ(error_of("[[deviaton]]\n").substr(0, 28), ":1:3: unknown key \"deviaton\"");
  EXPECT_FALSE(read_deviations("/nonexistent.toml"));
}

// The lists of this repository are well-formed.
TEST(Deviations, TheListsOfTheRepositoryAreRead) {
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FILLRULE_SOURCE_DIR "/ci/expected")) {
    const auto read = read_deviations(entry.path().string());
    EXPECT_TRUE(read) << to_string(read.error());
    ++files;
  }
  EXPECT_GE(files, 2U);
}

}  // namespace
}  // namespace fillrule::run
