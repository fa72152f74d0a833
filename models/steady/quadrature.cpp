#include "steady/quadrature.hpp"

#include <numbers>

namespace talus::steady {

namespace {

/// Nodes: roots of the Legendre polynomial P_n by Newton's method from the Chebyshev-like estimate.
GaussLegendre make_rule() {
  constexpr int n = 2 * GaussLegendre::n_half;
  GaussLegendre rule{};
  for (int i = 0; i < GaussLegendre::n_half; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 0.0;
    for (int k = 0; k < 10; ++k) {
      double before = 1.0, value = x;
      for (int j = 2; j <= n; ++j) {
        const double next = ((2 * j - 1) * x * value - (j - 1) * before) / j;
        before = value, value = next;
      }
      slope = n * (before - x * value) / ((1.0 - x) * (1.0 + x));
      x -= value / slope;
    }
    rule.node[i] = x;
    rule.weight[i] = 2.0 / ((1.0 - x) * (1.0 + x) * slope * slope);
  }
  return rule;
}

}  // namespace

const GaussLegendre& gauss_legendre() {
  static const GaussLegendre rule = make_rule();
  return rule;
}

}  // namespace talus::steady
