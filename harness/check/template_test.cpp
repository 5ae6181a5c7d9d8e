#include "harness/check/template.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "cases/format/reader.h"
#include "cases/model/temporary_folder.h"
#include "harness/check/check.h"

namespace fillrule::check {
namespace {

std::string content(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(Template, IsACaseOfWhichOnlyTheHeadIsMissing) {
  const format::CaseFile file = format::parse(template_text("topic/name"), "a.toml", "topic/name");
  for (const Error& error : file.errors) ADD_FAILURE() << to_string(error);
  ASSERT_EQ(file.cases.size(), 3U);
  std::string text;
  for (const Error& finding : check_files(file.cases, {})) text += finding.what + '\n';
  EXPECT_EQ(text, "title is still the template's\nwhy is still the template's\norigin is still the template's\n");
}

TEST(WriteTemplate, MakesFoldersAndNeverOverwrites) {
  const TemporaryFolder folder;
  const Result<std::string> file = write_template(folder.path("cases"), "topic/part/a_name_2");
  ASSERT_TRUE(file) << to_string(file.error());
  EXPECT_EQ(*file, folder.path("cases/topic/part/a_name_2.toml"));
  EXPECT_EQ(content(*file), template_text("topic/part/a_name_2"));
  std::ofstream(*file, std::ios::binary) << "mine";
  const Result<std::string> again = write_template(folder.path("cases"), "topic/part/a_name_2");
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().what, "is there already");
  EXPECT_EQ(content(*file), "mine");
}

TEST(WriteTemplate, BadNames) {
  const TemporaryFolder folder;
  for (const char* const name : {"", "name", "Topic/name", "topic/", "/name", "topic//name", "topic/na-me",
                                 "../up/name", "topic/name.toml", "topic/with space"}) {
    const Result<std::string> file = write_template(folder.path("cases"), name);
    ASSERT_FALSE(file) << name;
    EXPECT_EQ(file.error().what, '"' + std::string(name) + "\" is no name for a case");
    EXPECT_FALSE(file.error().hint.empty());
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path("cases")));
}

TEST(WriteTemplate, UnwritableFolder) {
  const TemporaryFolder folder;
  std::ofstream(folder.path("cases")) << "a file";
  const Result<std::string> file = write_template(folder.path("cases"), "topic/name");
  ASSERT_FALSE(file);
  EXPECT_TRUE(file.error().what.starts_with("its folder cannot be made: ")) << file.error().what;
}

}  // namespace
}  // namespace fillrule::check
