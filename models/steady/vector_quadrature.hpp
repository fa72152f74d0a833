#pragma once

#include <array>
#include <cmath>

#include "core/errors.hpp"
#include "steady/quadrature.hpp"

namespace talus::steady {

/// Integrals of N functions of one variable at once, f(x) -> array of N, over [a, b]: `gauss_legendre` panels, halved until
/// both halves agree with each whole to 1e-11 of the first estimate of that function's absolute value. Throws
/// core::Error(solver) where f is not finite or some thousand panels are not enough.
template <std::size_t N, class F>
std::array<double, N> vector_integral(F&& f, double a, double b) {
  using Values = std::array<double, N>;
  if (!(a < b)) return Values{};
  Values size{};
  const auto& rule = gauss_legendre();
  const auto panel = [&](double from, double to, Values* absolute = nullptr) {
    const double centre = 0.5 * (from + to), half = 0.5 * (to - from);
    Values sum{};
    for (int i = 0; i < GaussLegendre::n_half; ++i)
      for (const double sign : {-1.0, 1.0}) {
        const Values at = f(centre + sign * half * rule.node[i]);
        for (std::size_t k = 0; k < N; ++k) {
          sum[k] += half * rule.weight[i] * at[k];
          if (absolute) (*absolute)[k] += half * rule.weight[i] * std::abs(at[k]);
        }
      }
    return sum;
  };
  const Values estimate = panel(a, b, &size);
  int panels_left = 4000;
  const auto refine = [&](const auto& self, double from, double to, const Values& whole) -> Values {
    const double middle = 0.5 * (from + to);
    const Values left = panel(from, middle), right = panel(middle, to);
    Values both{};
    bool agree = true;
    for (std::size_t k = 0; k < N; ++k) {
      both[k] = left[k] + right[k];
      if (!std::isfinite(both[k])) throw core::Error(core::ExitCode::solver, "quadrature: an integrand is not finite");
      agree = agree && std::abs(both[k] - whole[k]) <= 1e-11 * size[k];
    }
    if (agree) return both;
    if (--panels_left < 0) throw core::Error(core::ExitCode::solver, "quadrature: an integrand is not smooth");
    const Values first = self(self, from, middle, left), second = self(self, middle, to, right);
    for (std::size_t k = 0; k < N; ++k) both[k] = first[k] + second[k];
    return both;
  };
  return refine(refine, a, b, estimate);
}

}  // namespace talus::steady
