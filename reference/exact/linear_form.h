// A linear function of the window position, f(dx, dy) = a dx + b dy + c, in double with a certain error bound.
//
// dx and dy are pixels from the viewport's centre. The bound follows the standard model of rounding: every operation
// errs by at most 2^-53 of its result (no operand here can overflow or underflow: float32 inputs enter at most
// fourfold products, 2^-596 to 2^540).
#pragma once

#include <cmath>

namespace fillrule::exact {

struct LinearForm {
  double a = 0;
  double b = 0;
  double c = 0;
  // Bounds of the absolute errors of a, b and c.
  double error_a = 0;
  double error_b = 0;
  double error_c = 0;

  [[nodiscard]] double at(double dx, double dy) const { return a * dx + b * dy + c; }

  // Bounds |at() - exact|, dx and dy taken as exact: the coefficients' errors, two products and two sums (four
  // roundings, each of at most the sum of the absolute terms), and the rounding of this very bound.
  [[nodiscard]] double error_at(double dx, double dy) const {
    const double terms = std::abs(a * dx) + std::abs(b * dy) + std::abs(c);
    return (error_a * std::abs(dx) + error_b * std::abs(dy) + error_c + 0x1p-51 * terms) * (1 + 0x1p-49);
  }

  // How far f moves when the position moves by up to (tx, ty).
  [[nodiscard]] double reach(double tx, double ty) const { return std::abs(a) * tx + std::abs(b) * ty; }
  [[nodiscard]] double reach_error(double tx, double ty) const {
    return (error_a * tx + error_b * ty + 0x1p-51 * reach(tx, ty)) * (1 + 0x1p-49);
  }
};

// Whether x + y is a double, and whether x y is. (Underflow cannot deceive the latter: see above.)
inline bool sum_is_exact(double x, double y) {
  const double sum = x + y;
  const double y_share = sum - x;
  return x - (sum - y_share) == 0 && y - y_share == 0;
}
inline bool product_is_exact(double x, double y) {
  return std::fma(x, y, -(x * y)) == 0;
}

// Whether LinearForm::at() did not round at all: so on short numbers, such as vertices on the subpixel grid, where
// samples lie on edges and no bound can tell zero from nearly zero.
inline bool evaluates_exactly(const LinearForm& form, double dx, double dy) {
  return form.error_a == 0 && form.error_b == 0 && form.error_c == 0 && product_is_exact(form.a, dx) &&
         product_is_exact(form.b, dy) && sum_is_exact(form.a * dx, form.b * dy) &&
         sum_is_exact(form.a * dx + form.b * dy, form.c);
}

// p q - r s with a relative error below 2^-51, whatever cancels (Kahan; proof: Jeannerod, Louvet, Muller, "Further
// analysis of Kahan's algorithm for the accurate computation of 2 x 2 determinants", 2013: at most 1.5 ULP).
inline double difference_of_products(double p, double q, double r, double s) {
  const double rs = r * s;
  const double error = std::fma(-r, s, rs);
  return std::fma(p, q, -rs) + error;
}

// A bound of that function's error: none where nothing is rounded.
inline double difference_error(double p, double q, double r, double s, double result) {
  const bool exact = product_is_exact(p, q) && product_is_exact(r, s) && sum_is_exact(p * q, -(r * s));
  return exact ? 0 : std::abs(result) * 0x1p-51;
}

}  // namespace fillrule::exact
