#pragma once

#include <array>
#include <cmath>

#include "core/errors.hpp"

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

/// Integral of an f >= 0 over [a, b] that is smooth but for its ends, where it may bend or turn sharply. A panel is halved
/// until both halves agree with it to 1e-13 of themselves or 1e-15 of the whole integral. Throws core::Error(solver) where
/// f is not finite, or where some ten thousand panels are not enough.
template <class F>
double integral(F&& f, double a, double b) {
  if (!(a < b)) return 0.0;
  const double estimate = gauss_panel(f, a, b);
  int panels_left = 10000;
  const auto refine = [&](const auto& self, double left_end, double right_end, double whole) -> double {
    const double middle = 0.5 * (left_end + right_end);
    const double left = gauss_panel(f, left_end, middle), right = gauss_panel(f, middle, right_end);
    const double both = left + right, change = std::abs(both - whole);
    if (change <= 1e-13 * both || change <= 1e-15 * estimate) return both;
    if (!std::isfinite(both) || --panels_left < 0)
      throw core::Error(core::ExitCode::solver, "quadrature: the integrand is not finite or not smooth");
    return self(self, left_end, middle, left) + self(self, middle, right_end, right);
  };
  return refine(refine, a, b, estimate);
}

}  // namespace talus::steady
