#include "renderer/fixed_point.h"

#include <gtest/gtest.h>

namespace fillrule::renderer {
namespace {

TEST(Snap, RoundsTiesToEven) {
  EXPECT_EQ(snap(0.5 / 256, 8), 0);
  EXPECT_EQ(snap(1.5 / 256, 8), 2);
  EXPECT_EQ(snap(2.5 / 256, 8), 2);
  EXPECT_EQ(snap(-0.5 / 256, 8), 0);
  EXPECT_EQ(snap(-1.5 / 256, 8), -2);
  EXPECT_EQ(snap(-2.5 / 256, 8), -2);
}

TEST(Snap, RoundsToNearestBesideTies) {
  EXPECT_EQ(snap(0.5000001 / 256, 8), 1);
  EXPECT_EQ(snap(1.4999999 / 256, 8), 1);
  EXPECT_EQ(snap(-0.5000001 / 256, 8), -1);
}

TEST(Snap, EveryNumberOfBits) {
  for (uint32_t bits = kMinSubpixelBits; bits <= kMaxSubpixelBits; ++bits) {
    const int32_t one = 1 << bits;
    EXPECT_EQ(snap(1.0, bits), one);
    EXPECT_EQ(snap(10 + 1.5 / one, bits), 10 * one + 2);
    EXPECT_EQ(snap(16384.0, bits), 16384 * one);
  }
}

TEST(Snap, ClampsToTheGuardBand) {
  EXPECT_EQ(snap(1e30, 8), 1 << 29);
  EXPECT_EQ(snap(-1e30, 8), -(1 << 29));
  EXPECT_EQ(snap(2097152.0, 8), 1 << 29);
}

TEST(FirstPixel, HoldsCentresInAHalfOpenRange) {
  EXPECT_EQ(first_pixel(0, 128, 8), 0);
  EXPECT_EQ(first_pixel(127, 128, 8), 0);
  EXPECT_EQ(first_pixel(128, 128, 8), 0);  // on the centre
  EXPECT_EQ(first_pixel(129, 128, 8), 1);
  EXPECT_EQ(first_pixel(-128, 128, 8), -1);
  EXPECT_EQ(first_pixel(-127, 128, 8), 0);
  EXPECT_EQ(first_pixel(8, 8, 4), 0);
  EXPECT_EQ(first_pixel(9, 8, 4), 1);
}

}  // namespace
}  // namespace fillrule::renderer
