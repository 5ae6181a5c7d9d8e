#include "cases/format/expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "cases/format/expression_functions.h"

namespace fillrule::format {
namespace {

double value_of(Evaluator& evaluator, std::string_view text) {
  const Result<Number> number = evaluator.number(text);
  if (number) return number->value;
  ADD_FAILURE() << to_string(number.error());
  return 0.0;
}

TEST(Expression, ComputesInDouble) {
  Evaluator evaluator;
  evaluator.define("angle", 0.5);
  EXPECT_EQ(value_of(evaluator, "10 + 1/256"), 10.0 + 1.0 / 256.0);
  EXPECT_EQ(value_of(evaluator, "cos(angle)*0.5"), std::cos(0.5) * 0.5);
  EXPECT_EQ(value_of(evaluator, " pi "), std::numbers::pi);
  EXPECT_EQ(value_of(evaluator, "1/3"), 1.0 / 3.0);
  EXPECT_EQ(value_of(evaluator, "angle > 0.25 ? 2 : 3"), 2.0);
  EXPECT_TRUE(std::signbit(value_of(evaluator, "-0")));
}

TEST(Expression, AddsInTheOrderThatIsWritten) {
  Evaluator evaluator;
  evaluator.define("big", 1e16);
  EXPECT_EQ(value_of(evaluator, "1 + big - 1e16"), 0.0);
  EXPECT_EQ(value_of(evaluator, "1 + (big - 1e16)"), 1.0);
}

TEST(Expression, FollowsItsVariables) {
  Evaluator evaluator;
  for (const double x : {1.0, 2.0, 3.0}) {
    evaluator.define("x", x);
    EXPECT_EQ(value_of(evaluator, "2 * x"), 2.0 * x);
  }
  evaluator.undefine("x");
  EXPECT_FALSE(evaluator.number("2 * x").has_value());
  evaluator.define_text("x", "back");
  EXPECT_FALSE(evaluator.number("2 * x").has_value());
  EXPECT_EQ(evaluator.text("$x"), "back");
  evaluator.undefine("x");
  EXPECT_FALSE(evaluator.text("$x").has_value());
  evaluator.define("x", 4.0);
  EXPECT_EQ(value_of(evaluator, "2 * x"), 8.0);
}

TEST(Expression, IsInfiniteOrNanOnlyByAVariable) {
  Evaluator evaluator;
  evaluator.define("x", std::numeric_limits<double>::infinity());
  EXPECT_EQ(value_of(evaluator, "-x"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(value_of(evaluator, "x - x")));
  EXPECT_FALSE(evaluator.number("1 / 0").has_value());
}

TEST(Expression, ComparisonIsNoAssignment) {
  Evaluator evaluator;
  evaluator.define("x", 1.0);
  for (const char* text : {"x == 1", "x != 2", "x <= 1", "x >= 1"}) EXPECT_EQ(value_of(evaluator, text), 1.0) << text;
  for (const char* text : {"x = 1", "=", "x=2"}) EXPECT_FALSE(evaluator.number(text).has_value()) << text;
}

TEST(ExpressionFunctions, Rounding) {
  Evaluator evaluator;
  EXPECT_EQ(value_of(evaluator, "floor(-1.5)"), -2.0);
  EXPECT_EQ(value_of(evaluator, "ceil(-1.5)"), -1.0);
  EXPECT_EQ(value_of(evaluator, "mod(-1, 4)"), 3.0);
  EXPECT_EQ(value_of(evaluator, "mod(7.5, 2)"), 1.5);
}

TEST(ExpressionFunctions, UlpMovesByRepresentableFloat32) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(ulp(1.0, 1.0), double{std::nextafterf(1.0F, 2.0F)});
  EXPECT_EQ(ulp(1.0, -1.0), double{std::nextafterf(1.0F, 0.0F)});
  EXPECT_EQ(ulp(-1.0, 1.0), double{std::nextafterf(-1.0F, 0.0F)});
  EXPECT_EQ(ulp(0.1, 0.0), double{0.1F});
  EXPECT_EQ(ulp(0.0, 1.0), 0x1p-149);
  EXPECT_EQ(ulp(-0.0, 1.0), 0x1p-149);
  EXPECT_EQ(ulp(0x1p-149, -2.0), -0x1p-149);
  EXPECT_EQ(ulp(0x1p-149, -1.0), 0.0);
  EXPECT_TRUE(std::signbit(ulp(-0.0, 0.0)));
  EXPECT_EQ(ulp(double{std::numeric_limits<float>::max()}, 1.0), double{kInfinity});
  EXPECT_EQ(ulp(double{kInfinity}, 5.0), double{kInfinity});
  EXPECT_EQ(ulp(1.0, -1e300), -double{kInfinity});
  EXPECT_TRUE(std::isnan(ulp(std::nan(""), 1.0)));
}

// Case files hold such values: another generator would change the suite.
TEST(ExpressionFunctions, RandomIsThisGenerator) {
  EXPECT_EQ(random_unit(0.0, 0.0), random_unit(-0.0, 0.0));
  EXPECT_EQ(random_unit(1.0, 0.0), 0x1.1aff01849f00ap-1);
  EXPECT_EQ(random_unit(1.0, 1.0), 0x1.4bb0b7e06153ep-1);
  EXPECT_EQ(random_unit(2.0, 1.0), 0x1.5d135c2e59cc0p-4);
  EXPECT_EQ(random_unit(0.5, 1e300), 0x1.d2bf7ac0eec08p-2);
}

TEST(ExpressionFunctions, RandomIsUniformInZeroToOne) {
  constexpr int kDraws = 100000;
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (int k = 0; k < kDraws; ++k) {
    const double value = random_unit(7.0, k);
    ASSERT_GE(value, 0.0);
    ASSERT_LT(value, 1.0);
    sum += value;
    sum_of_squares += value * value;
  }
  EXPECT_NEAR(sum / kDraws, 1.0 / 2.0, 0.005);
  EXPECT_NEAR(sum_of_squares / kDraws, 1.0 / 3.0, 0.005);
}

}  // namespace
}  // namespace fillrule::format
