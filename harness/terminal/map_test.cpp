#include "harness/terminal/map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/report/printable.h"
#include "harness/terminal/golden.h"
#include "harness/terminal/scene.h"

namespace fillrule::terminal {
namespace {

Scene spoiled(uint32_t size) {
  return draw_scene(size, [size](Planes& candidate, Planes& reference) {
    for (uint32_t x = size / 4; x < size / 2; ++x) lose(candidate, x, size / 4);
    const size_t row = size_t{size / 4 + 1} * size;
    candidate.depth[row + size / 4] = 0.9F;
    candidate.owner[row + size / 4 + 1] = 7;
    candidate.hits[size_t{size} * size - 1] = 1;
    lose(reference, size / 4, size / 4 + 2);
  });
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

TEST(Map, ASmallTargetIsShownWhole) {
  const Scene scene = spoiled(16);
  expect_golden("map_whole.txt", map_text(scene.test_case, scene.drawing, {}));
}

TEST(Map, ALargeTargetIsCroppedToWhatIsWrong) {
  const Scene scene = draw_scene(200, [](Planes& candidate, Planes&) { lose(candidate, 40, 30); });
  const std::string text = map_text(scene.test_case, scene.drawing, {});
  EXPECT_NE(text.find("map of 200 x 200 pixels, cropped to (37, 27) to (43, 33)"), std::string::npos) << text;
  EXPECT_EQ(lines(text).size(), 1U + 7U);
  EXPECT_EQ(lines(text)[4], "       30 ###M###");
}

TEST(Map, WhatIsStillTooLargeIsReducedAndKeepsTheGravest) {
  const Scene scene = spoiled(200);
  const std::string text = map_text(scene.test_case, scene.drawing, {});
  expect_golden("map_reduced.txt", text);
  EXPECT_NE(text.find("reduced: a letter is the gravest of 3 x 3 pixels"), std::string::npos) << text;
}

TEST(Map, ANarrowTerminalIsNotOverrun) {
  const Scene scene = spoiled(64);
  for (const std::string& line : lines(map_text(scene.test_case, scene.drawing, {.columns = 40}))) {
    EXPECT_LE(report::columns_of(line), 40U) << line;
  }
}

TEST(Map, ColoursGoByWhoIsAtFault) {
  const Scene scene = spoiled(16);
  expect_golden("map_colours.txt", map_text(scene.test_case, scene.drawing, {.colour = true}));
}

TEST(Map, ThereIsNoneOfAPictureThatIsRight) {
  const Scene scene = draw_scene(16, [](Planes&, Planes&) {});
  EXPECT_EQ(map_text(scene.test_case, scene.drawing, {}), "");
}

}  // namespace
}  // namespace fillrule::terminal
