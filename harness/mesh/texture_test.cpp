#include "harness/mesh/texture.h"

#include <gmock/gmock.h>

#include <fstream>
#include <random>

#include "cases/model/temporary_folder.h"

namespace fillrule::mesh {
namespace {

using ::testing::FloatEq;
using ::testing::HasSubstr;

const std::string kMeshes = FILLRULE_SOURCE_DIR "/cases/meshes/";

Texture texture_of(const std::string& path, Mipmaps mipmaps) {
  const Result<Texture> texture = read_texture(path, {.mipmaps = mipmaps});
  if (!texture) ADD_FAILURE() << to_string(texture.error());
  return texture ? *texture : Texture{};
}

TEST(ReadTexture, BeginsAtTheTopLeft) {
  const Texture texture = texture_of(kMeshes + "checker.png", Mipmaps::kNone);
  ASSERT_EQ(texture.levels.size(), 1U);
  EXPECT_EQ(texture.levels[0].width, 16U);
  EXPECT_THAT(texture.levels[0].texels[0],
              ::testing::ElementsAre(FloatEq(224.0F / 255), FloatEq(64.0F / 255), FloatEq(48.0F / 255), 1.0F));
  EXPECT_FLOAT_EQ(texture.levels[0].texels[4][0], 40.0F / 255);
}

TEST(ReadTexture, IsTheSameAsBmpAndPng) {
  const Texture bmp = texture_of(kMeshes + "grid.bmp", Mipmaps::kNone);
  const Texture png = texture_of(kMeshes + "grid.png", Mipmaps::kNone);
  ASSERT_EQ(bmp.levels.size(), 1U);
  EXPECT_EQ(bmp.levels[0].texels, png.levels[0].texels);
}

TEST(ReadTexture, HalvesDownToOneTexel) {
  const Texture texture = texture_of(kMeshes + "odd.png", Mipmaps::kLinear);
  std::vector<std::pair<uint32_t, uint32_t>> sizes;
  for (const TextureLevel& level : texture.levels) sizes.emplace_back(level.width, level.height);
  EXPECT_THAT(sizes,
              ::testing::ElementsAre(std::pair(13U, 7U), std::pair(6U, 3U), std::pair(3U, 1U), std::pair(1U, 1U)));
  const TextureLevel half = half_of({.width = 2, .height = 1, .texels = {{0, 1, 0, 1}, {1, 0, 0.5F, 0}}});
  EXPECT_EQ(half.texels, (std::vector<Texel>{{0.5F, 0.5F, 0.25F, 0.5F}}));
}

TEST(ReadTexture, TellsWhatIsWrong) {
  const TemporaryFolder folder;
  EXPECT_THAT(to_string(read_texture(folder.path("no.png"), {}).error()), HasSubstr("no.png: cannot be read"));
  std::ofstream(folder.path("text.png")) << "no image";
  EXPECT_THAT(to_string(read_texture(folder.path("text.png"), {}).error()), HasSubstr("cannot be read as an image"));
}

// Broken headers and broken data: an error or a texture of the size it says.
TEST(ReadTexture, SurvivesBrokenFiles) {
  const TemporaryFolder folder;
  for (const std::string name : {"odd.png", "grid.bmp"}) {
    std::ifstream stream(kMeshes + name, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    std::mt19937 random(11);
    for (int round = 0; round < 200; ++round) {
      std::string bytes = whole;
      for (int i = 0; i < 3; ++i) bytes[random() % std::min<size_t>(bytes.size(), 120)] = static_cast<char>(random());
      if (round % 4 == 0) bytes.resize(random() % bytes.size());
      const std::string path = folder.path(name);
      std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
      const Result<Texture> texture = read_texture(path, {});
      if (!texture) {
        EXPECT_FALSE(texture.error().what.empty());
        continue;
      }
      const TextureLevel& level = texture->levels[0];
      EXPECT_EQ(level.texels.size(), size_t{level.width} * level.height);
    }
  }
}

}  // namespace
}  // namespace fillrule::mesh
