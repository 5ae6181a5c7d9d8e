#include "cases/format/suite.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "cases/format/test_files.h"
#include "cases/model/temporary_folder.h"

namespace fillrule::format {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A suite in a temporary folder, and a folder outside of it.
class SuiteTest : public ::testing::Test {
 protected:
  void SetUp() override {
    write("suite/coverage/tie.toml", "sweep.a = [1, 2]\n" + kDraw);
    write("suite/coverage/shared_diagonal.toml", kDraw);
    write("suite/clipping/near_plane.toml", "sweep.angle = [0, 30]\n" + kDraw);
    write("suite/clipping/deep/far.toml", kDraw);
    write("suite/README.md", "no case");
    write("suite/.hidden/x.toml", "no case");
    write("outside/one.toml", kDraw);
    write("outside/sub/two.toml", kDraw);
  }

  void write(const std::string& path, const std::string& body) const {
    fs::create_directories((top_ / path).parent_path());
    std::ofstream(top_ / path) << kHead << body;
  }

  [[nodiscard]] std::string at(const std::string& path) const { return (top_ / path).generic_string(); }

  std::vector<std::string> names(const std::vector<std::string>& selectors) {
    suite_ = load_suite(at("suite"), selectors);
    std::vector<std::string> names;
    for (const Case& one : suite_.cases) names.push_back(one.name);
    return names;
  }

  // Of the last names(); without the temporary folder's path.
  [[nodiscard]] std::string errors() const {
    std::string text;
    for (const Error& error : suite_.errors) text += to_string(error) + '\n';
    const std::string folder = top_.generic_string() + '/';
    for (size_t i = text.find(folder); i != std::string::npos; i = text.find(folder)) text.erase(i, folder.size());
    return text;
  }

