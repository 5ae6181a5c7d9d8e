#include "renderer/double_double.h"

#include <gtest/gtest.h>

namespace fillrule::renderer {
namespace {

TEST(DoubleDouble, KeepsWhatADoubleLoses) {
  const DoubleDouble sum = DoubleDouble(1e30) + DoubleDouble(1.0) + DoubleDouble(-1e30);
  EXPECT_EQ(sum.high, 1.0);
  const DoubleDouble product = DoubleDouble(1 + 0x1p-52) * DoubleDouble(1 + 0x1p-52) - DoubleDouble(1 + 0x1p-51);
  EXPECT_EQ(product.high, 0x1p-104);
}

TEST(DoubleDouble, ComparesByBothParts) {
  EXPECT_TRUE(DoubleDouble(0, -1e-300) < 0);
  EXPECT_FALSE(DoubleDouble(0, 1e-300) < 0);
  EXPECT_FALSE(DoubleDouble(0) < 0);
  EXPECT_TRUE(DoubleDouble(-1, 0x1p-60) < 0);
}

TEST(DoubleDouble, ScalesByPowersOfTwo) {
  const DoubleDouble value = scaled(DoubleDouble(3, 0x1p-60), -4);
  EXPECT_EQ(value.high, 3.0 / 16);
  EXPECT_EQ(value.low, 0x1p-64);
}

}  // namespace
}  // namespace fillrule::renderer
