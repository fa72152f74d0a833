#include "core/polynomial.hpp"

#include <algorithm>
#include <cmath>

#include "core/bracketed_root.hpp"

namespace talus::core {

namespace {

/// Without zero coefficients at either end, which are roots at infinity and at zero.
Polynomial trimmed(const Polynomial& p) {
  const auto is_zero = [](long double c) { return c == 0.0L; };
  const auto first = std::find_if_not(p.c.begin(), p.c.end(), is_zero);
  const auto last = std::find_if_not(p.c.rbegin(), p.c.rend(), is_zero).base();
  return first < last ? Polynomial(std::vector<long double>(first, last)) : Polynomial{};
}

Polynomial derivative(const Polynomial& p) {
  Polynomial d{};
  for (std::size_t k = 1; k < p.c.size(); ++k) d.c.push_back(static_cast<long double>(k) * p.c[k]);
  return d;
}

/// Logarithms of bounds of all positive roots, Cauchy's with a factor of two to spare.
struct Bounds {
  long double low, high;
};
Bounds bounds(const Polynomial& p) {
  const auto smaller = [](long double a, long double b) { return std::abs(a) < std::abs(b); };
  const long double first = std::abs(p.c.front()), last = std::abs(p.c.back());
  const long double above_first = std::abs(*std::max_element(p.c.begin() + 1, p.c.end(), smaller));
  const long double below_last = std::abs(*std::max_element(p.c.begin(), p.c.end() - 1, smaller));
  return {std::log(0.5L * first / (first + above_first)), std::log(2.0L * (1.0L + below_last / last))};
}

/// log x of the changes of sign: roots may lie many decades apart.
std::vector<long double> sign_changes(const Polynomial& untrimmed) {
  const Polynomial p = trimmed(untrimmed);
  if (p.c.size() < 2) return {};
  const auto [low, high] = bounds(p);
  std::vector<long double> ends;
  for (const long double t : sign_changes(derivative(p)))
    if (t > low && t < high) ends.push_back(t);
  ends.push_back(high);
  const auto at = [&](long double t) { return p(std::exp(t)); };
  std::vector<long double> roots;
  long double left = low;
  for (const long double right : ends) {
    if (at(right) == 0.0L) continue;  // touches zero, or crosses it there: the next piece tells
    if (std::signbit(at(left)) != std::signbit(at(right))) roots.push_back(bracketed_root(at, left, right));
    left = right;
  }
  return roots;
}

}  // namespace

long double Polynomial::operator()(long double x) const {
  long double sum = 0.0L;
  for (auto each = c.rbegin(); each != c.rend(); ++each) sum = sum * x + *each;
  return sum;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial product(std::vector<long double>(a.c.size() + b.c.size() - 1, 0.0L));
  for (std::size_t i = 0; i < a.c.size(); ++i)
    for (std::size_t j = 0; j < b.c.size(); ++j) product.c[i + j] += a.c[i] * b.c[j];
  return product;
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  Polynomial difference(std::vector<long double>(std::max(a.c.size(), b.c.size()), 0.0L));
  std::copy(a.c.begin(), a.c.end(), difference.c.begin());
  for (std::size_t i = 0; i < b.c.size(); ++i) difference.c[i] -= b.c[i];
  return difference;
}

std::vector<double> positive_roots(const Polynomial& p) {
  std::vector<double> roots;
  for (const long double t : sign_changes(p)) roots.push_back(static_cast<double>(std::exp(t)));
  return roots;
}

}  // namespace talus::core
