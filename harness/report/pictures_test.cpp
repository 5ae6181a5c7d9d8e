#include "harness/report/pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "cases/model/temporary_folder.h"
#include "harness/images/images.h"
#include "harness/report/picture.h"

namespace fillrule::report {
namespace {

class PicturesTest : public testing::Test {
 protected:
  const TemporaryFolder temporary_;
  const std::string folder_ = temporary_.path("made/on/demand");
  Case case_{.name = "a/b[x=1]", .target = {.width = 4, .height = 2}, .varyings = {{.name = "uv", .components = 2}}};
};

run::Drawing drawing(const Case& test_case) {
  run::Drawing result;
  result.candidate = Planes::cleared(4, 2, 1, 2, 1.0F);
  result.candidate.hits[1] = 1;
  result.candidate.owner[1] = 0;
  result.candidate.depth[1] = 0.123456789F;
  result.candidate.varyings[0][1] = std::numeric_limits<float>::quiet_NaN();
  result.reference = result.candidate;
  result.verdict.samples = 8;
  judge::PlaneVerdict plane{.name = "coverage"};
  plane.map.assign(8, judge::Verdict::kIdentical);
  plane.map[6] = judge::Verdict::kCandidateFault;
  result.verdict.planes.push_back(plane);
  EXPECT_EQ(test_case.target.width, 4U);
  return result;
}

TEST(PictureOf, APixelIsTheMeanOfItsSamples) {
  const Case one{.target = {.width = 1, .height = 1, .samples = VK_SAMPLE_COUNT_2_BIT}, .varyings = {{.name = "v"}}};
  Planes planes = Planes::cleared(1, 1, 2, 1, 1.0F);
  planes.hits = {1, 0};
  planes.varyings[0] = {1.0F, 0.0F};
  const uint8_t background = picture_of(one, Planes::cleared(1, 1, 2, 1, 1.0F), {}).at(0, 0)[0];
  EXPECT_EQ(picture_of(one, planes, {}).at(0, 0)[0], (255 + background) / 2);
}

TEST_F(PicturesTest, OnePngSideBySideAndOneExrForEachParty) {
  const auto paths = write_pictures(folder_, case_, drawing(case_));
  ASSERT_TRUE(paths) << to_string(paths.error());
  ASSERT_EQ(paths->size(), 3U);
  for (const std::string& path : *paths) EXPECT_TRUE(std::filesystem::exists(path)) << path;

  const Result<images::Image> png = images::read(paths->front());
  ASSERT_TRUE(png);
  const uint32_t scale = 384 / 4;
  EXPECT_EQ(png->layout.channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(png->layout.width, 3 * 4 * scale + 4 * 4);
  EXPECT_EQ(png->layout.height, 2 * scale + 2 * 4);
  const auto pixel = [&](size_t panel, size_t x, size_t y) {
    const size_t column = 4 + panel * (4 * scale + 4) + x * scale + scale / 2;
    const float* const rgb = &png->values[((4 + y * scale + scale / 2) * png->layout.width + column) * 3];
    const auto byte = [rgb](size_t channel) { return static_cast<uint8_t>(std::lround(rgb[channel] * 255)); };
    return std::array{byte(0), byte(1), byte(2)};
  };
  EXPECT_EQ(pixel(0, 1, 0), (std::array<uint8_t, 3>{255, 0, 255}));  // NaN has a colour of its own
  EXPECT_EQ(pixel(1, 0, 0), pixel(0, 0, 0));
  EXPECT_EQ(pixel(2, 2, 1), (std::array<uint8_t, 3>{230, 97, 0}));  // the candidate's fault
  EXPECT_NE(pixel(2, 1, 1), pixel(2, 2, 1));
}

TEST_F(PicturesTest, TheExrHoldsEveryPlaneUnquantised) {
  const auto paths = write_pictures(folder_, case_, drawing(case_));
  ASSERT_TRUE(paths);
  const Result<images::Image> exr = images::read((*paths)[1]);
  ASSERT_TRUE(exr);
  const std::vector<std::string>& names = exr->layout.channels;
  const auto value = [&](const std::string& channel, size_t pixel) {
    const auto found = std::find(names.begin(), names.end(), channel);
    EXPECT_NE(found, names.end()) << channel;
    return exr->values[pixel * names.size() + static_cast<size_t>(found - names.begin())];
  };
  EXPECT_EQ(value("depth", 1), 0.123456789F);
  EXPECT_EQ(value("coverage", 1), 1.0F);
  EXPECT_EQ(value("owner", 0), -1.0F);
  EXPECT_TRUE(std::isnan(value("uv.x", 1)));
}

TEST_F(PicturesTest, AFolderThatCannotBeMadeIsAnError) {
  const auto paths = write_pictures("/proc/nowhere", case_, drawing(case_));
  ASSERT_FALSE(paths);
  EXPECT_EQ(paths.error().file, "/proc/nowhere");
}

TEST(FileStem, KeepsPlainNamesAndTellsOthersApart) {
  EXPECT_EQ(file_stem("tie"), "tie");
  EXPECT_NE(file_stem("a/b"), file_stem("a_b"));
  EXPECT_EQ(file_stem("../../etc/passwd").find('/'), std::string::npos);
  EXPECT_LT(file_stem(std::string(5000, 'x')).size(), 200U);
}

}  // namespace
}  // namespace fillrule::report
