#include "harness/images/images.h"

#include <dlfcn.h>
#include <gmock/gmock.h>

#include <fstream>
#include <thread>

#include "cases/model/temporary_folder.h"

namespace fillrule::images {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatNear;
using ::testing::HasSubstr;

// How far a value is from what 8 bits can hold, and a float's rounding of it.
constexpr float kHalfByte = 0.5001F / 255;

TEST(Images, FloatsAreWrittenAndReadBack) {
  const TemporaryFolder folder;
  const std::vector<float> rgb{0, 0.5F, 1, 0.25F, 0.125F, 1.0F / 255};
  for (const char* const name : {"a.png", "a.exr"}) {
    ASSERT_TRUE(write(folder.path(name), rgb_layout(2, 1), rgb));
    const Result<Image> image = read(folder.path(name));
    ASSERT_TRUE(image) << to_string(image.error());
    EXPECT_EQ(image->layout.width, 2U);
    EXPECT_EQ(image->layout.height, 1U);
    EXPECT_THAT(image->layout.channels, ElementsAre("R", "G", "B"));
    EXPECT_THAT(image->values, testing::Pointwise(FloatNear(name[2] == 'e' ? 0 : kHalfByte), rgb)) << name;
  }
}

// Says something where no test before has loaded it, as where each runs in a process of its own.
TEST(Images, LibraryIsLoadedAheadWithoutAnImage) {
  load_ahead().join();
  void* const library = dlopen("libfillrule_image_files.so", RTLD_LAZY | RTLD_NOLOAD);
  ASSERT_NE(library, nullptr);
  dlclose(library);
}

TEST(Images, AreReadAndWrittenWhileTheLibraryIsLoadedAhead) {
  const std::jthread one = load_ahead();
  const std::jthread another = load_ahead();
  const TemporaryFolder folder;
  ASSERT_TRUE(write(folder.path("a.png"), rgb_layout(1, 1), std::vector<float>{0, 1, 0}));
  const Result<Image> image = read(folder.path("a.png"));
  ASSERT_TRUE(image) << to_string(image.error());
  EXPECT_THAT(image->values, ElementsAre(0, 1, 0));
}

TEST(Images, BytesAreWrittenAndReadBack) {
  const TemporaryFolder folder;
  const std::vector<uint8_t> rgb{0, 1, 127, 128, 254, 255};
  ASSERT_TRUE(write(folder.path("a.png"), rgb_layout(1, 2), rgb));
  const Result<Image> image = read(folder.path("a.png"));
  ASSERT_TRUE(image) << to_string(image.error());
  for (size_t i = 0; i < rgb.size(); ++i) EXPECT_FLOAT_EQ(image->values[i] * 255, rgb[i]);
}

TEST(Images, TheFirstChannelsAreReadAlone) {
  const TemporaryFolder folder;
  const std::vector<float> values{1, 2, 3, 4, 5, 6};
  ASSERT_TRUE(write(folder.path("a.exr"), rgb_layout(2, 1), values));
  const Result<Image> image = read(folder.path("a.exr"), 2);
  ASSERT_TRUE(image) << to_string(image.error());
  EXPECT_THAT(image->layout.channels, ElementsAre("R", "G"));
  EXPECT_THAT(image->values, ElementsAre(1, 2, 4, 5));
}

TEST(Images, TellsWhatIsWrong) {
  const TemporaryFolder folder;
  EXPECT_THAT(to_string(read(folder.path("no.png")).error()), HasSubstr("no.png: cannot be read as an image"));
  std::ofstream(folder.path("text.png")) << "no image";
  EXPECT_THAT(to_string(read(folder.path("text.png")).error()), HasSubstr("cannot be read as an image"));
  const std::vector<float> rgb{0, 0, 0};
  EXPECT_THAT(to_string(write(folder.path("no/a.png"), rgb_layout(1, 1), rgb).error()),
              HasSubstr("a.png: cannot be written as an image"));
}

// The library is loaded by whoever comes first.
TEST(Images, AreReadByThreadsAtOnce) {
  const std::string path = FILLRULE_SOURCE_DIR "/cases/meshes/odd.png";
  std::vector<size_t> sizes(4);
  std::vector<std::thread> threads;
  threads.reserve(sizes.size());
  for (size_t& size : sizes) {
    threads.emplace_back([&size, &path] {
      if (const Result<Image> image = read(path); image) size = image->values.size();
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(sizes, testing::Each(13U * 7U * 3U));
}

}  // namespace
}  // namespace fillrule::images
