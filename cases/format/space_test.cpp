#include "cases/format/space.h"

#include <gtest/gtest.h>

namespace fillrule::format {
namespace {

const RasterState kWhole{
    .viewport = {.x = 0.0F, .y = 0.0F, .width = 64.0F, .height = 64.0F, .minDepth = 0.0F, .maxDepth = 1.0F}};
const RasterState kPart{
    .viewport = {.x = 8.0F, .y = 16.0F, .width = 32.0F, .height = -16.0F, .minDepth = 0.75F, .maxDepth = 0.25F}};

TEST(ClipFrom, ClipIsItself) {
  EXPECT_EQ(clip_from(PositionSpace::kClip, {1, 2, 3, 4}, kPart), (Position{1, 2, 3, 4}));
}

TEST(ClipFrom, NdcIsMultipliedByW) {
  EXPECT_EQ(clip_from(PositionSpace::kNdc, {0.5, -1, 0.25, 4}, kPart), (Position{2, -4, 1, 4}));
}

TEST(ClipFrom, FramebufferInvertsTheViewport) {
  EXPECT_EQ(clip_from(PositionSpace::kFramebuffer, {0, 0, 0, 1}, kWhole), (Position{-1, -1, 0, 1}));
  EXPECT_EQ(clip_from(PositionSpace::kFramebuffer, {64, 64, 1, 1}, kWhole), (Position{1, 1, 1, 1}));
  EXPECT_EQ(clip_from(PositionSpace::kFramebuffer, {10.5, 32, 0.5, 2}, kWhole), (Position{-1.34375, 0, 1, 2}));
  // A negative height has its origin at the bottom, and minDepth may be the greater one.
  EXPECT_EQ(clip_from(PositionSpace::kFramebuffer, {8, 16, 0.75, 1}, kPart), (Position{-1, -1, 0, 1}));
  EXPECT_EQ(clip_from(PositionSpace::kFramebuffer, {40, 0, 0.25, 1}, kPart), (Position{1, 1, 1, 1}));
}

TEST(ClipFrom, OneDepthIsTheMiddleOfNdc) {
  RasterState state = kWhole;
  state.viewport.minDepth = state.viewport.maxDepth = 0.25F;
  EXPECT_EQ(clip_from(PositionSpace::kFramebuffer, {32, 32, 0.25, 2}, state), (Position{0, 0, 1, 2}));
  state.negative_one_to_one = true;
  EXPECT_EQ(clip_from(PositionSpace::kFramebuffer, {32, 32, 0.25, 2}, state), (Position{0, 0, 1, 2}));
}

TEST(ClipFrom, DepthBeginsAtMinusOneIfTheViewVolumeDoes) {
  RasterState state = kPart;
  state.negative_one_to_one = true;
  EXPECT_EQ(clip_from(PositionSpace::kFramebuffer, {8, 16, 0.75, 2}, state), (Position{-2, -2, -2, 2}));
  EXPECT_EQ(clip_from(PositionSpace::kFramebuffer, {8, 16, 0.5, 2}, state), (Position{-2, -2, 0, 2}));
  EXPECT_EQ(clip_from(PositionSpace::kFramebuffer, {8, 16, 0.25, 2}, state), (Position{-2, -2, 2, 2}));
  EXPECT_EQ(clip_from(PositionSpace::kNdc, {0, 0, 0.25, 2}, state), (Position{0, 0, 0.5, 2}));
}

}  // namespace
}  // namespace fillrule::format