  const TemporaryFolder folder_;
  const fs::path top_ = folder_.path();
  Suite suite_;
};

TEST_F(SuiteTest, EverythingBelowTheRootByName) {
  EXPECT_THAT(names({}),
              ElementsAre("clipping/deep/far", "clipping/near_plane[angle=0]", "clipping/near_plane[angle=30]",
                          "coverage/shared_diagonal", "coverage/tie[a=1]", "coverage/tie[a=2]"));
  EXPECT_EQ(errors(), "");
  EXPECT_EQ(suite_.cases[0].file, at("suite/clipping/deep/far.toml"));
}

TEST_F(SuiteTest, ANameWithOrWithoutItsSweep) {
  EXPECT_THAT(names({"coverage/shared_diagonal"}), ElementsAre("coverage/shared_diagonal"));
  EXPECT_THAT(names({"coverage/tie"}), ElementsAre("coverage/tie[a=1]", "coverage/tie[a=2]"));
  EXPECT_THAT(names({"clipping/near_plane[angle=30]"}), ElementsAre("clipping/near_plane[angle=30]"));
  EXPECT_EQ(errors(), "");
}

TEST_F(SuiteTest, Globs) {
  EXPECT_THAT(names({"clipping/*"}),
              ElementsAre("clipping/deep/far", "clipping/near_plane[angle=0]", "clipping/near_plane[angle=30]"));
  EXPECT_THAT(names({"*=30]", "*[a=?]"}),
              ElementsAre("clipping/near_plane[angle=30]", "coverage/tie[a=1]", "coverage/tie[a=2]"));
  EXPECT_EQ(errors(), "");
}

TEST_F(SuiteTest, OnlyFilesThatCanMatchAreRead) {
  write("suite/coverage/bad.toml", "x = 1\n");
  EXPECT_THAT(names({"clipping/*"}), ::testing::SizeIs(3));
  EXPECT_EQ(errors(), "");
}

TEST_F(SuiteTest, ShowsEachFilesTextThatCanBeRead) {
  fs::create_symlink(top_ / "nothing", top_ / "suite/clipping/a_link.toml");
  write("suite/clipping/bad.toml", "sweep = 3\n");
  std::vector<std::string> shown;
  const std::vector<std::string> selectors{"clipping/a_link", "clipping/bad", "coverage/tie"};
  suite_ = load_suite(at("suite"), selectors, [&shown](std::string_view text) { shown.emplace_back(text); });
  EXPECT_THAT(shown, ElementsAre(kHead + "sweep = 3\n", kHead + "sweep.a = [1, 2]\n" + kDraw));
  EXPECT_THAT(errors(), HasSubstr("suite/clipping/a_link.toml: cannot be read: No such file"));
}

TEST_F(SuiteTest, FilesAndFolders) {
  EXPECT_THAT(names({at("suite/coverage/tie.toml")}), ElementsAre("coverage/tie[a=1]", "coverage/tie[a=2]"));
  EXPECT_THAT(names({at("suite/clipping/deep")}), ElementsAre("clipping/deep/far"));
  EXPECT_THAT(names({at("outside")}), ElementsAre("one", "sub/two"));
  EXPECT_THAT(names({at("outside/")}), ElementsAre("one", "sub/two"));
  EXPECT_THAT(names({at("suite/clipping/deep/")}), ElementsAre("clipping/deep/far"));
  EXPECT_THAT(names({at("outside/sub/two.toml")}), ElementsAre("two"));
  EXPECT_EQ(errors(), "");
}

TEST_F(SuiteTest, FilesAndFoldersAreLookedUpFromTheRootToo) {
  EXPECT_THAT(names({"clipping"}),
              ElementsAre("clipping/deep/far", "clipping/near_plane[angle=0]", "clipping/near_plane[angle=30]"));
  EXPECT_THAT(names({"coverage/tie.toml"}), ElementsAre("coverage/tie[a=1]", "coverage/tie[a=2]"));
  EXPECT_EQ(errors(), "");
}

TEST_F(SuiteTest, AFileOfAnyEndingIsReadIfItIsNamed) {
  write("outside/case.txt", kDraw);
  EXPECT_THAT(names({at("outside/case.txt")}), ElementsAre("case"));
  EXPECT_EQ(errors(), "");
}

TEST_F(SuiteTest, OverlappingSelectorsGiveEachCaseOnce) {
  EXPECT_THAT(names({"coverage/tie[a=2]", "coverage/*", at("suite/coverage"), at("suite/clipping/../coverage")}),
              ElementsAre("coverage/tie[a=1]", "coverage/tie[a=2]", "coverage/shared_diagonal"));
  EXPECT_EQ(errors(), "");
}

TEST_F(SuiteTest, ASelectorThatFindsNothing) {
  EXPECT_THAT(names({"coverage/shared_diagnal", "coverage/tie"}), ::testing::SizeIs(2));
  EXPECT_EQ(errors(),
            "no case, file or folder is named \"coverage/shared_diagnal\"\n"
            "  hint: did you mean \"coverage/shared_diagonal\"?\n");
  EXPECT_THAT(names({"tie"}), IsEmpty());
  EXPECT_EQ(errors(), "no case, file or folder is named \"tie\"\n  hint: did you mean \"coverage/tie\"?\n");
  EXPECT_THAT(names({"clipping/near_plane[angle=31]"}), IsEmpty());
  EXPECT_EQ(errors(),
            "no case, file or folder is named \"clipping/near_plane[angle=31]\"\n"
            "  hint: did you mean \"clipping/near_plane[angle=30]\"?\n");
  EXPECT_THAT(names({"zebra*"}), IsEmpty());
  EXPECT_EQ(errors(),
            "no case, file or folder is named \"zebra*\"\n"
            "  hint: a case is named by its path below the suite's folder, for example "
            "\"coverage/shared_diagonal\"; * matches any text\n");
}

TEST_F(SuiteTest, TheOtherFilesOfABadOneStillCount) {
  write("suite/coverage/bad.toml", "x = 1\n" + kDraw);
  EXPECT_THAT(names({"coverage/*"}),
              ElementsAre("coverage/shared_diagonal", "coverage/tie[a=1]", "coverage/tie[a=2]"));
  EXPECT_EQ(errors(),
            "suite/coverage/bad.toml:4:1: unknown key \"x\" in the case file\n"
            "  hint: known keys: title, why, spec, origin, tags, control, expect, opt_out, target, state, varyings, "
            "let, sweep, draw, scene\n");
  EXPECT_THAT(names({"coverage/bad[x=1]"}), IsEmpty());
  EXPECT_EQ(suite_.errors.size(), 1U);
}

TEST_F(SuiteTest, TwoCasesOfOneName) {
  write("suite/coverage/tie[a=2].toml", kDraw);
  EXPECT_THAT(names({"coverage/tie*"}), ElementsAre("coverage/tie[a=1]", "coverage/tie[a=2]"));
  EXPECT_EQ(errors(),
            "suite/coverage/tie[a=2].toml: a second case is named \"coverage/tie[a=2]\"\n"
            "  hint: the first is in suite/coverage/tie.toml\n");
  write("elsewhere/one.toml", kDraw);
  EXPECT_THAT(names({at("outside/one.toml"), at("elsewhere")}), ElementsAre("one"));
  EXPECT_EQ(errors(),
            "elsewhere/one.toml: a second case is named \"one\"\n  hint: the first is in outside/one.toml\n");
}

TEST_F(SuiteTest, AFolderWithoutCases) {
  fs::create_directories(top_ / "empty");
  EXPECT_THAT(names({at("empty")}), IsEmpty());
  EXPECT_EQ(errors(), "empty: no case files in this folder\n  hint: case files end in .toml\n");
}

TEST_F(SuiteTest, ARootThatIsMissing) {
  fs::remove_all(top_ / "suite");
  EXPECT_THAT(names({}), IsEmpty());
  EXPECT_EQ(errors(), "suite: cannot be read: No such file or directory\n");
}

}  // namespace
}  // namespace fillrule::format
