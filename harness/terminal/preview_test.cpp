#include "harness/terminal/preview.h"

#include <gtest/gtest.h>

#include "harness/terminal/golden.h"
#include "harness/terminal/scene.h"

namespace fillrule::terminal {
namespace {

Scene spoiled(uint32_t size) {
  return draw_scene(size, [](Planes& candidate, Planes&) { lose(candidate, 1, 1); });
}

size_t count(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Preview, BlocksAreTwoPixelsACharacter) {
  const Scene scene = spoiled(8);
  const std::string text = preview_text(scene.test_case, scene.drawing, {.preview = Preview::kBlocks});
  expect_golden("preview_blocks.txt", text);
  EXPECT_EQ(count(text, "\u2580"), 3U * 8 * 4);
}

TEST(Preview, AWidePictureIsReducedToTheTerminal) {
  const Scene scene = spoiled(100);
  const std::string text = preview_text(scene.test_case, scene.drawing, {.columns = 80, .preview = Preview::kBlocks});
  // 76 columns for three panels and the gaps between them: every fifth pixel.
  EXPECT_EQ(count(text, "\u2580"), 3U * 20 * 10);
}

TEST(Preview, KittyGetsPixelsInChunks) {
  const Scene scene = spoiled(8);
  const std::string text = preview_text(scene.test_case, scene.drawing, {.preview = Preview::kKitty});
  EXPECT_NE(text.find("\x1b_Ga=T,f=24,s=784,v=264,q=2,m=1;"), std::string::npos);
  const size_t bytes = size_t{784} * 264 * 4;  // of base64
  EXPECT_EQ(count(text, "\x1b_G"), (bytes + 4095) / 4096);
  EXPECT_EQ(count(text, "m=0;"), 1U);
  // The border around the panels, whose colour is (96, 100, 110).
  EXPECT_NE(text.find("m=1;YGRuYGRu"), std::string::npos);
}

TEST(Preview, NoneIsAskedForNoneComes) {
  const Scene scene = spoiled(8);
  EXPECT_EQ(preview_text(scene.test_case, scene.drawing, {}), "");
}

}  // namespace
}  // namespace fillrule::terminal
