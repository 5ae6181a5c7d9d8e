// Numbers as unevaluated sums of two doubles, about 106 bits (Dekker 1971; Hida, Li and Bailey 2001).
//
// Clipping needs them: what a triangle with vertices at 1e20 px shows in the viewport is decided by the last of more
// bits than a double has.
#pragma once

#include <cmath>

namespace fillrule::renderer {

struct DoubleDouble {
  double high = 0;
  double low = 0;

  constexpr DoubleDouble() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): every double is one.
  constexpr DoubleDouble(double value) : high(value) {}
  constexpr DoubleDouble(double high_part, double low_part) : high(high_part), low(low_part) {}
};

// The exact sum of two doubles.
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// The same where |a| >= |b|.
inline DoubleDouble quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

inline DoubleDouble operator-(const DoubleDouble& a) {
  return {-a.high, -a.low};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = two_sum(a.high, b.high);
  const DoubleDouble low = two_sum(a.low, b.low);
  const DoubleDouble sum = quick_two_sum(high.high, high.low + low.high);
  return quick_two_sum(sum.high, sum.low + low.low);
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + -b;
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const double product = a.high * b.high;
  const double error = std::fma(a.high, b.high, -product);
  return quick_two_sum(product, error + (a.high * b.low + a.low * b.high));
}

inline bool operator<(const DoubleDouble& a, double b) {
  return a.high < b || (a.high == b && a.low < 0);
}

// Exact but for underflow: a power of two.
inline DoubleDouble scaled(const DoubleDouble& a, int exponent) {
  return {std::ldexp(a.high, exponent), std::ldexp(a.low, exponent)};
}

}  // namespace fillrule::renderer
