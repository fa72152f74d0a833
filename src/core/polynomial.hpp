#pragma once

#include <initializer_list>
#include <vector>

namespace talus::core {

/// c[0] + c[1] x + c[2] x^2 + ... in the widest hardware precision: products of many factors stay within its range.
struct Polynomial {
  std::vector<long double> c;

  Polynomial(std::initializer_list<long double> coefficients) : c(coefficients) {}
  explicit Polynomial(std::vector<long double> coefficients) : c(std::move(coefficients)) {}
  [[nodiscard]] long double operator()(long double x) const;
};

[[nodiscard]] Polynomial operator*(const Polynomial& a, const Polynomial& b);
[[nodiscard]] Polynomial operator-(const Polynomial& a, const Polynomial& b);

/// All x > 0 at which p changes sign, ascending, to rounding. The roots of the derivative, found the same way, part the
/// positive axis into pieces where p is monotone, so that each piece holds one change or none: no root is missed for
/// lying far out or near another, unless p is zero to rounding all the way between the two.
[[nodiscard]] std::vector<double> positive_roots(const Polynomial& p);

}  // namespace talus::core
