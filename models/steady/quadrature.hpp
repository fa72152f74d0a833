#pragma once

#include <array>
#include <cmath>

namespace talus::steady {

/// Gauss-Legendre rule with 20 nodes on [-1, 1]: exact for polynomials up to degree 39. The ten positive nodes.
struct GaussLegendre {
  static constexpr int n_half = 10;
  std::array<double, n_half> node, weight;
};
[[nodiscard]] const GaussLegendre& gauss_legendre();

template <class F>
double gauss_panel(F&& f, double a, double b) {
  const auto& rule = gauss_legendre();
  const double centre = 0.5 * (a + b), half = 0.5 * (b - a);
  double sum = 0.0;
  for (int i = 0; i < GaussLegendre::n_half; ++i)
    sum += rule.weight[i] * (f(centre - half * rule.node[i]) + f(centre + half * rule.node[i]));
  return half * sum;
}

/// Integral of a smooth f >= 0 over [a, b]. A panel is halved until both halves agree with it to 1e-13 of themselves or
/// 1e-15 of the whole integral, at most 14 times: features down to 1e-5 of the interval are resolved, and rounding
/// noise cannot make it run away.
template <class F>
double integral(F&& f, double a, double b) {
  if (!(a < b)) return 0.0;
  const double estimate = gauss_panel(f, a, b);
  const auto refine = [&](const auto& self, double left_end, double right_end, double whole,
                          int halvings_left) -> double {
    const double middle = 0.5 * (left_end + right_end);
    const double left = gauss_panel(f, left_end, middle), right = gauss_panel(f, middle, right_end);
    const double change = std::abs(left + right - whole);
    if (halvings_left == 0 || change <= 1e-13 * std::abs(left + right) || change <= 1e-15 * estimate)
      return left + right;
    return self(self, left_end, middle, left, halvings_left - 1) +
           self(self, middle, right_end, right, halvings_left - 1);
  };
  return refine(refine, a, b, estimate, 14);
}

}  // namespace talus::steady
