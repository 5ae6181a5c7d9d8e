#include "cases/format/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace fillrule::format {
namespace {

uint32_t bits_of(const Number& number) {
  const auto rounded = to_float32(number);
  EXPECT_TRUE(rounded.has_value());
  return std::bit_cast<uint32_t>(rounded.value_or(0.0F));
}

uint32_t bits_of_text(std::string_view text) {
  EXPECT_TRUE(is_literal(text)) << text;
  const Result<Number> number = parse_literal(text);
  EXPECT_TRUE(number.has_value()) << text;
  return number ? bits_of(*number) : 0;
}

TEST(Number, LiteralsHaveTheirBits) {
  EXPECT_EQ(bits_of_text("0x1.8p-3"), 0x3E400000U);
  EXPECT_EQ(bits_of_text("-0x1.8p-3"), 0xBE400000U);
  EXPECT_EQ(bits_of_text("+0x1p0"), 0x3F800000U);
  EXPECT_EQ(bits_of_text("0x1p-149"), 0x00000001U);
  EXPECT_EQ(bits_of_text("-0x0p0"), 0x80000000U);
  EXPECT_EQ(bits_of_text("bits:0x7f800001"), 0x7F800001U);  // a signaling NaN stays one
  EXPECT_EQ(bits_of_text("bits:0xFFC00001"), 0xFFC00001U);
  EXPECT_EQ(bits_of_text("bits:0x80000000"), 0x80000000U);
  EXPECT_EQ(bits_of_text("nan"), 0x7FC00000U);
  EXPECT_EQ(bits_of_text("-nan"), 0xFFC00000U);
  EXPECT_EQ(bits_of_text("inf"), 0x7F800000U);
  EXPECT_EQ(bits_of_text("+inf"), 0x7F800000U);
  EXPECT_EQ(bits_of_text("-inf"), 0xFF800000U);
}

TEST(Number, WhatIsNoLiteralIsAnExpression) {
  for (const char* text : {"1", "-0", "pi", "nano", "x0", "infinite", "1/0x2"})
    EXPECT_FALSE(is_literal(text)) << text;
}

TEST(Number, MalformedLiteralsAreErrors) {
  for (const char* text : {"bits:", "bits:0x", "bits:0x1ffffffff", "bits:0x7fg", "bits:-0x1", "0x", "0x1p", "0x1 + 1",
                           "0x-1p0", "-0x1.p+-2", "0x1p99999"}) {
    EXPECT_TRUE(is_literal(text)) << text;
    EXPECT_FALSE(parse_literal(text).has_value()) << text;
  }
}

TEST(Number, RoundsOnceToNearestEven) {
  // Halfway between two float32, and the doubles next to that.
  EXPECT_EQ(to_float32({.value = 0x1.000001p0}), 1.0F);
  EXPECT_EQ(to_float32({.value = 0x1.000003p0}), 0x1.000004p0F);
  EXPECT_EQ(to_float32({.value = std::nextafter(0x1.000001p0, 2.0)}), 0x1.000002p0F);
}

TEST(Number, AFiniteNumberBeyondFloat32IsNone) {
  EXPECT_FALSE(to_float32({.value = 0x1.ffffffp127}).has_value());
  EXPECT_EQ(to_float32({.value = 0x1.fffffefp127}), std::numeric_limits<float>::max());
  EXPECT_EQ(to_float32({.value = -std::numeric_limits<double>::infinity()}), -std::numeric_limits<float>::infinity());
}

TEST(Number, FormatIsShortWhereItCanBe) {
  EXPECT_EQ(format_float32(0.1F), "0.1");
  EXPECT_EQ(format_float32(-10.5F), "-10.5");
  EXPECT_EQ(format_float32(64.0F), "64");
  EXPECT_EQ(format_float32(0.0F), "0");
  EXPECT_EQ(format_float32(-0.0F), "-0.0");
  EXPECT_EQ(format_float32(std::numeric_limits<float>::infinity()), "inf");
  EXPECT_EQ(format_float32(-std::numeric_limits<float>::infinity()), "-inf");
  EXPECT_EQ(format_float32(std::numeric_limits<float>::quiet_NaN()), "nan");
  EXPECT_EQ(format_float32(std::bit_cast<float>(0x7F800001U)), "\"bits:0x7f800001\"");
  EXPECT_EQ(format_float32(std::numeric_limits<float>::denorm_min()), "1e-45");
  EXPECT_EQ(format_float32(1e20F), "1e+20");
}

}  // namespace
}  // namespace fillrule::format
