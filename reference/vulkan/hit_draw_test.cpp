#include "reference/vulkan/hit_draw.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace fillrule::vulkan {
namespace {

using testing::ElementsAre;

constexpr uint32_t kSize = 4;

HitDrawer& drawer() {
  static HitDrawer* const shared = [] {
    Result<HitDrawer> created = HitDrawer::create({.target_size = kSize, .max_vertices = 9, .validation = true});
    if (!created) throw std::runtime_error(to_string(created.error()));
    // Never destroyed; see shared_reference() of test_support.cpp.
    return std::make_unique<HitDrawer>(std::move(*created)).release();
  }();
  return *shared;
}

PlanePosition at(float x, float y) {
  return {x / 2 - 1, y / 2 - 1};
}

std::vector<uint8_t> draw(const std::vector<PlanePosition>& positions, VkCullModeFlags cull_mode = 0) {
  std::vector<uint8_t> hits(size_t{kSize} * kSize, 0xEE);
  const Result<void> drawn = drawer().draw(positions, cull_mode, hits);
  EXPECT_TRUE(drawn.has_value()) << to_string(drawn.error());
  EXPECT_TRUE(drawer().validation_messages().empty());
  return hits;
}

const std::vector<PlanePosition> kClockwise{at(0, 0), at(2, 0), at(0, 2)};
const std::vector<PlanePosition> kCounterClockwise{at(0, 0), at(0, 2), at(2, 0)};

TEST(HitDraw, CountsHitsAndThoseOfFrontFaces) {
  EXPECT_THAT(draw(kClockwise), ElementsAre(1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(draw(kCounterClockwise), ElementsAre(0x11, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
  std::vector<PlanePosition> three = kClockwise;
  three.insert(three.end(), kCounterClockwise.begin(), kCounterClockwise.end());
  three.insert(three.end(), kClockwise.begin(), kClockwise.end());
  EXPECT_EQ(draw(three)[0], 0x13);
}

TEST(HitDraw, CullsAndClears) {
  EXPECT_EQ(draw(kClockwise, VK_CULL_MODE_FRONT_BIT)[0], 1);
  EXPECT_EQ(draw(kClockwise, VK_CULL_MODE_BACK_BIT)[0], 0);
  EXPECT_EQ(draw(kCounterClockwise, VK_CULL_MODE_BACK_BIT)[0], 0x11);
  EXPECT_EQ(draw(kCounterClockwise, VK_CULL_MODE_FRONT_BIT)[0], 0);
}

TEST(HitDraw, RefusesMoreThanThereIsRoomFor) {
  std::vector<uint8_t> hits(size_t{kSize} * kSize);
  EXPECT_FALSE(drawer().draw(std::vector<PlanePosition>(12), 0, hits).has_value());
  EXPECT_FALSE(drawer().draw(kClockwise, 0, std::span(hits).first(3)).has_value());
  EXPECT_FALSE(HitDrawer::create({.target_size = 1U << 20U, .max_vertices = 3}).has_value());
}

}  // namespace
}  // namespace fillrule::vulkan
