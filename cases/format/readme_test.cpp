// The examples of cases/README.md, and the suite itself, are read without an error.
#include <gmock/gmock.h>

#include <fstream>

#include "cases/format/suite.h"
#include "cases/format/test_files.h"
#include "cases/format/writer.h"

namespace fillrule::format {
namespace {

const std::string kCasesFolder = std::string(FILLRULE_SOURCE_DIR) + "/cases";

// The fenced blocks of a language.
std::vector<std::string> blocks_of(const std::string& path, const std::string& language) {
  std::ifstream stream(path);
  std::vector<std::string> blocks;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (!inside && line == "```" + language) {
      blocks.emplace_back();
      inside = true;
    } else if (inside && line == "```") {
      inside = false;
    } else if (inside) {
      blocks.back() += line + '\n';
    }
  }
  return blocks;
}

TEST(Readme, ExamplesAreCases) {
  const std::vector<std::string> blocks = blocks_of(kCasesFolder + "/README.md", "toml");
  ASSERT_EQ(blocks.size(), 3U);
  const std::vector<size_t> expected_cases{1, 12, 1};
  for (size_t i = 0; i < blocks.size(); ++i) {
    const CaseFile file = parse(blocks[i], "README.md", "example");
    for (const Error& error : file.errors) ADD_FAILURE() << to_string(error);
    EXPECT_EQ(file.cases.size(), expected_cases[i]);
  }
}

TEST(Readme, TheFullExampleIsWhatItSays) {
  const std::vector<std::string> blocks = blocks_of(kCasesFolder + "/README.md", "toml");
  ASSERT_EQ(blocks.size(), 3U);
  const CaseFile file = parse(blocks[1], "README.md", "example");
  ASSERT_EQ(file.cases.size(), 12U);
  const Case& last = file.cases.back();
  EXPECT_EQ(last.name, "example[angle=pi/4,height=64,cull=back]");
  EXPECT_EQ(last.control, "example[angle=0,height=64,cull=back]");
  EXPECT_EQ(last.target.height, 64U);
  ASSERT_EQ(last.draws.size(), 2U);
  EXPECT_EQ(last.draws[0].positions.size(), 18U);
  EXPECT_EQ(last.draws[0].varyings.size(), 18U * 4U);
  EXPECT_EQ(last.varyings.at(1).source, VaryingSource::kFragCoord);
  EXPECT_EQ(last.draws[0].state.sample_mask, 0b1101U);
  EXPECT_EQ(last.draws[0].state.cull_mode, VkCullModeFlags{VK_CULL_MODE_BACK_BIT});
  EXPECT_EQ(last.draws[1].state.depth_compare, VK_COMPARE_OP_ALWAYS);
  EXPECT_EQ(primitive_count(last.draws[1]), 2U);
  EXPECT_EQ(last.draws[1].positions.at(2), (ClipPosition{0, 0.5F, 0.5F, 1}));
}

TEST(CaseSuite, IsReadWithoutErrors) {
  const Suite suite = load_suite(kCasesFolder, {});
  for (const Error& error : suite.errors) ADD_FAILURE() << to_string(error);
  EXPECT_FALSE(suite.cases.empty());
}

TEST(CaseSuite, EveryCaseIsWrittenAndReadBack) {
  for (const Case& one : load_suite(kCasesFolder, {}).cases) {
    if (one.scene) continue;  // has no draws before harness/scene makes them, and is tested there
    const std::string written = write(one);
    const CaseFile file = parse(written, one.file, one.name);
    for (const Error& error : file.errors) ADD_FAILURE() << one.name << ": " << to_string(error);
    ASSERT_EQ(file.cases.size(), 1U) << one.name;
    EXPECT_EQ(write(file.cases[0]), written) << one.name;
  }
}

}  // namespace
}  // namespace fillrule::format
