// A quotient that is stepped instead of divided again: the error-accumulating kernel of Bresenham's line (1965) and
// of an exact digital differential analyzer. Two divisions at the start, none at a step; no rounding ever.
#pragma once

#include <cstdint>

namespace fillrule::renderer {

// Rounds towards minus infinity; the divisor must be positive.
constexpr int64_t floor_divide(int64_t dividend, int64_t divisor) {
  const int64_t quotient = dividend / divisor;
  return dividend % divisor < 0 ? quotient - 1 : quotient;
}

// floor((dividend + i * step) / divisor) after i steps.
class SteppedQuotient {
 public:
  constexpr SteppedQuotient(int64_t dividend, int64_t step, int64_t divisor)
      : quotient_(floor_divide(dividend, divisor)),
        error_(dividend - quotient_ * divisor),
        quotient_step_(floor_divide(step, divisor)),
        error_step_(step - quotient_step_ * divisor),
        divisor_(divisor) {}

  [[nodiscard]] constexpr int64_t value() const { return quotient_; }

  constexpr void step() {
    quotient_ += quotient_step_;
    error_ += error_step_;
    if (error_ >= divisor_) {
      error_ -= divisor_;
      ++quotient_;
    }
  }

 private:
  int64_t quotient_;
  int64_t error_;  // the remainder, in [0, divisor_)
  int64_t quotient_step_;
  int64_t error_step_;  // likewise
  int64_t divisor_;
};

}  // namespace fillrule::renderer
