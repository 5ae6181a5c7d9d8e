#include "reference/vulkan/color_draw.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

namespace fillrule::vulkan {
namespace {

constexpr uint32_t kSize = 4;

const std::vector<ClipPosition> kPositions{{-1, -1, 0, 1}, {-1, 1, 0, 1}, {1, -1, 0, 1}, {1, 1, 0, 1}};
const std::vector<uint32_t> kLeftTriangle{0, 1, 2};

ColorDrawer make(const ColorScene& scene) {
  Result<ColorDrawer> created = ColorDrawer::create({.validation = true}, scene);
  if (!created) throw std::runtime_error(to_string(created.error()));
  return std::move(*created);
}

TEST(ColorDraw, ClearsAndDrawsAndCopies) {
  const std::vector<std::array<float, 4>> attributes(4, {1, 0.5, 0, 1});
  for (const uint32_t samples : {1U, 4U}) {
    const auto drawer = std::make_unique<ColorDrawer>(make({.target_size = kSize,
                                                            .samples = samples,
                                                            .positions_clip = kPositions,
                                                            .attributes = attributes,
                                                            .indices = kLeftTriangle}));
    ASSERT_TRUE(drawer->draw());
    ASSERT_TRUE(drawer->draw());
    const auto picture = drawer->picture();
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->front(), 0xFF0080FFU);
    EXPECT_EQ(picture->back(), 0U);
    EXPECT_TRUE(drawer->validation_messages().empty());
  }
}

TEST(ColorDraw, RefusesAttributesThatDoNotFit) {
  const std::vector<std::array<float, 4>> attributes(3);
  EXPECT_FALSE(
      ColorDrawer::create({}, {.target_size = kSize, .positions_clip = kPositions, .attributes = attributes}));
}

}  // namespace
}  // namespace fillrule::vulkan
